/* SPDX-License-Identifier: MIT */
/* The small ways in which a C file is broken: one list of mutations for one file. */
#ifndef SUPERFRAME_TESTS_MUTANTS_OPERATORS_H
#define SUPERFRAME_TESTS_MUTANTS_OPERATORS_H

#include "source.h"

struct mutation {
    const struct source *source;
    size_t start, end; /* the bytes that `text` replaces */
    int line;
    size_t function; /* as of a token */
    char text[64];
    bool is_wrapped; /* `text` goes before the bytes, which stay, and a parenthesis behind these */
};

struct mutations {
    struct mutation *list;
    size_t count, room;
};

/* An enumeration constant and the next one of its enumeration. */
struct sibling {
    char name[64], other[64];
};

struct siblings {
    struct sibling *list;
    size_t count, room;
};

/* Appends a file's enumeration constants to a list. */
void siblings_collect(struct siblings *siblings, const struct source *source);

/* Sorts the constants, for operators_apply(). */
void siblings_sort(struct siblings *siblings);

/* Appends all mutations of a file to a list. Those that are no C any more are among them. */
void operators_apply(struct mutations *mutations, const struct source *source,
                     const struct siblings *siblings);

#endif
