/* SPDX-License-Identifier: MIT */
/* Rows of a picture, several at a time: by streams of rays where that gives the same picture. */
#ifndef SUPERFRAME_BAND_H
#define SUPERFRAME_BAND_H

#include "render/arithmetic.h"
#include "render/engine.h"

enum { BAND_ROWS = STREAM_ROWS_MOST };

/* What one thread needs to render bands. */
struct band {
    const struct image *image;
    const struct scene *scene;
    const struct stream_engine *engine; /* NULL: rows one by one */
    void *block, *memory;               /* what was allocated, and the engine's part of it; NULL */
};

/* Prepares a band for a loaded scene; an estimate that is wanted must have been learned. Where
 * memory for an engine is missing, rows are rendered one by one. */
void band_start(struct band *band, const struct arithmetic *arithmetic, const struct scene *scene);

/* Renders rows first .. first + rows - 1, 1 to BAND_ROWS of them, row_bytes each. */
void band_render(struct band *band, unsigned first, unsigned rows, size_t row_bytes, uint8_t *rgb,
                 struct render_counts *counts);

void band_end(struct band *band);

#endif
