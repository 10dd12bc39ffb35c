/* SPDX-License-Identifier: MIT */
/* The firmware's pictures made with many rays side by side, for hosts whose CPU has vectors. */
#ifndef SUPERFRAME_STREAM_ENGINE_H
#define SUPERFRAME_STREAM_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "image.h"

/* The most rows that are rendered together: enough rays at once to fill the lanes to the end. */
enum { STREAM_ROWS_MOST = 8 };

/* The alignment of an engine's memory in bytes: a cache line, and the widest vector. */
enum { STREAM_ALIGNMENT = 64 };

/* One arithmetic for one set of CPU instructions. The rows, bit for bit, and the counts are those
 * of the image's own row(). */
struct stream_engine {
    const char *arithmetic; /* a struct arithmetic's name: "f32", or "f32_many" */
    const char *set;        /* "avx2": a struct instruction_set, or "plain", which every CPU runs */
    size_t memory_bytes; /* what rows() works in, all 0 at first: one for each thread and scene */

    /* Tells whether the scene has only what the engine knows. */
    bool (*fits)(const struct scene *scene);

    /* Renders rows first .. first + rows - 1, 1 to STREAM_ROWS_MOST of them, width x 3 bytes each.
     * Returns false where more rays had to wait than there is room for, or a pixel's budget of rays
     * ended. Then rgb holds nothing of use and nothing is added to *counts: render these rows by
     * row(). */
    bool (*rows)(void *memory, const struct scene *scene, uint16_t first, uint16_t rows,
                 uint8_t *rgb, struct render_counts *counts);
};

/* A set of instructions that not every CPU has. */
struct instruction_set {
    const char *name;
    bool (*is_here)(void); /* tells whether this CPU has the set */
};

/* The engines and sets of this build, in lists that make writes; NULL ends each. For an arithmetic,
 * engines go from the plainest to the best. */
extern const struct stream_engine *const stream_engines_built[];
extern const struct instruction_set *const instruction_sets_built[];

/* Finds the best engine that this CPU runs for the arithmetic of that name; NULL if there is
 * none. */
const struct stream_engine *stream_engine_find(const char *arithmetic);

/* Returns engine i of those that this CPU runs for an arithmetic, from the plainest to the best.
 * Returns NULL after the last one. */
const struct stream_engine *stream_engine_get(const char *arithmetic, unsigned i);

#endif
