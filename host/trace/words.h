/* SPDX-License-Identifier: MIT */
/* One access of a trace in words. */
#ifndef SUPERFRAME_TRACE_WORDS_H
#define SUPERFRAME_TRACE_WORDS_H

#include "board.h"
#include "trace.h"

enum { TRACE_WORDS_SIZE = 96 };

/* Says what an access means to a board in the state `before`: "X = 291", "red of (291, 5) = FF".
 * Returns `text`. */
const char *trace_words(char text[TRACE_WORDS_SIZE], const struct board *before,
                        const struct trace_access *access);

/* Returns "control 1", ... "mode" for the register at an offset 0..15 from the base. */
const char *trace_register_name(unsigned offset);

#endif
