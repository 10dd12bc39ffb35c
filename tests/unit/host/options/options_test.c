/* SPDX-License-Identifier: MIT */
/* The command line: every option's values, good and wrong, and what excludes what. */
#include <stddef.h>

#include "base/numbers.h"
#include "options_fixture.h"

static void defaults(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(parse("render fig3", &options, &error));
    assert_int_equal(options.operand_count, 1);
    assert_string_equal(options.operands[0], "fig3");
    assert_string_equal(options.arithmetic, "fx");
    assert_int_equal(options.bus.choice, BUS_CHOICE_EMULATOR);
    assert_int_equal(options.board.profile, BOARD_1987);
    assert_int_equal(options.board.base, 0x00D0);
    assert_int_equal(options.jobs, 1);
    assert_null(options.output);
    assert_null(options.stats);
    assert_null(options.trace);
    assert_false(options.board.strict || options.quiet || options.json);
    assert_false(options.overrides.has_depth || options.overrides.has_threshold ||
                 options.overrides.has_size || options.overrides.has_model ||
                 options.overrides.has_highlight || options.overrides.has_colour);
    assert_true(parse("compare a b", &options, &error));
    assert_true(*(const double *)member_of("share") == 99.9);
    assert_int_equal(number_of_option("within"), 1);
    assert_null(text_of_option("signatures"));
    assert_true(parse("boot a", &options, &error));
    assert_true(*(const uint64_t *)member_of("instructions") == 200000000000);
    assert_true(parse("paper -o p", &options, &error));
    assert_true(options.overrides.width == 320 && options.overrides.height == 200);
    assert_true(parse("measure -o m", &options, &error));
    assert_null(options.arithmetic);
    assert_true(parse("adapter", &options, &error));
    assert_string_equal(text_of_option("listen"), "127.0.0.1:3240");
}

static void all_options_of_render(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(parse("render --depth 255 fig3 --threshold=1/4096 --size 640x400 -o a.png "
                      "--rows 0:200 --jobs 2 --base 0cd0 --profile later --strict=A --quiet",
                      &options, &error));
    assert_string_equal(options.operands[0], "fig3"); /* options may stand before it */
    assert_int_equal(options.overrides.depth, 255);
    assert_true(options.overrides.threshold == 1.0 / 4096);
    assert_int_equal(options.overrides.width, 640);
    assert_int_equal(options.overrides.height, 400);
    assert_string_equal(options.output, "a.png");
    assert_int_equal(options.jobs, 2);
    assert_int_equal(options.board.base, 0x0CD0);
    assert_int_equal(options.board.profile, BOARD_LATER);
    assert_true(options.board.strict && options.board.has_strict_grade && options.quiet);
    assert_int_equal(options.board.strict_grade, GRADE_ASSUMED);
    assert_true(parse("render fig3 --highlight blinn --arith f64 --tail black", &options, &error));
    assert_int_equal(options.overrides.highlight, HIGHLIGHT_BLINN);
    assert_string_equal(options.arithmetic, "f64");
    assert_true(parse("render fig3 --bus trace:a.trace", &options, &error));
    assert_int_equal(options.bus.choice, BUS_CHOICE_TRACE);
    assert_string_equal(options.bus.file, "a.trace");
    assert_true(parse("render a --colour bits:3 --seed 4294967295", &options, &error));
    assert_int_equal(options.overrides.colour, COLOUR_BITS);
    assert_int_equal(options.overrides.colour_bits, 3);
    assert_true(options.overrides.has_seed && options.overrides.seed == UINT32_MAX);
    assert_true(parse("render a --colour dither", &options, &error));
    assert_int_equal(options.overrides.colour, COLOUR_DITHER);
    assert_true(parse("render a --colour exposures --keep-exposures e", &options, &error));
    assert_int_equal(options.overrides.colour, COLOUR_EXPOSURES);
    assert_string_equal(text_of_option("keep-exposures"), "e");
    assert_true(parse("render --strict -- -fig3", &options, &error));
    assert_true(options.board.strict && !options.board.has_strict_grade);
    assert_string_equal(options.operands[0], "-fig3");
}

