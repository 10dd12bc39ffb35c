/* SPDX-License-Identifier: MIT */
/* The machines of the tests share the lines of a text trace and their main(), in C and in C++. */
#ifndef SUPERFRAME_TESTS_EMULATORS_TRACED_H
#define SUPERFRAME_TESTS_EMULATORS_TRACED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "checksum.h"

/* One access of a trace: its port, its value as the trace has it, 1 or 2 bytes wide. */
struct traced {
    unsigned port, value, width;
    bool is_read;
};

/* Reads the next access, with comments passed over. Returns false at the end. */
static inline bool next_traced(FILE *trace, struct traced *access) {
    char line[256];
    while (fgets(line, sizeof line, trace) != NULL) {
        char *digits = strchr(line, ' ');
        if (line[0] != '#' && digits != NULL) {
            access->is_read = line[0] == 'i';
            access->width = digits[-1] == '8' ? 1 : 2;
            access->port = (unsigned)strtoul(digits, &digits, 16);
            access->value = (unsigned)strtoul(digits, NULL, 16);
            return true;
        }
    }
    return false;
}

/* Ends the test with the place and the reason, unless it holds. A macro: C and C++ have it. */
#define HOLDS(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);          \
            return false;                                                                          \
        }                                                                                          \
    } while (0)

/* Checks a machine by a trace whose picture has that CRC: the main() of each. Returns the exit
 * status: 0 all holds, 1 something does not, 2 bad usage. */
static inline int check_machine(int count, char **arguments,
                                bool (*check)(FILE *trace, unsigned long crc)) {
    FILE *trace = count == 3 ? fopen(arguments[1], "r") : NULL;
    if (trace == NULL) {
        fprintf(stderr, "usage: machine TRACE CRC\n");
        return 2;
    }
    bool is_good = check(trace, strtoul(arguments[2], NULL, 16));
    fclose(trace);
    return is_good ? 0 : 1;
}

#endif
