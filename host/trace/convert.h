/* SPDX-License-Identifier: MIT */
/* A trace in its other form. */
#ifndef SUPERFRAME_TRACE_CONVERT_H
#define SUPERFRAME_TRACE_CONVERT_H

#include "options/options.h"

/* superframe trace TRACE --to FORM: writes the trace to -o FILE, or to standard output. Returns an
 * exit status; whatever is wrong is printed. */
int trace_convert(const struct options *options);

#endif
