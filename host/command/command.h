/* SPDX-License-Identifier: MIT */
/* The sub-commands of superframe, each of which describes itself at the end of its own file. */
#ifndef SUPERFRAME_COMMAND_H
#define SUPERFRAME_COMMAND_H

#include "base/complain.h"
#include "options/options.h"

#define SUPERFRAME_VERSION "0.1.0"

/* The commands in the order of the help, in lists that make writes; NULL ends each. */
extern const struct command *const commands_built[];
extern const char *const commands_names[];

/* Finds a command; NULL if there is none of that name. */
const struct command *command_find(const char *name);

/* Refuses a command that there is none of, with the one that may be meant. Returns an exit status.
 */
int command_unknown(const char *name);

/* Prints what the program is, its commands and its exit statuses. */
void program_print_help(FILE *out);

#endif