/* Options of render with a member that tells whether the option was given. */
static const struct {
    const char *option;
    size_t given;
} tells[] = {
    {"--depth 10", offsetof(struct options, overrides.has_depth)},
    {"--threshold 0", offsetof(struct options, overrides.has_threshold)},
    {"--error 1", offsetof(struct options, overrides.has_error)},
    {"--size 640x400", offsetof(struct options, overrides.has_size)},
    {"--model simple", offsetof(struct options, overrides.has_model)},
    {"--colour full", offsetof(struct options, overrides.has_colour)},
    {"--tail black", offsetof(struct options, overrides.has_estimates)},
    {"--highlight phong", offsetof(struct options, overrides.has_highlight)},
    {"--seed 1", offsetof(struct options, overrides.has_seed)},
    {"--profile 1987", offsetof(struct options, board.has_profile)},
    {"--base 00D0", offsetof(struct options, board.has_base)},
};

/* The default's own value counts as given too. */
static void an_option_that_is_given_tells_so_and_no_other_does(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof tells / sizeof tells[0]; i++) {
        struct options options;
        struct options_error error;
        char line[64];
        (void)snprintf(line, sizeof line, "render a %s", tells[i].option);
        if (!parse(line, &options, &error)) {
            fail_msg("\"%s\": %s", line, error.text);
        }
        for (size_t j = 0; j < sizeof tells / sizeof tells[0]; j++) {
            bool is_given;
            memcpy(&is_given, (const unsigned char *)&options + tells[j].given, sizeof is_given);
            if (is_given != (i == j)) {
                fail_msg("\"%s\": %s counts as %s", line, tells[j].option,
                         is_given ? "given" : "not given");
            }
        }
    }
}

/* Refused, and with a message that holds the fragment. */
static const struct {
    const char *line, *fragment;
} refused[] = {
    {"render", "SCENE is missing"},
    {"render a b", "\"b\" is one too many"},
    {"render a --depth", "--depth lacks its value"},
    {"render a -o", "-o lacks its value"},
    {"render a --depth -1", "a whole number 0..255"},
    {"render a --depth 256", "\"256\" is invalid"},
    {"render a --depth 99999999999999999999", "0..255"},
    {"render a --depth 1.5", "0..255"},
    {"render a --depth 10x", "0..255"},
    {"render a --threshold 1.1", "0..1"},
    {"render a --threshold nan", "0..1"},
    {"render a --threshold inf", "0..1"},
    {"render a --threshold 1/0", "0..1"},
    {"render a --threshold 1e400", "0..1"},
    {"render a --threshold 0x1p-3", "0..1"},
    {"render a --threshold 1/2/3", "0..1"},
    {"render a --threshold -0.5", "0..1"},
    {"render a --size 0x100", "1x1..640x400"},
    {"render a --size 641x400", "1x1..640x400"},
    {"render a --size 640x401", "1x1..640x400"},
    {"render a --size 640", "1x1..640x400"},
    {"render a --size 640X400", "1x1..640x400"},
    {"render a --arith f16", "\"f16\" is invalid; allowed is: fx, f32"},
    {"render a --rows 5:5", "A < B"},
    {"render a --rows 7:5", "A < B"},
    {"render a --rows 0:401", "A < B"},
    {"render a --rows 5", "A < B"},
    {"render a --jobs 0", "1..256"},
    {"render a --base 00D1", "00D0"},
    {"render a --base 100D0", "00D0"},
    {"render a --profile 1999", "1987 or later"},
    {"render a --strict=X", "P, D, S, I or A"},
    {"render a --highlight gouraud", "phong or blinn"},
    {"render a --model glass", "fresnel"},
    {"render a --colour red", "full"},
    {"render a --colour bits", "bits:1..bits:8"},
    {"render a --colour bits:", "bits:1..bits:8"},
    {"render a --colour bits:0", "bits:1..bits:8"},
    {"render a --colour bits:9", "bits:1..bits:8"},
    {"render a --colour bits:4x", "bits:1..bits:8"},
    {"render a --colour dither:2", "dither"},
    {"render a --seed -1", "0..4294967295"},
    {"render a --seed 4294967296", "0..4294967295"},
    {"render a --bus trace:t --keep-exposures e", "--keep-exposures"},
    {"paper", "-o FOLDER is missing"},
    {"paper -o -", "allowed is: a folder's name"},
    {"measure -o -", "allowed is: a folder's name"},
    {"measure -o x --colour exposures", "allowed is: full, bits:1..bits:8 or"},
    {"paper fig3 -o x", "\"fig3\" is one too many"},
    {"paper -o x --depth 3", "no option --depth"},
    {"render a --tail white", "black"},
    {"render a --bus isa", "emulator, trace:FILE"},
    {"render a --bus trace:", "emulator, trace:FILE"},
    {"render a --bus trace", "emulator, trace:FILE"},
    {"render a --frobnicate", "no option --frobnicate"},
    {"render a --s", "--s is ambiguous; allowed are --stats, --signatures, --size, "},
    {"render a --siz=3", "--size: \"3\" is invalid"},
    {"render a --st=3", "--st=3 is ambiguous; allowed are --stats, --strict"},
    {"render a -x", "no option -x"},
    {"tree fig3 -1 5", "no option -1, and no number below 0 is allowed"},
    {"render a --quiet=3", "--quiet: takes no value"},
    {"render a --json", "no option --json"},
    /* Known, but not built into this version. */
    {"render a --bus usb -o x", "--output goes with --bus emulator only"},
    {"render a --bus hid: -o x", "hid[:SERIAL]"},
    {"render a --tail grey", "--tail: \"grey\" is invalid"},
    {"render a --error 0", "--error: \"0\" is invalid"},
    {"render a --error nan", "--error: \"nan\" is invalid"},
    {"render a --error 1 --tail black", "exclude each other"},
    {"render a --verify", "--verify goes with --bus usb and --bus hid only"},
    {"render a --wait", "--wait goes with --bus usb and --bus hid only"},
    /* What excludes what. */
    {"render a --error 1 --threshold 0", "exclude each other"},
    {"render a --threshold 0 --error 1", "exclude each other"},
    {"render a -o - --stats -", "the same place"},
    {"render a -o x --trace x", "the same place"},
    {"render a --bus trace:x --stats x", "the same place"},
    {"render a --bus trace:x -o y", "--output goes with --bus emulator only"},
    {"render a --bus trace:x --trace y", "--trace goes with --bus emulator only"},
    {"render a --bus trace:x --strict", "--strict goes with --bus emulator only"},
    {"compile a", "-o FILE.c is missing"},
    {"compile a -o b --jobs 2", "no option --jobs"},
    {"replay a", "-o FILE.png is missing"},
    {"replay", "TRACE... is missing"},
    {"compare a b --within 256", "0..255"},
    {"compare a b --share 100.1", "0..100"},
    {"scenes fig3", "\"fig3\" is one too many"},
};

