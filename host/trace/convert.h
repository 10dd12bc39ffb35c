/* SPDX-License-Identifier: MIT */
/* The conversion of a trace into its other form. */
#ifndef SUPERFRAME_TRACE_CONVERT_H
#define SUPERFRAME_TRACE_CONVERT_H

#include "trace/file.h"

/* The trace that is converted, and its new form. */
struct trace_conversion {
    const char *path;   /* "-": standard input */
    const char *output; /* "-": standard output */
    enum trace_format to;
    uint64_t stop;                     /* the last access that is written; 0: all are */
    const struct board_options *board; /* what the command line says of it */
};

/* Writes a trace in the form that is asked for. Returns an exit status; whatever is wrong is
 * printed. */
int trace_convert(const struct trace_conversion *conversion);

#endif
