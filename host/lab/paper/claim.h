/* SPDX-License-Identifier: MIT */
/* A claim of the paper beside what was measured. */
#ifndef SUPERFRAME_PAPER_CLAIM_H
#define SUPERFRAME_PAPER_CLAIM_H

#include <stdbool.h>
#include <stddef.h>

enum { PAPER_CLAIMS = 9, PAPER_TEXT_SIZE = 2000 };

enum paper_verdict { PAPER_NOT_MEASURED, PAPER_HOLDS, PAPER_HOLDS_IN_PART, PAPER_DOES_NOT_HOLD };

/* One row of the table. */
struct paper_claim {
    const char *title, *says;       /* the claim's subject; what the paper says */
    char measured[PAPER_TEXT_SIZE]; /* what was measured, with the criterion */
    char why[PAPER_TEXT_SIZE];      /* why the claim holds or not */
    enum paper_verdict verdict;
};

/* Returns a verdict in words. */
const char *paper_verdict_text(enum paper_verdict verdict);

#if defined(__GNUC__)
#define PAPER_FORMAT __attribute__((format(printf, 2, 3)))
#else
#define PAPER_FORMAT
#endif

/* Appends to one of a claim's texts, which are PAPER_TEXT_SIZE long. */
void paper_say(char text[PAPER_TEXT_SIZE], const char *format, ...) PAPER_FORMAT;

/* Tells in a word whether a part of a claim holds. */
const char *paper_yes(bool part);

/* Judges a claim of several parts: all of them hold, some or none. Returns STATUS_DONE. */
int paper_judge(struct paper_claim *claim, const bool *parts, size_t count);

#endif
