/* SPDX-License-Identifier: MIT */
/* Numbers as people write them on a command line, read to the last letter. */
#include "base/numbers.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Reads decimal digits only, up to `most`. strtoul() alone would also take blanks, signs and
 * numbers that are too long. */
static bool whole(const char *text, size_t length, uint64_t most, uint64_t *value) {
    uint64_t sum = 0;
    if (length == 0) {
        return false;
    }
    for (size_t i = 0; i < length; i++) {
        if (!isdigit((unsigned char)text[i])) {
            return false;
        }
        uint64_t digit = (uint64_t)(text[i] - '0');
        if (digit > most || sum > (most - digit) / 10) {
            return false;
        }
        sum = sum * 10 + digit;
    }
    *value = sum;
    return true;
}

bool value_whole(const char *text, uint64_t low, uint64_t high, uint64_t *value) {
    uint64_t number;
    if (!whole(text, strlen(text), high, &number) || number < low) {
        return false;
    }
    *value = number;
    return true;
}

/* Reads one decimal number; *end is the first letter behind the number. */
static bool decimal(const char *text, const char **end, double *value) {
    size_t letters = strspn(text, "0123456789.eE+-");
    char *stop;
    if (letters == 0 || letters > 64) {
        return false;
    }
    errno = 0;
    *value = strtod(text, &stop);
    *end = text + letters;
    return stop == *end && isfinite(*value) && errno == 0;
}

bool value_real(const char *text, double low, double high, double *value) {
    double number, divisor = 1;
    const char *end;
    if (!decimal(text, &end, &number)) {
        return false;
    }
    if (*end == '/' && (!decimal(end + 1, &end, &divisor) || divisor == 0)) {
        return false;
    }
    number /= divisor;
    if (*end != '\0' || !(number >= low && number <= high)) {
        return false;
    }
    *value = number;
    return true;
}

bool value_pair(const char *text, char between, uint64_t low, uint64_t first_most,
                uint64_t second_most, uint64_t *first, uint64_t *second) {
    const char *mark = strchr(text, between);
    uint64_t a, b;
    if (mark == NULL || !whole(text, (size_t)(mark - text), first_most, &a) ||
        !whole(mark + 1, strlen(mark + 1), second_most, &b) || a < low || b < low) {
        return false;
    }
    *first = a;
    *second = b;
    return true;
}

bool value_port(const char *text, uint64_t *value) {
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        text += 2;
    }
    size_t digits = strspn(text, "0123456789abcdefABCDEF");
    bool has_h = (text[digits] == 'h' || text[digits] == 'H') && text[digits + 1] == '\0';
    if (digits == 0 || digits > 4 || (text[digits] != '\0' && !has_h)) {
        return false;
    }
    *value = strtoul(text, NULL, 16);
    return true;
}