static void refusals(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct options options;
        struct options_error error;
        if (parse(refused[i].line, &options, &error)) {
            fail_msg("\"%s\" was not refused", refused[i].line);
        }
        if (strstr(error.text, refused[i].fragment) == NULL) {
            fail_msg("\"%s\": \"%s\" lacks \"%s\"", refused[i].line, error.text,
                     refused[i].fragment);
        }
    }
}

/* ---- The tables ----------------------------------------------------------------------------- */

static void no_command_is_offered_an_option_twice(void **state) {
    (void)state;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_entry *a, *b;
        for (size_t j = 0; (a = command_option(commands_built[i], j)) != NULL; j++) {
            for (size_t k = 0; k < j; k++) {
                b = command_option(commands_built[i], k);
                if (strcmp(a->name, b->name) == 0 || (a->letter != 0 && a->letter == b->letter)) {
                    fail_msg("%s: --%s and --%s", commands_built[i]->name, a->name, b->name);
                }
            }
        }
    }
}

/* Says what is wrong with an option's row; NULL: nothing. */
static const char *fault_of(const struct option_entry *entry) {
    char allowed[OPTION_ALLOWED_SIZE];
    option_allowed(entry, allowed);
    if (entry->help == NULL || entry->help[0] == '\0') {
        return "no help";
    }
    if ((entry->value == NULL) != (entry->type == OPTION_FLAG)) {
        return "a flag with a value, or a value without a name";
    }
    if ((allowed[0] == '\0') != (entry->type == OPTION_FLAG)) {
        return "nothing says what is allowed";
    }
    if ((entry->words == NULL && entry->type == OPTION_WORD) ||
        (entry->words != NULL && entry->type != OPTION_WORD && entry->type != OPTION_OWN) ||
        (entry->set != NULL) != (entry->type == OPTION_OWN)) {
        return "words or a setter that the type does not take";
    }
    bool has_range = entry->type == OPTION_WHOLE || entry->type == OPTION_REAL;
    if (has_range != (entry->most > entry->least) || entry->least < 0) {
        return "a range that the type does not take";
    }
    if (entry->role != ROLE_NONE && entry->size != sizeof(const char *)) {
        return "a file without a name";
    }
    return NULL;
}

