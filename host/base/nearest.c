/* SPDX-License-Identifier: MIT */
/* The word that a misspelled one may stand for. */
#include "base/nearest.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { WORD_MOST = 40 };

/* Counts the letters to insert, remove or change to make one word of the other. Gives SIZE_MAX
 * if a word is longer than WORD_MOST. */
static size_t distance(const char *a, const char *b) {
    size_t row[WORD_MOST + 1];
    size_t length_a = strlen(a), length_b = strlen(b);
    if (length_a > WORD_MOST || length_b > WORD_MOST) {
        return SIZE_MAX;
    }
    for (size_t j = 0; j <= length_b; j++) {
        row[j] = j;
    }
    for (size_t i = 1; i <= length_a; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= length_b; j++) {
            size_t change = diagonal + (a[i - 1] != b[j - 1]);
            size_t shift = 1 + (row[j] < row[j - 1] ? row[j] : row[j - 1]);
            diagonal = row[j];
            row[j] = change < shift ? change : shift;
        }
    }
    return row[length_b];
}

const char *nearest_word(const char *word, const char *const *words) {
    const char *nearest = NULL;
    size_t least = strlen(word) / 2 + 1; /* half of the word may be wrong */
    for (size_t i = 0; words[i]; i++) {
        size_t steps = distance(word, words[i]);
        if (steps < least) {
            least = steps;
            nearest = words[i];
        }
    }
    return nearest;
}
