/* SPDX-License-Identifier: MIT */
/* Reads a sub-command's options by the table, with getopt_long()'s conventions. */
#include "options/options.h"

#include <getopt.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "options/places.h"

enum { ENTRIES_MOST = 48, LETTERS_MOST = 64, LONG_ONLY = 256 };

static bool refuse(struct options_error *error, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

static bool refuse(struct options_error *error, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

static bool is_optional(const struct option_entry *entry) {
    return entry->value != NULL && entry->value[0] == '[';
}

/* getopt_long()'s own tables for one sub-command. The value of a long option is LONG_ONLY plus
 * its place in option_table, so that the entry can be found again. */
struct getopt_tables {
    struct option longs[ENTRIES_MOST];
    char letters[LETTERS_MOST];
};

static void make_tables(enum command_id command, struct getopt_tables *tables) {
    size_t count = 0, letters = 0;
    memset(tables, 0, sizeof *tables);
    tables->letters[letters++] = ':'; /* a missing value is told from an unknown option */
    for (int i = 0; option_table[i].name != NULL && count < ENTRIES_MOST - 1; i++) {
        const struct option_entry *entry = &option_table[i];
        if ((entry->commands & 1u << command) == 0) {
            continue;
        }
        struct option *option = &tables->longs[count++];
        option->name = entry->name;
        option->has_arg = entry->value == NULL ? no_argument
                          : is_optional(entry) ? optional_argument
                                               : required_argument;
        option->val = LONG_ONLY + i;
        if (entry->letter != 0) {
            tables->letters[letters++] = entry->letter;
            tables->letters[letters++] = ':';
        }
    }
}

static const struct option_entry *find_entry(enum command_id command, int found) {
    if (found >= LONG_ONLY) {
        return &option_table[found - LONG_ONLY];
    }
    for (const struct option_entry *entry = option_table; entry->name != NULL; entry++) {
        if (entry->letter == found && (entry->commands & 1u << command) != 0) {
            return entry;
        }
    }
    return NULL;
}

static bool take(const struct option_entry *entry, const char *value, struct options *options,
                 struct options_error *error) {
    switch (entry->set(options, value)) {
    case VALUE_TAKEN:
        return true;
    case VALUE_WRONG:
        return refuse(error, "--%s: \"%.100s\" is invalid; allowed is: %s", entry->name, value,
                      entry->allowed);
    case VALUE_NOT_BUILT:
        break;
    }
    if (value == NULL || entry->allowed[0] == '\0') {
        return refuse(error, "--%s: not built into this version", entry->name);
    }
    return refuse(error, "--%s %.100s: not built into this version; allowed is: %s", entry->name,
                  value, entry->allowed);
}

static void set_defaults(struct options *options) {
    memset(options, 0, sizeof *options);
    options->arithmetic = "fx";
    options->board.base = BOARD_FACTORY_BASE;
    options->jobs = 1;
    options->instructions_most = OPTIONS_INSTRUCTIONS;
    options->within = 1;
    options->share = 99.9;
}

/* Checks that the bus can do what the options ask for, and that real ports are declared to be the
 * board's. */
static bool check_bus(const struct options *options, struct options_error *error) {
    bool is_ports = options->bus == BUS_CHOICE_PORTS;
    bool is_cable = options->bus == BUS_CHOICE_USB || options->bus == BUS_CHOICE_HID;
    bool is_far = is_ports || is_cable;
    const char *with = options->board.native != NULL                   ? "--native"
                       : options->board.picture != PICTURE_KIND_SCREEN ? "--picture"
                       : options->board.has_faults                     ? "--faults"
                       : is_far && options->output != NULL             ? "--output"
                       : is_far && options->board.strict               ? "--strict"
                                                                       : NULL;
    if (options->bus != BUS_CHOICE_EMULATOR && with != NULL) {
        return refuse(error, "%s goes with --bus emulator only", with);
    }
    if (is_ports && !options->ports_are_mine) {
        return refuse(error, "--bus ports: on a PC these ports are the second DMA controller's; "
                             "where they are the board's, say --yes-these-ports-are-mine");
    }
    if (!is_ports && options->ports_are_mine) {
        return refuse(error, "--yes-these-ports-are-mine goes with --bus ports only");
    }
    if (!is_cable && (options->adapter.waits || options->adapter.verify_percent > 0)) {
        return refuse(error, "--%s goes with --bus usb and --bus hid only",
                      options->adapter.waits ? "wait" : "verify");
    }
    return true;
}

/* Checks that no options of `superframe trace` exclude each other. */
static bool check_trace(enum command_id command, const struct options *options,
                        struct options_error *error) {
    const struct trace_options *tracing = &options->tracing;
    bool tells = tracing->lists || tracing->counts || tracing->judges || options->board.strict;
    if (command != COMMAND_TRACE) {
        return true;
    }
    if (tracing->against != NULL && (tracing->converts || tells || options->output != NULL)) {
        return refuse(error, "--compare goes with --profile and --base only");
    }
    if (tracing->converts && tells) {
        return refuse(error, "--to goes with --profile, --base, --stop and -o only");
    }
    if (tracing->converts &&
        (options->board.native != NULL || options->board.picture != PICTURE_KIND_SCREEN)) {
        return refuse(error, "--to makes a trace, no picture: not with --native or --picture");
    }
    return true;
}

/* Checks that a command has the options without which it has nothing to do. */
static bool check_needs(enum command_id command, const struct options *options,
                        struct options_error *error) {
    static const struct {
        enum command_id command;
        const char *missing;
    } needs[] = {
        {COMMAND_MEASURE, "measure: -o FOLDER is missing"},
        {COMMAND_PAPER, "paper: -o FOLDER is missing"},
        {COMMAND_EXPORT, "export: -o FILE is missing; -o - is standard output"},
        {COMMAND_COMPILE, "compile: -o FILE.c is missing; -o - is standard output"},
        {COMMAND_REPLAY, "replay: -o FILE.png is missing (or --stats or --strict)"},
    };
    if (command == COMMAND_EXPORT && !options->pov) {
        return refuse(error, "export: --pov is missing; it is the only kind of source");
    }
    for (size_t i = 0; i < sizeof needs / sizeof needs[0]; i++) {
        bool has_other =
            command == COMMAND_REPLAY && (options->stats != NULL || options->board.strict);
        if (needs[i].command == command && options->output == NULL && !has_other) {
            return refuse(error, "%s", needs[i].missing);
        }
    }
    return true;
}

/* Checks that no options exclude each other. */
static bool check_together(enum command_id command, const struct options *options,
                           struct options_error *error) {
    if (options->overrides.has_error && options->overrides.has_threshold) {
        return refuse(error, "--error and --threshold exclude each other; give one of them");
    }
    if (options->overrides.has_error && options->overrides.has_estimates &&
        !options->overrides.estimates) {
        return refuse(error,
                      "--error and --tail black exclude each other; allowed with --error is: "
                      "--tail estimate");
    }
    if (options->bus == BUS_CHOICE_TRACE) {
        const char *with = options->output != NULL           ? "--output"
                           : options->trace != NULL          ? "--trace"
                           : options->board.strict           ? "--strict"
                           : options->keep_exposures != NULL ? "--keep-exposures"
                                                             : NULL;
        if (with != NULL) {
            return refuse(error, "%s goes with --bus emulator only; a trace has no board behind it",
                          with);
        }
    }
    if (options->board.faults.vanish_status != BUS_OK && options->board.faults.vanish_after == 0) {
        return refuse(error,
                      "--faults lost says how the board vanishes, not when; allowed is: lost "
                      "with vanish=N");
    }
    if (!check_bus(options, error) || !check_trace(command, options, error)) {
        return false;
    }
    if (command == COMMAND_MEASURE && options->overrides.has_colour &&
        options->overrides.colour == COLOUR_EXPOSURES) {
        return refuse(error, "measure: --colour exposures is not measured; allowed is: full, "
                             "bits:1..bits:8 or dither");
    }
    return true;
}

static bool check_operands(const struct command *command, const struct options *options,
                           struct options_error *error) {
    int count = options->operand_count;
    if (count < command->least) {
        return refuse(error, "%s: %s is missing; usage: superframe %s %s [options]", command->name,
                      command->operands, command->name, command->operands);
    }
    if (count > command->most) {
        return refuse(error, "%s: \"%.100s\" is one too many; usage: superframe %s %s [options]",
                      command->name, options->operands[command->most], command->name,
                      command->operands);
    }
    return true;
}

/* Lists the options that "--s" or "--s=value" may stand for: ", --size, --seed". */
static void list_meant(const struct getopt_tables *tables, const char *culprit, char *text,
                       size_t size) {
    const char *begin = culprit + strspn(culprit, "-");
    size_t used = 0, length = strcspn(begin, "=");
    text[0] = '\0';
    for (const struct option *option = tables->longs; option->name != NULL; option++) {
        if (strncmp(option->name, begin, length) == 0 && used < size) {
            used += (size_t)snprintf(text + used, size - used, ", --%s", option->name);
        }
    }
}

/* Refuses an option that getopt_long() does not know. optopt is the letter of a short option, or
 * the value of a long one that got an argument but takes none. optopt is 0 where no long option has
 * that name, or several begin so. */
static bool refuse_unknown(const char *command, const struct getopt_tables *tables,
                           const char *culprit, struct options_error *error) {
    char meant[300];
    if (optopt >= LONG_ONLY) {
        return refuse(error, "--%s: takes no value", option_table[optopt - LONG_ONLY].name);
    }
    if (optopt >= '0' && optopt <= '9') {
        return refuse(error, "%s: no option -%c, and no number below 0 is allowed", command,
                      optopt);
    }
    if (optopt != 0) {
        return refuse(error, "%s: no option -%c; try superframe %s --help", command, optopt,
                      command);
    }
    list_meant(tables, culprit, meant, sizeof meant);
    if (meant[0] != '\0') {
        return refuse(error, "%s: %.100s is ambiguous; allowed are%s", command, culprit, meant + 1);
    }
    return refuse(error, "%s: no option %.100s; try superframe %s --help", command, culprit,
                  command);
}

bool options_parse(const struct command *command, int argc, char **argv, struct options *options,
                   struct options_error *error) {
    struct getopt_tables tables;
    const enum command_id id = command->id;
    int found;
    make_tables(id, &tables);
    set_defaults(options);
    opterr = 0; /* the messages are this program's own */
    optind = 0; /* starts afresh: a test parses many command lines */
    while ((found = getopt_long(argc, argv, tables.letters, tables.longs, NULL)) != -1) {
        const char *culprit = optind > 0 && optind <= argc ? argv[optind - 1] : "";
        if (found == ':') {
            return refuse(error, "%s: %.100s lacks its value; try superframe %s --help",
                          command->name, culprit, command->name);
        }
        if (found == '?') {
            return refuse_unknown(command->name, &tables, culprit, error);
        }
        const struct option_entry *entry = find_entry(id, found);
        if (entry == NULL || !take(entry, optarg, options, error)) {
            return false;
        }
        if (options->help) {
            return true;
        }
    }
    options->operands = argv + optind;
    options->operand_count = argc - optind;
    return check_operands(command, options, error) && check_together(id, options, error) &&
           check_needs(id, options, error) && places_are_apart(id, options, error);
}

void options_print(FILE *out, enum command_id command) {
    for (const struct option_entry *entry = option_table; entry->name != NULL; entry++) {
        char left[64], letter[8] = "    ";
        if ((entry->commands & 1u << command) == 0 || entry->help == NULL) {
            continue;
        }
        if (entry->letter != 0) {
            (void)snprintf(letter, sizeof letter, "-%c, ", entry->letter);
        }
        (void)snprintf(left, sizeof left, "%s--%s%s%s", letter, entry->name,
                       entry->value == NULL || is_optional(entry) ? "" : " ",
                       entry->value == NULL ? "" : entry->value);
        (void)fprintf(out, "  %-26s %s\n", left, entry->help);
        if (entry->allowed[0] != '\0') {
            (void)fprintf(out, "  %-26s allowed: %s\n", "", entry->allowed);
        }
    }
}
