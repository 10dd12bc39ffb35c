/* SPDX-License-Identifier: MIT */
/* The first difference of two traces. */
#include "trace_compare.h"

/* Appends an access of both traces to the context before the difference. */
static void remember(struct trace_difference *difference, const struct trace_access *access) {
    if (difference->before_count == TRACE_CONTEXT) {
        memmove(difference->before, difference->before + 1,
                (TRACE_CONTEXT - 1) * sizeof difference->before[0]);
        difference->before_count--;
    }
    difference->before[difference->before_count++] = *access;
}

/* Reads on after the difference: TRACE_CONTEXT accesses, or fewer if the trace ends. */
static enum trace_status read_on(struct trace_reader *reader, struct trace_difference *difference,
                                 int which) {
    while (difference->after_count[which] <= TRACE_CONTEXT) {
        struct trace_access *access = &difference->after[which][difference->after_count[which]];
        enum trace_status status = trace_reader_next(reader, access);
        if (status == TRACE_END) {
            break;
        }
        if (status != TRACE_OK) {
            difference->failed = which;
            return status;
        }
        difference->after_count[which]++;
    }
    return TRACE_OK;
}

enum trace_status trace_compare(struct trace_reader *const readers[2],
                                struct trace_difference *difference) {
    memset(difference, 0, sizeof *difference);
    difference->failed = -1;
    for (;;) {
        enum trace_status status[2];
        struct trace_access access[2];
        for (int which = 0; which < 2; which++) {
            status[which] = trace_reader_next(readers[which], &access[which]);
            if (status[which] != TRACE_OK && status[which] != TRACE_END) {
                difference->failed = which;
                return status[which];
            }
        }
        if (status[0] == TRACE_END && status[1] == TRACE_END) {
            return TRACE_OK;
        }
        if (status[0] == TRACE_OK && status[1] == TRACE_OK &&
            trace_access_equal(&access[0], &access[1])) {
            difference->access++;
            remember(difference, &access[0]);
            continue;
        }
        difference->is_found = true;
        difference->access++;
        for (int which = 0; which < 2; which++) {
            if (status[which] == TRACE_OK) {
                difference->after[which][0] = access[which];
                difference->after_count[which] = 1;
                status[which] = read_on(readers[which], difference, which);
            }
            if (status[which] != TRACE_OK && status[which] != TRACE_END) {
                return status[which];
            }
        }
        return TRACE_OK;
    }
}
