/* SPDX-License-Identifier: MIT */
/* Reads a sub-command's options by the tables, with getopt_long()'s conventions. */
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "options/options.h"
#include "options/places.h"

enum { ENTRIES_MOST = 48, LETTERS_MOST = 64, LONG_ONLY = 256, MEANT_SIZE = 300 };

/* getopt_long()'s own tables for one sub-command. The value of a long option is LONG_ONLY plus its
 * place among the command's options. */
struct getopt_tables {
    struct option longs[ENTRIES_MOST];
    const char *names[ENTRIES_MOST];
    char letters[LETTERS_MOST];
};

static void make_tables(const struct command *command, struct getopt_tables *tables) {
    const struct option_entry *entry;
    size_t letters = 0;
    memset(tables, 0, sizeof *tables);
    tables->letters[letters++] = ':'; /* a missing value is told from an unknown option */
    for (size_t i = 0; i < ENTRIES_MOST - 1 && (entry = command_option(command, i)) != NULL; i++) {
        struct option *option = &tables->longs[i];
        option->name = tables->names[i] = entry->name;
        option->has_arg = entry->type == OPTION_FLAG  ? no_argument
                          : option_is_optional(entry) ? optional_argument
                                                      : required_argument;
        option->val = LONG_ONLY + (int)i;
        if (entry->letter != 0) {
            tables->letters[letters++] = entry->letter;
            if (entry->type != OPTION_FLAG) {
                tables->letters[letters++] = ':';
            }
        }
    }
}

static const struct option_entry *find_entry(const struct command *command, int found) {
    const struct option_entry *entry = NULL;
    if (found >= LONG_ONLY) {
        return command_option(command, (size_t)(found - LONG_ONLY));
    }
    for (size_t i = 0; (entry = command_option(command, i)) != NULL && entry->letter != found;) {
        i++;
    }
    return entry;
}

static bool take(const struct option_entry *entry, const char *value, struct options *options,
                 struct options_error *error) {
    char allowed[OPTION_ALLOWED_SIZE];
    option_allowed(entry, allowed);
    switch (option_take(entry, value, options)) {
    case VALUE_TAKEN:
        return true;
    case VALUE_WRONG:
        return options_refuse(error, "--%s: \"%.100s\" is invalid; allowed is: %s", entry->name,
                              value, allowed);
    case VALUE_NOT_BUILT:
        break;
    }
    return options_refuse(error, "--%s %.100s: not built into this version; allowed is: %s",
                          entry->name, value, allowed);
}

/* Checks for options that exclude each other in every command. */
static bool check_together(const struct options *options, struct options_error *error) {
    if (options->overrides.has_error && options->overrides.has_threshold) {
        return options_refuse(error,
                              "--error and --threshold exclude each other; give one of them");
    }
    if (options->overrides.has_error && options->overrides.has_estimates &&
        !options->overrides.estimates) {
        return options_refuse(error,
                              "--error and --tail black exclude each other; allowed with --error "
                              "is: --tail estimate");
    }
    if (options->board.faults.vanish_status != BUS_OK && options->board.faults.vanish_after == 0) {
        return options_refuse(error,
                              "--faults lost says how the board vanishes, not when; allowed is: "
                              "lost with vanish=N");
    }
    return true;
}

static bool check_operands(const struct command *command, const struct options *options,
                           struct options_error *error) {
    int count = options->operand_count;
    if (count < command->least) {
        return options_refuse(error, "%s: %s is missing; usage: superframe %s %s [options]",
                              command->name, command->operands, command->name, command->operands);
    }
    if (count > command->most) {
        return options_refuse(
            error, "%s: \"%.100s\" is one too many; usage: superframe %s %s [options]",
            command->name, options->operands[command->most], command->name, command->operands);
    }
    return true;
}

/* ---- What is not known ---------------------------------------------------------------------- */

/* Lists the options that "--s" or "--s=value" may stand for: ", --size, --seed". */
static void list_meant(const struct getopt_tables *tables, const char *culprit,
                       char text[MEANT_SIZE]) {
    const char *begin = culprit + strspn(culprit, "-");
    size_t used = 0, length = strcspn(begin, "=");
    text[0] = '\0';
    for (size_t i = 0; tables->names[i] != NULL && used < MEANT_SIZE; i++) {
        if (strncmp(tables->names[i], begin, length) == 0) {
            used += (size_t)snprintf(text + used, MEANT_SIZE - used, ", --%s", tables->names[i]);
        }
    }
}

/* Finds the option whose name is most like a culprit's, "--dept=3" or "-depth"; NULL if none
 * is. */