static void every_row_says_all_that_its_type_takes(void **state) {
    (void)state;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_entry *entry;
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            size_t own = commands_built[i]->size, size = own > 0 ? own : sizeof(struct options);
            const char *fault =
                entry->offset + entry->size > size ? "a member beyond the struct" : fault_of(entry);
            if (fault != NULL) {
                fail_msg("%s --%s: %s", commands_built[i]->name, entry->name, fault);
            }
        }
    }
}

enum { OWN_MOST = 1024 };

/* Options with room for any command's own. */
static struct options *room;

/* Puts a value into fresh options; the members that may differ are those of the row. */
static bool is_taken(const struct option_entry *entry, const char *value) {
    free(room);
    room = calloc(1, sizeof *room + OWN_MOST);
    assert_non_null(room);
    return option_take(entry, value, room) == VALUE_TAKEN;
}

/* A row says what holds where its option is not given, in words that it takes itself. */
static void every_preset_is_a_value_of_its_own_row(void **state) {
    (void)state;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_entry *entry;
        assert_true(commands_built[i]->size <= sizeof *room + OWN_MOST);
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            if (entry->preset != NULL && !is_taken(entry, entry->preset)) {
                fail_msg("%s --%s: %s", commands_built[i]->name, entry->name, entry->preset);
            }
        }
    }
}

static void whole_numbers_are_taken_to_the_ends_of_their_range(void **state) {
    (void)state;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_entry *entry;
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            char value[32];
            if (entry->type != OPTION_WHOLE) {
                continue;
            }
            (void)snprintf(value, sizeof value, "%.0f", entry->most);
            assert_true(is_taken(entry, value));
            uint64_t stored = 0;
            unsigned narrow = 0;
            if (entry->size == sizeof stored) {
                memcpy(&stored, (const unsigned char *)room + entry->offset, sizeof stored);
            } else {
                assert_int_equal(entry->size, sizeof narrow);
                memcpy(&narrow, (const unsigned char *)room + entry->offset, sizeof narrow);
                stored = narrow;
            }
            assert_true((double)stored >= entry->most && (double)stored <= entry->most);
            (void)snprintf(value, sizeof value, "%.0f", entry->most + 1);
            assert_false(is_taken(entry, value));
            (void)snprintf(value, sizeof value, "%.0f", entry->least);
            assert_true(is_taken(entry, value));
            (void)snprintf(value, sizeof value, "%.0f", entry->least - 1);
            assert_false(is_taken(entry, value));
        }
    }
}

static void words_are_taken_whole_and_nothing_else(void **state) {
    (void)state;
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct option_entry *entry;
        for (size_t j = 0; (entry = command_option(commands_built[i], j)) != NULL; j++) {
            for (size_t k = 0; entry->words != NULL && entry->words[k] != NULL; k++) {
                char other[64];
                assert_true(is_taken(entry, entry->words[k]));
                (void)snprintf(other, sizeof other, "%sx", entry->words[k]);
                assert_false(is_taken(entry, other));
                assert_false(is_taken(entry, ""));
            }
        }
    }
}

/* ---- Slips ---------------------------------------------------------------------------------- */

static void a_slip_is_answered_with_what_may_be_meant(void **state) {
    (void)state;
    static const char *const slips[][2] = {
        {"render a --deepth 3", "did you mean --depth?"},
        {"render a --treshold 0", "did you mean --threshold?"},
        {"render a --colr full", "did you mean --colour?"},
        {"render a -depth 4", "no option -depth; did you mean --depth?"},
        {"render a -size 4x4", "did you mean --size?"},
        {"render a -output b", "-output: one dash begins letters; did you mean --output?"},
        {"render a -ob --qiet", "did you mean --quiet?"},
        {"tree a 1 2 --arithm fx", "did you mean --arith?"},
        {"compare a b --wihtin 3", "did you mean --within?"},
        {"render a -q", "no option -q; try superframe render --help"},
        {"render a --xyzzy", "no option --xyzzy; try superframe render --help"},
    };
    for (size_t i = 0; i < sizeof slips / sizeof slips[0]; i++) {
        struct options options;
        struct options_error error;
        if (parse(slips[i][0], &options, &error)) {
            fail_msg("\"%s\" was taken", slips[i][0]);
        }
        if (strstr(error.text, slips[i][1]) == NULL) {
            fail_msg("\"%s\": \"%s\" lacks \"%s\"", slips[i][0], error.text, slips[i][1]);
        }
    }
}

/* Whatever letter of an option's name is left out, doubled or changed, the name is found again,
 * unless what is left is another option or begins one. */
