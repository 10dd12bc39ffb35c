/* SPDX-License-Identifier: MIT */
/* A trace as an operand of a sub-command: opened, fitted to a board, complained about. */
#ifndef SUPERFRAME_TRACE_FILE_H
#define SUPERFRAME_TRACE_FILE_H

#include <stdbool.h>
#include <stdio.h>

#include "board.h"
#include "trace_reader.h"

/* What the command line says of the board that traces are for. */
struct trace_board {
    bool has_profile, has_base; /* false: the trace's own header is asked first */
    enum board_profile profile;
    uint16_t base;
};

/* Opens a file, or standard input for "-", and begins to read it. STATUS_DONE, with *file to be
 * given to trace_file_close(); else the reason is printed. */
int trace_file_open(const char *path, FILE **file, struct trace_reader *reader);

/* Harmless on NULL. */
void trace_file_close(FILE *file);

/* Makes *desc the board that the trace is for: of the command line where that says so, else of the
 * trace's own header, else the default. STATUS_DONE; else the reason is printed: the two don't
 * agree, or the trace's base is none that the jumper offers. */
int trace_file_fit(const char *path, struct trace_reader *reader, const struct trace_board *board,
                   struct board_desc *desc);

/* Prints what is wrong with a trace and where. Returns STATUS_FAILED if the bus failed that a trace
 * is replayed into, or a read behind the file's first byte, else STATUS_BAD_INPUT. */
int trace_file_complain(const char *path, const struct trace_error *error);

/* The form that a file's name asks for: .txt is text. */
enum trace_format trace_file_format(const char *path);

#endif
