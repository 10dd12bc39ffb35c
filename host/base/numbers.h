/* SPDX-License-Identifier: MIT */
/* Numbers as people write them on a command line, read to the last letter. */
#ifndef SUPERFRAME_VALUES_H
#define SUPERFRAME_VALUES_H

#include <stdbool.h>
#include <stdint.h>

/* Reads decimal digits only, low..high. Any other text gives false and leaves *value untouched. */
bool value_whole(const char *text, uint64_t low, uint64_t high, uint64_t *value);

/* Reads a decimal number, or a fraction "A/B" of two, low..high. No infinity, no NaN, no
 * hexadecimal digits, no blanks. Any other text gives false and leaves *value untouched. */
bool value_real(const char *text, double low, double high, double *value);

/* Reads "AxB" or another pair with a letter between: A is low..first_most, B low..second_most. */
bool value_pair(const char *text, char between, uint64_t low, uint64_t first_most,
                uint64_t second_most, uint64_t *first, uint64_t *second);

/* Reads up to four hexadecimal digits, with 0x before or h behind if one likes. */
bool value_port(const char *text, uint64_t *value);

#endif
