/* SPDX-License-Identifier: MIT */
/* The firmware's pictures made with many rays side by side, for hosts whose CPU has vectors. */
#ifndef SUPERFRAME_STREAM_ENGINE_H
#define SUPERFRAME_STREAM_ENGINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "image.h"

/* The rows that are rendered together: enough rays at once to fill the lanes to the end. */
enum { STREAM_ROWS_MOST = 8 };

/* What the memory of an engine has to be aligned to: a cache line, and the widest vector. */
enum { STREAM_ALIGNMENT = 64 };

/* One arithmetic for one set of CPU instructions. Rows come out bit for bit, and counted, as from
 * the image's own row(). */
struct stream_engine {
    const char *name;    /* "f32, AVX2" */
    size_t memory_bytes; /* what rows() works in, all 0 at first: a piece a thread and scene */

    /* Whether the scene has only what the engine knows. */
    bool (*fits)(const struct scene *scene);

    /* Renders rows first .. first + rows - 1, 1 to STREAM_ROWS_MOST of them, width x 3 bytes each.
     * False, with nothing of use in rgb and nothing added to *counts, where more rays had to wait
     * than there is room for, or a pixel's budget of rays ended: render these rows by row(). */
    bool (*rows)(void *memory, const struct scene *scene, uint16_t first, uint16_t rows,
                 uint8_t *rgb, struct render_counts *counts);
};

/* The best engine that this CPU runs for the arithmetic of that name; NULL if there is none. */
const struct stream_engine *stream_engine_find(const char *arithmetic);

/* The engines of an arithmetic that this CPU runs, from the plainest to the best: number i, NULL
 * after the last one. */
const struct stream_engine *stream_engine_get(const char *arithmetic, unsigned i);

#endif
