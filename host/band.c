/* SPDX-License-Identifier: MIT */
/* The choice between a stream engine and the image's own rows. */
#include "band.h"

#include <stdlib.h>

#include "abandon.h"

void band_start(struct band *band, const struct arithmetic *arithmetic, const struct scene *scene) {
    band->image = arithmetic->image;
    band->scene = scene;
    band->engine = stream_engine_find(arithmetic->image->name);
    band->block = NULL;
    band->memory = NULL;
    if (band->engine != NULL && band->engine->fits(scene)) {
        /* Not cleared by hand: most of it is never touched, and so never there. */
        band->block = calloc(1, band->engine->memory_bytes + STREAM_ALIGNMENT);
    }
    if (band->block == NULL) {
        band->engine = NULL;
        return;
    }
    size_t past = (uintptr_t)band->block % STREAM_ALIGNMENT;
    band->memory = (char *)band->block + (past == 0 ? 0 : STREAM_ALIGNMENT - past);
}

/* One piece of the work: by the engine all rows, by the image one. */
struct piece {
    struct band *band;
    const struct band_rows *rows;
    unsigned row; /* of the image's: counted from the first */
    bool is_done; /* the engine took them */
};

static void do_stream(void *context) {
    struct piece *piece = context;
    const struct band_rows *rows = piece->rows;
    piece->is_done =
        piece->band->engine->rows(piece->band->memory, piece->band->scene, (uint16_t)rows->first,
                                  (uint16_t)rows->rows, rows->rgb, rows->counts);
}

static void do_row(void *context) {
    const struct piece *piece = context;
    const struct band_rows *rows = piece->rows;
    piece->band->image->row(piece->band->scene, (uint16_t)(rows->first + piece->row),
                            rows->rgb + piece->row * rows->row_bytes, rows->counts);
}

unsigned band_render(struct band *band, const struct band_rows *rows,
                     const volatile sig_atomic_t *stop) {
    struct piece piece = {.band = band, .rows = rows};
    if (band->engine != NULL && !do_until(stop, do_stream, &piece)) {
        return 0;
    }
    if (piece.is_done) {
        return rows->rows;
    }
    for (; piece.row < rows->rows; piece.row++) {
        const struct render_counts before = *rows->counts;
        if (!do_until(stop, do_row, &piece)) {
            *rows->counts = before;
            break;
        }
    }
    return piece.row;
}

void band_end(struct band *band) {
    free(band->block);
}
