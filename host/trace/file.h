/* SPDX-License-Identifier: MIT */
/* A trace as an operand of a sub-command: opened, fitted to a board, complained about. */
#ifndef SUPERFRAME_TRACE_FILE_H
#define SUPERFRAME_TRACE_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "board.h"
#include "board/options.h"
#include "trace_reader.h"

/* Opens a file, or standard input for "-", and begins to read it. Returns STATUS_DONE, else another
 * status with the reason printed. *file is to be given to trace_file_close(). */
int trace_file_open(const char *path, FILE **file, struct trace_reader *reader);

/* Closes a trace's file, but not standard input; does nothing with NULL. */
void trace_file_close(FILE *file);

/* Makes *desc the board that the trace is for. Profile and base come from the command line if it
 * has them, else from the trace's header, else from the default. Returns STATUS_DONE, else another
 * status with the reason printed. That is: command line and header don't agree, or the jumper does
 * not offer the trace's base. */
int trace_file_fit(const char *path, struct trace_reader *reader, const struct board_options *board,
                   struct board_desc *desc);

/* Prints what is wrong with a trace and where. Returns STATUS_FAILED if the bus failed that a trace
 * is replayed into, or a read beyond the file's first byte. Returns STATUS_BAD_INPUT otherwise. */
int trace_file_complain(const char *path, const struct trace_error *error);

#endif
