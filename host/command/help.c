/* SPDX-License-Identifier: MIT */
/* superframe help: the program's help, or that of a sub-command. */
#include "command/command.h"

static int run_help(const struct options *options) {
    if (options->operand_count == 0) {
        program_print_help(stdout);
        return STATUS_DONE;
    }
    const struct command *command = command_find(options->operands[0]);
    if (command == NULL) {
        return command_unknown(options->operands[0]);
    }
    command_print_help(stdout, command);
    return STATUS_DONE;
}

const struct command command_help = {.name = "help",
                                     COMMAND_OPERANDS("[COMMAND]", 0, 1, OPERANDS_NONE),
                                     .summary = "Print this text, or what a command does.",
                                     .groups = OPTION_GROUPS(NULL),
                                     .examples = COMMAND_EXAMPLES("help", "help render"),
                                     .run = run_help};
