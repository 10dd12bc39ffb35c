/* SPDX-License-Identifier: MIT */
/* The list of sub-commands: finds one by name, suggests one for a misspelled name, lists all. */
#include <string.h>

#include "base/nearest.h"
#include "command/command.h"

enum { SUMMARY_COLUMN = 27 };

const struct command *command_find(const char *name) {
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        if (strcmp(commands_built[i]->name, name) == 0) {
            return commands_built[i];
        }
    }
    return NULL;
}

int command_unknown(const char *name) {
    const char *near = nearest_word(name, commands_names);
    return near != NULL ? bad_input("no command \"%.100s\"; did you mean %s?", name, near)
                        : bad_input("no command \"%.100s\"; superframe --help lists them", name);
}

void program_print_help(FILE *out) {
    (void)fputs("superframe renders ray-traced scenes for the SuperFrame board.\n\n"
                "usage: superframe COMMAND ...\n\n",
                out);
    for (size_t i = 0; commands_built[i] != NULL; i++) {
        const struct command *command = commands_built[i];
        int used = fprintf(out, "  %-10s %s", command->name, command->operands);
        (void)fprintf(out, "%*s", used < SUMMARY_COLUMN ? SUMMARY_COLUMN - used : 1, "");
        help_print_wrapped(out, command->summary, SUMMARY_COLUMN, SUMMARY_COLUMN);
    }
    (void)fputs("\nsuperframe help COMMAND says more. superframe --version is the version.\n"
                "Exit status: 0 done, 1 failed while working, 2 bad usage or input,\n"
                "3 a strict check or a comparison did not hold, 130 interrupted.\n\n"
                "For example:\n"
                "  superframe render fig3\n"
                "  superframe help render\n",
                out);
}
