/* SPDX-License-Identifier: MIT */
/* The places that a command reads and writes. No two results go to one, none over an input, and no
 * picture over what is none. */
#ifndef SUPERFRAME_PLACES_H
#define SUPERFRAME_PLACES_H

#include "options/options.h"

/* Checks that each result of the command line has a place of its own, from which no input is read.
 * However two names are spelled, they are one place where they lead to the same file, existing or
 * not. Pictures have no ending of another kind, and without --force replace nothing but PNGs and
 * empty files. Devices may be shared (/dev/null), a terminal's standard output may not. False with
 * *error filled where two places clash. */
bool places_are_apart(const struct command *command, const struct options *options,
                      struct options_error *error);

#endif
