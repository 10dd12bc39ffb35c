/* SPDX-License-Identifier: MIT */
/* A trace as an operand of a sub-command: opened, fitted to a board, complained about. */
#ifndef SUPERFRAME_TRACE_FILE_H
#define SUPERFRAME_TRACE_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "board.h"
#include "trace_reader.h"

/* The command line's options for the board that traces are for. */
struct trace_board {
    bool has_profile, has_base; /* false: the trace's own header is asked first */
    enum board_profile profile;
    uint16_t base;
};

/* Opens a file, or standard input for "-", and begins to read it. Returns STATUS_DONE, else another
 * status with the reason printed. *file is to be given to trace_file_close(). */
int trace_file_open(const char *path, FILE **file, struct trace_reader *reader);

/* Closes a trace's file, but not standard input; does nothing with NULL. */
void trace_file_close(FILE *file);

/* Makes *desc the board that the trace is for. Profile and base come from the command line if it
 * has them, else from the trace's header, else from the default. Returns STATUS_DONE, else another
 * status with the reason printed. That is: command line and header don't agree, or the jumper does
 * not offer the trace's base. */
int trace_file_fit(const char *path, struct trace_reader *reader, const struct trace_board *board,
                   struct board_desc *desc);

/* Prints what is wrong with a trace and where. Returns STATUS_FAILED if the bus failed that a trace
 * is replayed into, or a read beyond the file's first byte. Returns STATUS_BAD_INPUT otherwise. */
int trace_file_complain(const char *path, const struct trace_error *error);

/* Returns the form that a file's name asks for: text for .txt, else binary. */
enum trace_format trace_file_format(const char *path);

#endif
