/* SPDX-License-Identifier: MIT */
/* Relations between ways to draw one scene, bit for bit: streams of rays, sets as lists, threads.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "relation.h"
#include "render/engine.h"
#include "render/render.h"
#include "trace_hash.h"

enum { BAND_BYTES = 3 * 48 * STREAM_ROWS_MOST };

/* Compares rows with those that an image has drawn of the same scene. */
static void compare_rows(const char *name, unsigned first, size_t bytes, const uint8_t *found,
                         const struct render_counts *counts, const uint8_t *expected,
                         const struct render_counts *own, struct trial_result *result) {
    result->pixels += bytes / 3;
    result->agreeing += bytes / 3;
    if (memcmp(found, expected, bytes) != 0) {
        result_fail(result, FAULT_BITS, "%s: rows from %u are not the image's own", name, first);
    }
    if (counts->rays != own->rays || counts->shadow_rays != own->shadow_rays ||
        counts->nodes != own->nodes || counts->leaked_rays != own->leaked_rays) {
        result_fail(result, FAULT_BITS, "%s: rows from %u: %u rays, %u of the image's own", name,
                    first, (unsigned)counts->rays, (unsigned)own->rays);
    }
}

/* Draws rows by an image. */
static void draw_rows(const struct arithmetic *arithmetic, const struct scene *scene,
                      const struct form *form, unsigned first, unsigned rows, uint8_t *rgb,
                      struct render_counts *counts) {
    memset(counts, 0, sizeof *counts);
    for (unsigned y = 0; y < rows; y++) {
        arithmetic->image->row(scene, (uint16_t)(first + y), rgb + 3 * form->compiled->width * y,
                               counts);
    }
}

static unsigned rows_from(const struct form *form, unsigned first) {
    unsigned left = form->compiled->height - first;
    return left < STREAM_ROWS_MOST ? left : STREAM_ROWS_MOST;
}

/* Compares the rows of one engine with the image's own, as far as the engine draws them. */
static void compare_engine(const struct stream_engine *engine, const struct arithmetic *arithmetic,
                           const struct scene *scene, const struct form *form, void *memory,
                           struct trial_result *result) {
    for (unsigned first = 0; first < form->compiled->height; first += STREAM_ROWS_MOST) {
        unsigned rows = rows_from(form, first);
        uint8_t found[BAND_BYTES], expected[BAND_BYTES];
        struct render_counts counts, own;
        memset(&counts, 0, sizeof counts);
        if (engine->rows(memory, scene, (uint16_t)first, (uint16_t)rows, found, &counts)) {
            draw_rows(arithmetic, scene, form, first, rows, expected, &own);
            compare_rows(engine->set, first, 3 * (size_t)form->compiled->width * rows, found,
                         &counts, expected, &own, result);
        }
    }
}

/* Compares all engines of an arithmetic with the image. */
static void compare_engines(const struct arithmetic *own, struct form *form,
                            struct trial_result *result) {
    struct scene *scene = own->load(form->compiled, &form->error);
    const struct stream_engine *engine;
    for (unsigned i = 0; scene && (engine = stream_engine_get(own->name, i)) != NULL; i++) {
        void *memory = NULL;
        if (engine->fits(scene) &&
            posix_memalign(&memory, STREAM_ALIGNMENT, engine->memory_bytes) == 0) {
            memset(memory, 0, engine->memory_bytes);
            result->applies = true;
            compare_engine(engine, own, scene, form, memory, result);
        }
        free(memory);
    }
    free(scene);
}

void check_streams(struct form *form, int arithmetic, struct rendering *room,
                   struct trial_result *result) {
    const struct arithmetic *own = relation_arithmetic(arithmetic);
    const struct arithmetic *many = arithmetic_with_lists(own);
    (void)room;
    result->applies = false;
    if (own->has_room(form->compiled)) {
        compare_engines(own, form, result);
    }
    if (many != NULL && many->has_room(form->compiled)) {
        compare_engines(many, form, result);
    }
}

void check_lists(struct form *form, int arithmetic, struct rendering *room,
                 struct trial_result *result) {
    const struct arithmetic *own = relation_arithmetic(arithmetic);
    const struct arithmetic *many = arithmetic_with_lists(own);
    (void)room;
    result->applies = many != NULL && own->has_room(form->compiled);
    struct scene *bits = result->applies ? own->load(form->compiled, &form->error) : NULL;
    struct scene *lists = bits ? many->load(form->compiled, &form->error) : NULL;
    result->applies = bits != NULL;
    if (bits != NULL && lists == NULL) {
        result_fail(result, FAULT_REFUSED, "lists: %.200s", form->error.text);
    }
    for (unsigned first = 0; lists && first < form->compiled->height; first += STREAM_ROWS_MOST) {
        unsigned rows = rows_from(form, first);
        uint8_t found[BAND_BYTES], expected[BAND_BYTES];
        struct render_counts counts, expected_counts;
        draw_rows(own, bits, form, first, rows, expected, &expected_counts);
        draw_rows(many, lists, form, first, rows, found, &counts);
        compare_rows("lists", first, 3 * (size_t)form->compiled->width * rows, found, &counts,
                     expected, &expected_counts, result);
    }
    free(lists);
    free(bits);
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
