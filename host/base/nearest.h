/* SPDX-License-Identifier: MIT */
/* The word that a misspelled one may stand for. */
#ifndef SUPERFRAME_NEAREST_H
#define SUPERFRAME_NEAREST_H

/* Finds the word of a list, ended by NULL, that is the fewest steps away from `word`. A step leaves
 * a letter out, puts one in, takes another one, or swaps two neighbours. Returns NULL if half of
 * the letters would change. */
const char *nearest_word(const char *word, const char *const *words);

#endif
