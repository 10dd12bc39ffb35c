/* SPDX-License-Identifier: MIT */
/* What the emulators of the tests share, in C and in C++: the lines of a text trace, and the CRC of
 * a picture. */
#ifndef SUPERFRAME_TESTS_EMULATORS_TRACED_H
#define SUPERFRAME_TESTS_EMULATORS_TRACED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* CRC-32 by its definition, bit by bit. */
static inline unsigned long crc_of(const uint8_t *bytes, size_t count) {
    unsigned long crc = 0xFFFFFFFFUL;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        for (unsigned bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (0xEDB88320UL & (0UL - (crc & 1)));
        }
    }
    return crc ^ 0xFFFFFFFFUL;
}

/* Ends the test with the place and the reason, unless it holds. A macro: C and C++ have it. */
#define HOLDS(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition);          \
            return false;                                                                          \
        }                                                                                          \
    } while (0)

#endif
