/* SPDX-License-Identifier: MIT */
/* The command line's options about the board and about traces: good values, wrong ones, and what
 * excludes what. */
#include "options_fixture.h"
#include "trace.h"

/* Refused, and with a message that holds the fragment. */
static const struct {
    const char *line, *fragment;
} refused[] = {
    {"render a --bus ports", "say --yes-these-ports-are-mine"},
    {"render a --yes-these-ports-are-mine", "goes with --bus ports only"},
    {"render a --bus ports --yes-these-ports-are-mine -o b",
     "--output goes with --bus emulator only"},
    {"render a --bus trace:b --native c", "--native goes with --bus emulator only"},
    {"render a --bus trace:b --picture whole", "--picture goes with"},
    {"render a --bus trace:b --faults absent", "--faults goes with"},
    {"render a --picture half", "screen, memory or whole"},
    {"render a --bus-wait -1", "0..100000"},
    {"render a --bus-wait 100001", "0..100000"},
    {"render a --frame-seconds 0", "0.000001..1000000000"},
    {"render a --stop 1", "no option --stop"},
    {"render a --faults=", "lose=N"},
    {"render a --faults lose", "lose=N"},
    {"render a --faults lose=0", "lose=N"},
    {"render a --faults lose=1000000001", "lose=N"},
    {"render a --faults flip=x", "lose=N"},
    {"render a --faults flip-read=", "lose=N"},
    {"render a --faults dead=12345", "dead=PORT"},
    {"render a --faults vanish=0", "vanish=N"},
    {"render a --faults lost", "allowed is: lost with vanish=N"},
    {"render a --faults seed=1,,absent", "with commas between"},
    {"render a --faults absent,", "with commas between"},
    {"render a --faults burning", "with commas between"},
    {"render a --faults seed=11111111111111111111111111111111", "seed=N"},
    {"replay a -o b --stop 0", "1..4294967295"},
    {"trace", "TRACE is missing"},
    {"trace a b", "\"b\" is one too many"},
    {"trace a --to words", "binary or text"},
    {"trace a --compare b --statistics", "--compare goes with"},
    {"trace a --compare b --to text", "--compare goes with"},
    {"trace a --compare b -o c", "--compare goes with"},
    {"trace a --to text --violations", "--to goes with"},
    {"trace a --to text --strict", "--to goes with"},
    {"trace a --to text --native b", "no picture"},
    {"trace a --to text --picture whole", "no picture"},
    {"trace a --list -o -", "standard output"},
    {"trace a --base 01D0", "00D0, 02D0"},
    {"trace a --faults absent", "no option --faults"},
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

static void options_about_the_board(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(
        parse("render a --faults seed=7,lose=10,flip=20,flip-read=30,dead=0xDA,vanish=40,lost "
              "--native b.png --picture whole --bus-wait 0.5 --frame-seconds 3/2",
              &options, &error));
    const struct fault_plan *faults = &options.board.faults;
    assert_true(options.board.has_faults && faults->seed == 7 && faults->lose_one_in == 10);
    assert_true(faults->flip_write_one_in == 20 && faults->flip_read_one_in == 30);
    assert_true(faults->has_dead_port && faults->dead_port == 0x00DA && !faults->is_absent);
    assert_true(faults->vanish_after == 40 && faults->vanish_status == BUS_LOST);
    assert_string_equal(options.board.native, "b.png");
    assert_int_equal(options.board.picture, PICTURE_KIND_WHOLE);
    assert_true(options.board.bus_wait == 0.5 && options.board.frame_seconds == 1.5);
    assert_true(parse("render a --faults absent", &options, &error));
    assert_true(options.board.faults.is_absent);
    assert_true(
        parse("render a --bus ports --yes-these-ports-are-mine --base 02D0", &options, &error));
    assert_int_equal(options.bus.choice, BUS_CHOICE_PORTS);
    assert_true(parse("render a --faults lost --faults vanish=5", &options, &error));
    assert_true(options.board.faults.vanish_after == 5);
    assert_int_equal(options.board.faults.vanish_status, BUS_LOST);
}

static void what_a_trace_is_asked_for(void **state) {
    (void)state;
    struct options options;
    struct options_error error;
    assert_true(parse("trace a", &options, &error));
    assert_false(options.board.has_profile || options.board.has_base || flag_of_option("list"));
    assert_true(parse("trace a --list --statistics --violations --stop 9 -o b.png "
                      "--profile later --base 02D0",
                      &options, &error));
    assert_true(flag_of_option("list") && flag_of_option("statistics") &&
                flag_of_option("violations"));
    assert_true(options.board.has_profile && options.board.has_base && options.board.stop == 9);
    assert_true(parse("trace a --to text -o -", &options, &error));
    assert_true(options.converts && number_of_option("to") == TRACE_TEXT);
    assert_true(parse("trace a --to binary", &options, &error));
    assert_int_equal(number_of_option("to"), TRACE_BINARY);
    assert_true(parse("trace a --compare b", &options, &error));
    assert_string_equal(text_of_option("compare"), "b");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(options_about_the_board),
        cmocka_unit_test(what_a_trace_is_asked_for),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