static const char *nearest_option(const struct getopt_tables *tables, const char *culprit) {
    char name[64];
    const char *begin = culprit + strspn(culprit, "-");
    (void)snprintf(name, sizeof name, "%.*s", (int)strcspn(begin, "="), begin);
    return nearest_word(name, tables->names);
}

/* Refuses an option that getopt_long() does not know. optopt is the letter of a short option, or
 * the value of a long one that got an argument but takes none. optopt is 0 where no long option has
 * that name, or several begin so. A person who writes "-depth" means "--depth". */
static bool refuse_unknown(const struct command *command, const struct getopt_tables *tables,
                           const char *culprit, struct options_error *error) {
    char meant[MEANT_SIZE] = "";
    if (optopt >= LONG_ONLY) {
        return options_refuse(error, "--%s: takes no value", tables->names[optopt - LONG_ONLY]);
    }
    if (optopt >= '0' && optopt <= '9') {
        return options_refuse(error, "%s: no option -%c, and no number below 0 is allowed",
                              command->name, optopt);
    }
    if (optopt == 0) {
        list_meant(tables, culprit, meant);
    }
    if (meant[0] != '\0') {
        return options_refuse(error, "%s: %.100s is ambiguous; allowed are%s", command->name,
                              culprit, meant + 1);
    }
    bool is_word = optopt == 0 || (strlen(culprit) > 2 && culprit[1] != '-');
    const char *near = is_word ? nearest_option(tables, culprit) : NULL;
    if (near != NULL) {
        return options_refuse(error, "%s: no option %.100s; did you mean --%s?", command->name,
                              culprit, near);
    }
    const char letter[] = {'-', (char)optopt, '\0'};
    return options_refuse(error, "%s: no option %.100s; try superframe %s --help", command->name,
                          optopt == 0 ? culprit : letter, command->name);
}

/* Returns the word that getopt_long() could not take. Amid a word of letters, optind is still at
 * that word, and otherwise behind it. */
static const char *find_culprit(int argc, char **argv) {
    const char *next = optind < argc ? argv[optind] : "";
    if (optopt > 0 && optopt < LONG_ONLY && next[0] == '-' && next[1] == optopt) {
        return next;
    }
    return optind > 0 && optind <= argc ? argv[optind - 1] : "";
}

/* Checks that "-output" was not taken for -o with the value "utput". */
static bool check_dashes(const struct getopt_tables *tables, const struct option_entry *entry,
                         const char *word, struct options_error *error) {
    if (entry->letter == 0 || word[0] != '-' || word[1] == '-') {
        return true;
    }
    for (size_t i = 0; tables->names[i] != NULL; i++) {
        if (strcmp(word + 1, tables->names[i]) == 0) {
            return options_refuse(error, "%s: one dash begins letters; did you mean --%s?", word,
                                  tables->names[i]);
        }
    }
    return true;
}

/* Takes all words of a command line. Returns false with *error filled where one is refused. */
static bool take_words(const struct command *command, int argc, char **argv,
                       struct options *options, struct options_error *error) {
    struct getopt_tables tables;
    int found;
    make_tables(command, &tables);
    opterr = 0; /* the messages are this program's own */
    optind = 0; /* starts afresh: a test parses many command lines */
    while ((found = getopt_long(argc, argv, tables.letters, tables.longs, NULL)) != -1) {
        const char *culprit = find_culprit(argc, argv);
        if (found == ':') {
            return options_refuse(error, "%s: %.100s lacks its value; try superframe %s --help",
                                  command->name, culprit, command->name);
        }
        if (found == '?') {
            return refuse_unknown(command, &tables, culprit, error);
        }
        const struct option_entry *entry = find_entry(command, found);
        if (entry == NULL || !check_dashes(&tables, entry, culprit, error) ||
            !take(entry, optarg, options, error)) {
            return false;
        }
        if (options->help) {
            return true;
        }
    }
    options->operands = argv + optind;
    options->operand_count = argc - optind;
    return check_operands(command, options, error) && check_together(options, error) &&
           (command->check == NULL || command->check(options, error)) &&
           places_are_apart(command, options, error);
}

struct options *options_parse(const struct command *command, int argc, char **argv,
                              struct options_error *error) {
    const struct option_entry *entry;
    struct options *options = calloc(1, command->size > 0 ? command->size : sizeof *options);
    if (options == NULL) {
        (void)options_refuse(error, "out of memory");
        return NULL;
    }
    for (size_t i = 0; (entry = command_option(command, i)) != NULL; i++) {
        option_preset(entry, options);
    }
    if (!take_words(command, argc, argv, options, error)) {
        free(options);
        return NULL;
    }
    return options;
}
