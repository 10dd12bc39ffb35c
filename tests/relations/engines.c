/* SPDX-License-Identifier: MIT */
/* Relations between ways to draw one scene, bit for bit: streams of rays, threads. */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "relation.h"
#include "render/engine.h"
#include "render/render.h"
#include "trace_hash.h"

enum { BAND_BYTES = 3 * 48 * STREAM_ROWS_MOST };

/* Compares the rows of one engine with the image's own, as far as the engine draws them. */
static void compare_rows(const struct stream_engine *engine, const struct arithmetic *arithmetic,
                         const struct scene *scene, const struct form *form, void *memory,
                         struct trial_result *result) {
    unsigned width = form->compiled->width, height = form->compiled->height;
    for (unsigned first = 0; first < height; first += STREAM_ROWS_MOST) {
        unsigned rows = height - first < STREAM_ROWS_MOST ? height - first : STREAM_ROWS_MOST;
        uint8_t found[BAND_BYTES], expected[BAND_BYTES];
        struct render_counts counts, own;
        memset(&counts, 0, sizeof counts);
        memset(&own, 0, sizeof own);
        if (!engine->rows(memory, scene, (uint16_t)first, (uint16_t)rows, found, &counts)) {
            continue;
        }
        for (unsigned y = 0; y < rows; y++) {
            arithmetic->image->row(scene, (uint16_t)(first + y), expected + 3 * width * y, &own);
        }
        result->pixels += (uint64_t)rows * width;
        result->agreeing += (uint64_t)rows * width;
        if (memcmp(found, expected, 3 * (size_t)width * rows) != 0) {
            result_fail(result, FAULT_BITS, "%s: rows from %u are not the image's own", engine->set,
                        first);
        }
        if (counts.rays != own.rays || counts.shadow_rays != own.shadow_rays ||
            counts.nodes != own.nodes || counts.leaked_rays != own.leaked_rays) {
            result_fail(result, FAULT_BITS, "%s: rows from %u: %u rays, %u of the image's own",
                        engine->set, first, (unsigned)counts.rays, (unsigned)own.rays);
        }
    }
}

void check_streams(struct form *form, int arithmetic, struct rendering *room,
                   struct trial_result *result) {
    const struct arithmetic *own = relation_arithmetic(arithmetic);
    struct scene *scene = own->load(form->compiled, &form->error);
    const struct stream_engine *engine;
    (void)room;
    result->applies = false;
    for (unsigned i = 0; scene && (engine = stream_engine_get(own->image->name, i)) != NULL; i++) {
        void *memory = NULL;
        if (engine->fits(scene) &&
            posix_memalign(&memory, STREAM_ALIGNMENT, engine->memory_bytes) == 0) {
            memset(memory, 0, engine->memory_bytes);
            result->applies = true;
            compare_rows(engine, own, scene, form, memory, result);
        }
        free(memory);
    }
    free(scene);
}

/* One bus is bound at a time, whatever the threads. */
static pthread_mutex_t bus_lock = PTHREAD_MUTEX_INITIALIZER;

/* Hashes the port writes of a render by so many threads; false where it is refused. */
static bool hash_render(const struct form *form, int arithmetic, unsigned jobs, uint64_t *value) {
    struct trace_hash hash;
    struct render_totals totals;
    struct scene_error error;
    struct render_job job;
    memset(&job, 0, sizeof job);
    job.arithmetic = relation_arithmetic(arithmetic);
    job.scene = form->compiled;
    job.base = 0xD0;
    job.last_row = form->compiled->height;
    job.jobs = jobs;
    if (!trace_hash_init(&hash, NULL)) {
        return false;
    }
    (void)pthread_mutex_lock(&bus_lock);
    struct bus *before = bus_bind(&hash.bus);
    bool good = render(&job, &totals, &error);
    (void)bus_bind(before);
    (void)pthread_mutex_unlock(&bus_lock);
    *value = trace_hash_value(&hash);
    trace_hash_free(&hash);
    return good;
}

void check_jobs(struct form *form, int arithmetic, struct rendering *room,
                struct trial_result *result) {
    uint64_t one = 0, several = 0;
    unsigned jobs = 2 + form->compiled->height % 4;
    (void)room;
    result->applies = hash_render(form, arithmetic, 1, &one);
    if (!result->applies) {
        return;
    }
    result->pixels = result->agreeing =
        (uint64_t)form->compiled->width * (uint64_t)form->compiled->height;
    if (!hash_render(form, arithmetic, jobs, &several) || one != several) {
        result_fail(result, FAULT_BITS, "%u jobs: other port writes than those of one", jobs);
    }
}
