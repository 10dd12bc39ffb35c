/* SPDX-License-Identifier: MIT */
/* The choice between a stream engine and the image's own rows. */
#include "render/rows.h"

#include <stdlib.h>

void band_start(struct band *band, const struct arithmetic *arithmetic, const struct scene *scene) {
    band->image = arithmetic->image;
    band->scene = scene;
    band->engine = stream_engine_find(arithmetic->name);
    band->block = NULL;
    band->memory = NULL;
    if (band->engine != NULL && band->engine->fits(scene)) {
        /* calloc(), no memset(): most of the block is never touched, and so takes no memory. */
        band->block = calloc(1, band->engine->memory_bytes + STREAM_ALIGNMENT);
    }
    if (band->block == NULL) {
        band->engine = NULL;
        return;
    }
    size_t past = (uintptr_t)band->block % STREAM_ALIGNMENT;
    band->memory = (char *)band->block + (past == 0 ? 0 : STREAM_ALIGNMENT - past);
}

void band_render(struct band *band, unsigned first, unsigned rows, size_t row_bytes, uint8_t *rgb,
                 struct render_counts *counts) {
    if (band->engine != NULL && band->engine->rows(band->memory, band->scene, (uint16_t)first,
                                                   (uint16_t)rows, rgb, counts)) {
        return;
    }
    for (unsigned i = 0; i < rows; i++) {
        band->image->row(band->scene, (uint16_t)(first + i), rgb + i * row_bytes, counts);
    }
}

void band_end(struct band *band) {
    free(band->block);
}
