/* SPDX-License-Identifier: MIT */
/* The renderings that `superframe measure` compares: onto the emulated board, and back as dots. */
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "board/port_chain.h"
#include "board_ports.h"
#include "lab/measure/measure.h"
#include "scene/load.h"

static struct scene_overrides overrides_of(const struct measure *measure,
                                           const struct measure_point *point) {
    struct scene_overrides overrides = measure->options->overrides;
    overrides.has_depth = overrides.has_size = true;
    overrides.has_error = point->error > 0;
    overrides.has_threshold = !overrides.has_error;
    overrides.error = point->error;
    overrides.has_model = overrides.has_colour = true;
    overrides.has_estimates = true;
    overrides.estimates = strcmp(point->tail, "estimate") == 0;
    overrides.depth = (int)point->depth;
    overrides.threshold = point->threshold;
    overrides.width = (int)point->width;
    overrides.height = (int)point->height;
    overrides.model = strcmp(point->model, "simple") == 0    ? MODEL_SIMPLE
                      : strcmp(point->model, "fresnel") == 0 ? MODEL_FRESNEL
                                                             : MODEL_WAVELENGTH;
    overrides.colour = strcmp(point->colour, "full") == 0     ? COLOUR_FULL
                       : strcmp(point->colour, "dither") == 0 ? COLOUR_DITHER
                                                              : COLOUR_BITS;
    if (overrides.colour == COLOUR_BITS) {
        overrides.colour_bits = point->colour[sizeof "bits:" - 1] - '0';
    }
    return overrides;
}

/* Copies the part of the screen that was rendered; the caller frees it. NULL: memory is out. */
static uint8_t *cut_out(const uint8_t *screen, unsigned width, unsigned height) {
    uint8_t *rgb = malloc((size_t)width * height * 3);
    for (unsigned y = 0; rgb != NULL && y < height; y++) {
        memcpy(rgb + (size_t)y * width * 3, screen + (size_t)y * PICTURE_WIDTH * 3,
               (size_t)width * 3);
    }
    return rgb;
}

static int draw(struct measure *measure, const struct compiled_scene *compiled,
                struct port_chain *chain, struct measure_point *point) {
    struct scene_error error;
    struct render_totals totals;
    const struct render_job job = {.arithmetic = arithmetic_find_any(point->arithmetic),
                                   .scene = compiled,
                                   .base = BOARD_FACTORY_BASE,
                                   .last_row = compiled->height,
                                   .jobs = measure->options->jobs,
                                   .stop = interrupt_noted(),
                                   .progress = progress_show_sum,
                                   .context = &measure->work};
    struct bus *bound = bus_bind(&chain->hash.bus);
    bool is_rendered = render(&job, &totals, &error);
    (void)bus_bind(bound);
    measure->work.before = measure->work.now;
    if (!is_rendered) {
        return bad_input("%s (--arith %s)", error.text, point->arithmetic);
    }
    const struct cost_events events = {totals.rays, totals.shadow_rays, totals.nodes,
                                       totals.solid_tests};
    point->events = events;
    point->leaked_rays = totals.leaked_rays;
    point->seconds = totals.seconds;
    point->port_writes = port_chain_writes(chain);
    return *interrupt_noted() != 0 ? STATUS_SIGNAL + *interrupt_noted() : STATUS_DONE;
}

int measure_shoot(struct measure *measure, const char *operand, struct measure_point *point,
                  uint8_t **rgb, unsigned *dots) {
    struct scene_error error;
    const struct board_desc desc = board_default_desc(BOARD_1987);
    const struct scene_overrides overrides = overrides_of(measure, point);
    struct compiled_scene *compiled = load_compiled_scene(operand, &overrides, &error);
    *rgb = NULL;
    *dots = board_dots_a_pixel(point->width, point->height);
    if (compiled == NULL) {
        return bad_input("%s", error.text);
    }
    struct port_chain *chain = port_chain_new(&desc, true);
    int status = STATUS_FAILED;
    if (chain != NULL) {
        status = draw(measure, compiled, chain, point);
    }
    if (status == STATUS_DONE) {
        port_chain_picture(chain);
        *rgb = cut_out(chain->rgb, point->width * *dots, point->height * *dots);
    }
    if (chain == NULL || (status == STATUS_DONE && *rgb == NULL)) {
        status = failure("out of memory");
    }
    port_chain_free(chain);
    compiled_scene_free(compiled);
    return status;
}