static void one_wrong_letter_is_forgiven(void **state) {
    (void)state;
    const struct command *command = command_find("render");
    const struct option_entry *entry;
    for (size_t j = 0; (entry = command_option(command, j)) != NULL; j++) {
        size_t length = strlen(entry->name);
        for (size_t at = 1; at < length && length > 4; at++) {
            char line[128], wanted[64];
            struct options options;
            struct options_error error;
            (void)snprintf(line, sizeof line, "render a --%.*sq%s", (int)at, entry->name,
                           entry->name + at + 1);
            (void)snprintf(wanted, sizeof wanted, "did you mean --%s?", entry->name);
            assert_false(parse(line, &options, &error));
            if (strstr(error.text, wanted) == NULL) {
                fail_msg("%s: \"%s\" lacks \"%s\"", line, error.text, wanted);
            }
        }
    }
}

static void a_short_option_is_that_of_the_command(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(parse("compile fig3 -o -", &options, &error));
    assert_string_equal(options.output, "-");
    assert_false(parse("measure -o -", &options, &error));
    assert_string_equal(error.text, "--output: \"-\" is invalid; allowed is: a folder's name");
}

static void help_is_not_refused_for_what_is_lacking(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(parse("render --help", &options, &error));
    assert_true(options.help);
}

static void whole_numbers(void **state) {
    (void)state;
    uint64_t value = 7;
    assert_true(value_whole("0", 0, 5, &value) && value == 0);
    assert_true(value_whole("5", 0, 5, &value) && value == 5);
    assert_true(value_whole("0005", 0, 5, &value) && value == 5);
    assert_true(value_whole("18446744073709551615", 0, UINT64_MAX, &value));
    assert_true(value == UINT64_MAX);
    value = 7;
    static const char *const wrong[] = {
        "", "6", " 1", "1 ", "+1", "-1", "0x1", "1.", "18446744073709551616"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_false(value_whole(wrong[i], 0, 5, &value));
    }
    assert_false(value_whole("18446744073709551616", 0, UINT64_MAX, &value));
    assert_false(value_whole("1", 2, 5, &value));
    assert_true(value == 7);
}

static void real_numbers(void **state) {
    (void)state;
    double value = 7;
    assert_true(value_real("0.25", 0, 1, &value) && value == 0.25);
    assert_true(value_real("1e-3", 0, 1, &value) && value == 1e-3);
    assert_true(value_real("3/8", 0, 1, &value) && value == 0.375);
    assert_true(value_real(".5", 0, 1, &value) && value == 0.5);
    value = 7;
    static const char *const wrong[] = {"",   ".",  "1e", "--1", "nan", "inf", "0x1",   " 1",
                                        "1 ", "1/", "/2", "1/0", "2",   "-1",  "1e999", "1,5"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_false(value_real(wrong[i], 0, 1, &value));
    }
    assert_true(value == 7);
}

static void port_addresses(void **state) {
    (void)state;
    uint64_t value = 7;
    assert_true(value_port("00D0", &value) && value == 0xD0);
    assert_true(value_port("0xd0", &value) && value == 0xD0);
    assert_true(value_port("02D0h", &value) && value == 0x2D0);
    assert_false(value_port("", &value));
    assert_false(value_port("0x", &value));
    assert_false(value_port("D0hh", &value));
    assert_false(value_port("-D0", &value));
    assert_false(value_port("12345", &value));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults),
        cmocka_unit_test(all_options_of_render),
        cmocka_unit_test(an_option_that_is_given_tells_so_and_no_other_does),
        cmocka_unit_test(refusals),
        cmocka_unit_test(help_is_not_refused_for_what_is_lacking),
        cmocka_unit_test(whole_numbers),
        cmocka_unit_test(real_numbers),
        cmocka_unit_test(port_addresses),
        cmocka_unit_test(no_command_is_offered_an_option_twice),
        cmocka_unit_test(every_row_says_all_that_its_type_takes),
        cmocka_unit_test(every_preset_is_a_value_of_its_own_row),
        cmocka_unit_test(whole_numbers_are_taken_to_the_ends_of_their_range),
        cmocka_unit_test(words_are_taken_whole_and_nothing_else),
        cmocka_unit_test(a_slip_is_answered_with_what_may_be_meant),
        cmocka_unit_test(one_wrong_letter_is_forgiven),
        cmocka_unit_test(a_short_option_is_that_of_the_command),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
