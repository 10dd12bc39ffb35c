/* SPDX-License-Identifier: MIT */
/* The word that a misspelled one may stand for. */
#include "base/nearest.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

enum { WORD_MOST = 40 };

static size_t least_of(size_t a, size_t b) {
    return a < b ? a : b;
}

/* Counts the letters to insert, remove or change, and the neighbours to swap, to make one word of
 * the other. Gives SIZE_MAX if a word is longer than WORD_MOST. */
static size_t distance(const char *a, const char *b) {
    size_t steps[WORD_MOST + 1][WORD_MOST + 1];
    const size_t length_a = strlen(a), length_b = strlen(b);
    if (length_a > WORD_MOST || length_b > WORD_MOST) {
        return SIZE_MAX;
    }
    for (size_t i = 0; i <= length_a; i++) {
        for (size_t j = 0; j <= length_b; j++) {
            if (i == 0 || j == 0) {
                steps[i][j] = i + j;
                continue;
            }
            steps[i][j] = least_of(steps[i - 1][j - 1] + (a[i - 1] != b[j - 1]),
                                   1 + least_of(steps[i - 1][j], steps[i][j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                steps[i][j] = least_of(steps[i][j], 1 + steps[i - 2][j - 2]);
            }
        }
    }
    return steps[length_a][length_b];
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
