/* SPDX-License-Identifier: MIT */
/* A band of rows by streams of rays: eye rays go in, what arrives at the eye is summed by pixel. */
#include "render/engine.h"

#include <string.h>

#include "instruction_set.h"
#include "stream/branches.h"
#include "stream/interval.h"
#include "stream/objects.h"
#include "stream/shading.h"
#include "stream/watch.h"

#define STREAM_TEXT(name)          STREAM_TEXT_(name)
#define STREAM_TEXT_(name)         #name
#define STREAM_SYMBOL(real, set)   STREAM_SYMBOL_(real, set)
#define STREAM_SYMBOL_(real, set)  stream_engine_##real##_##set
#define STREAM_JOIN(name, suffix)  STREAM_JOIN_(name, suffix)
#define STREAM_JOIN_(name, suffix) name##suffix
#define STREAM_REAL                STREAM_JOIN(REAL_NAME, SETS_SUFFIX)

/* A pixel's sums lie together, so that a ray's part is one sum of vectors. The sums are one for
 * each primary, in steps of 2^-16 level, and the number of rays. */
enum { PRIMARIES = 3, SUM_OF_RAYS = PRIMARIES, SUMS = PRIMARIES + 1 };

/* How many steps may pass until the pixels' numbers of rays are looked at again. */
enum { STEPS_UNWATCHED = 512 };

struct stream {
    struct hit_lanes hit;
    struct search_lanes search;
    const struct scene *scene;
    struct render_counts counts;
    bool absorbs; /* a material of the scene absorbs */
    struct set_memory memory;
    struct queue queue;
    uint32_t wanted_count;
    uint16_t wanted[TARGET_PIXELS]; /* the pixels of the band that are looked at */
    int64_t sums[TAIL_PLACES * TARGET_PIXELS][SUMS];
    struct ray_lanes *rays;       /* of a step: a block of the queue */
    struct watched_pixels pixels; /* where an accuracy is asked for */
};

/* Returns the watched pixels; NULL where no accuracy is asked for. */
static struct watched_pixels *watched(struct stream *stream) {
    return stream->scene->error > 0 ? &stream->pixels : NULL;
}

/* Starts the rays through the eye for `count` wanted pixels, up to LANES, from `first` on: see
 * camera_ray(). */
static void start_eye_rays(struct stream *stream, uint16_t first_row, uint32_t first,
                           uint32_t count) {
    const struct scene *scene = stream->scene;
    const struct camera camera = scene->camera;
    const uint32_t inside = set_of_eye(&stream->memory, scene);
    struct ray_lanes rays;
    int16_t column[LANES], row[LANES];
    uint32_t wanted[LANES];
    for (uint32_t i = 0; i < LANES; i++) {
        uint32_t pixel = stream->wanted[first + (i < count ? i : 0)];
        column[i] = (int16_t)(2 * (pixel % scene->width) + 1 - scene->width);
        row[i] = (int16_t)(2 * (first_row + pixel / scene->width) + 1 - scene->height);
        wanted[i] = i < count ? 1 : 0;
        rays.target[i] = pixel;
    }
    for (int i = 0; i < LANES; i++) {
        real_wide x = wide_component(camera.forward.x, camera.column.x, column[i], camera.row.x,
                                     row[i], camera.shift);
        real_wide y = wide_component(camera.forward.y, camera.column.y, column[i], camera.row.y,
                                     row[i], camera.shift);
        real_wide z = wide_component(camera.forward.z, camera.column.z, column[i], camera.row.z,
                                     row[i], camera.shift);
        unit_normalise_wide(x, y, z, &rays.direction.x[i], &rays.direction.y[i],
                            &rays.direction.z[i]);
        rays.origin.x[i] = camera.eye.x;
        rays.origin.y[i] = camera.eye.y;
        rays.origin.z[i] = camera.eye.z;
        rays.weight.red[i] = rays.weight.green[i] = rays.weight.blue[i] = REAL_ENERGY(1.0);
        rays.from[i] = LENGTH_EPSILON;
        rays.inside[i] = inside;
        rays.path[i] = path_of(SURFACE_NONE, camera.object, 0);
    }
    const struct ray_columns columns = columns_of(&rays);
    queue_push(&stream->queue, &columns, wanted);
}

/* Adds to each lane's pixel what the lane sends, times its weight, and 1 where its ray is
 * counted. */
static void add_intensities(struct stream *stream, const struct colour_lanes *restrict colour,
                            const struct energy_lanes *restrict weight,
                            const uint32_t counted[restrict LANES]) {
    const bool is_grey = stream->queue.is_grey;
    const real_energy *green = is_grey ? weight->red : weight->green;
    const real_energy *blue = is_grey ? weight->red : weight->blue;
    const uint32_t *target = stream->rays->target;
    int32_t steps[PRIMARIES][LANES], part[LANES][SUMS];
    for (int i = 0; i < LANES; i++) {
        steps[0][i] = colour_steps(colour_scaled(colour->red[i], weight->red[i]));
        steps[1][i] = colour_steps(colour_scaled(colour->green[i], green[i]));
        steps[2][i] = colour_steps(colour_scaled(colour->blue[i], blue[i]));
    }
    /* A loop of its own: gcc puts four rows of words together by vectors, but not four rows of
     * sums. */
    for (int i = 0; i < LANES; i++) {
        part[i][0] = steps[0][i];
        part[i][1] = steps[1][i];
        part[i][2] = steps[2][i];
        part[i][SUM_OF_RAYS] = (int32_t)counted[i];
    }
    for (int i = 0; i < LANES; i++) {
        int64_t *restrict sum = stream->sums[target[i] & ~TARGET_CONTINUED];
        for (int k = 0; k < SUMS; k++) {
            sum[k] += part[i][k];
        }
    }
}

/* Sets `counted` to 1 in the lanes whose rays are new ones, and counts these rays. */
static void count_rays(struct stream *stream, uint32_t count, uint32_t counted[restrict LANES]) {
    const uint32_t *restrict target = stream->rays->target;
    uint32_t rays = 0;
    for (uint32_t i = 0; i < LANES; i++) {
        bool is_new = (i < count) & ((target[i] & TARGET_CONTINUED) == 0);
        counted[i] = is_new ? 1 : 0;
        rays += counted[i];
    }
    stream->counts.rays += rays;
}

static void find_crossings(struct stream *stream, uint32_t count) {
    struct search_lanes *restrict search = &stream->search;
    const struct ray_lanes *restrict rays = stream->rays;
    search->scene = stream->scene;
    search->shadows = false;
    copy_points(&search->world.origin, &rays->origin);
    copy_directions(&search->world.direction, &rays->direction);
    for (uint32_t i = 0; i < LANES; i++) {
        search->surface[i] = path_surface(rays->path[i]);
        search->inside[i] = rays->inside[i];
        search->from[i] = rays->from[i];
        search->active[i] = i < count ? 1 : 0;
    }
    search_begin(search, &stream->memory);
    search_next(search, &stream->counts.solid_tests);
}

/* Sends the rays on that have crossed no boundary between materials. */
static void go_on(struct stream *stream, const uint32_t continuing[LANES]) {
    const struct ray_lanes *restrict rays = stream->rays;
    struct ray_columns next = columns_of(rays);
    uint32_t path[LANES], target[LANES];
    for (int i = 0; i < LANES; i++) {
        path[i] =
            path_of(path_surface(rays->path[i]), stream->hit.after[i], path_events(rays->path[i]));
        target[i] = rays->target[i] | TARGET_CONTINUED;
    }
    next.from = stream->search.t;
    next.inside = stream->hit.inside_after;
    next.path = path;
    next.target = target;
    queue_push(&stream->queue, &next, continuing);
}

/* Sorts the lanes: at a boundary between materials, on between boundaries, or out of the scene. */
static void sort_lanes(struct stream *stream, uint32_t continuing[LANES], uint32_t gone[LANES]) {
    struct hit_lanes *restrict hit = &stream->hit;
    const struct search_lanes *restrict search = &stream->search;
    for (int i = 0; i < LANES; i++) {
        hit->inside_after[i] = search_behind(search, i);
    }
    media_before(&stream->memory, stream->rays, hit->before);
    media_objects(&stream->memory, stream->scene, hit->inside_after, hit->after);
    media_materials(stream->scene, hit->before, hit->material_before);
    media_materials(stream->scene, hit->after, hit->material_after);
    uint32_t nodes = 0, leaked = 0;
    for (int i = 0; i < LANES; i++) {
        bool found = search->place[i] != PLACE_NONE;
        bool same = hit->material_before[i] == hit->material_after[i];
        uint32_t active = search->active[i];
        hit->is[i] = (found & !same) ? active : 0;
        continuing[i] = (found & same) ? active : 0;
        gone[i] = found ? 0 : active;
        nodes += hit->is[i];
        leaked += hit->before[i] != OBJECT_AIR ? gone[i] : 0;
    }
    stream->counts.nodes += nodes;
    stream->counts.leaked_rays += leaked;
}

/* Attenuates one primary on the path to the boundary (Lambert-Bouguer): attenuated() of
 * firmware/growth.c. */
static void attenuate(const struct stream *stream, int primary, real_energy weight[LANES]) {
    for (int i = 0; i < LANES; i++) {
        const struct material *medium = &stream->scene->materials[stream->hit.material_before[i]];
        if (stream->hit.is[i] && medium->absorbs) {
            weight[i] = energy_product(
                weight[i], energy_transmitted(medium->absorption[primary], stream->hit.t[i]));
        }
    }
}

static void absorb(struct stream *stream) {
    attenuate(stream, 0, stream->rays->weight.red);
    if (!stream->queue.is_grey) {
        attenuate(stream, 1, stream->rays->weight.green);
        attenuate(stream, 2, stream->rays->weight.blue);
    }
}

/* Adds the estimated radiance of the pruned branches, as cut_radiance() of firmware/growth.c does.
 */
static void add_estimate(struct stream *stream, const struct cut_lanes *cut) {
    const struct estimate *estimate = stream->scene->estimate;
    const uint32_t uncounted[LANES] = {0};
    struct colour_lanes worth;
    for (int i = 0; i < LANES; i++) {
        const int32_t *steps = estimate->mean[cut->way[i]];
        worth.red[i] = colour_of_steps(steps[0]);
        worth.green[i] = colour_of_steps(steps[1]);
        worth.blue[i] = colour_of_steps(steps[2]);
    }
    add_intensities(stream, &worth, &cut->weight, uncounted);
}

static void set_black(struct colour_lanes *restrict colour) {
    for (int i = 0; i < LANES; i++) {
        colour->red[i] = colour->green[i] = colour->blue[i] = REAL_COLOUR(0.0);
    }
}

/* Adds what arrives from the scene's background, or from the boundary. */
static void add_arrivals(struct stream *stream, const struct colour_lanes *local,
                         const uint32_t gone[LANES], const uint32_t counted[LANES]) {
    const struct colours background = stream->scene->background;
    const real_colour black = REAL_COLOUR(0.0);
    struct colour_lanes colour;
    for (int i = 0; i < LANES; i++) {
        bool is_gone = gone[i] != 0, is_hit = stream->hit.is[i] != 0;
        colour.red[i] = is_gone ? background.red : is_hit ? local->red[i] : black;
        colour.green[i] = is_gone ? background.green : is_hit ? local->green[i] : black;
        colour.blue[i] = is_gone ? background.blue : is_hit ? local->blue[i] : black;
    }
    add_intensities(stream, &colour, &stream->rays->weight, counted);
}

/* Absorbs, shades and splits the rays that have come to a boundary; *local gets what boundaries
 * send. What the search has found is lost to the shadows. */
static void meet_boundaries(struct stream *stream, struct colour_lanes *local) {
    struct boundary_lanes boundary;
    struct cut_lanes cut[2];
    hits_describe(&stream->search, &stream->hit);
    if (stream->absorbs) {
        absorb(stream);
    }
    boundaries_find(stream->scene, &stream->hit, &boundary);
    shading_local(stream->scene, &stream->rays->direction, &stream->hit, &boundary, local,
                  &stream->search, &stream->memory, &stream->counts);
    children_grow(stream->scene, stream->rays, &stream->hit, &boundary, watched(stream),
                  &stream->queue, cut);
    if (stream->scene->estimate && watched(stream) == NULL) {
        add_estimate(stream, &cut[0]);
        add_estimate(stream, &cut[1]);
    }
}

/* Follows the rays of the first `count` lanes of a block to their next crossing. */
static void step(struct stream *stream, uint32_t count) {
    uint32_t counted[LANES], continuing[LANES], gone[LANES];
    struct colour_lanes local;
    count_rays(stream, count, counted);
    find_crossings(stream, count);
    sort_lanes(stream, continuing, gone);
    if (lanes_any(continuing)) {
        go_on(stream, continuing);
    }
    if (lanes_any(stream->hit.is)) {
        meet_boundaries(stream, &local);
    } else {
        set_black(&local);
    }
    add_arrivals(stream, &local, gone, counted);
}

static bool scene_absorbs(const struct scene *scene) {
    bool absorbs = false;
    for (entry_number i = 0; i < scene->object_count; i++) {
        absorbs |= scene->materials[scene->objects[i].material].absorbs;
    }
    return absorbs;
}

/* Tells whether every medium treats the primaries alike. */
static bool scene_is_grey(const struct scene *scene) {
    bool is_grey = true;
    for (entry_number i = 0; i < scene->object_count; i++) {
        const struct material *material = &scene->materials[scene->objects[i].material];
        const real_extinction *absorption = material->absorption;
        is_grey &= !material->absorbs ||
                   (absorption[0] == absorption[1] && absorption[1] == absorption[2]);
    }
    return is_grey;
}

static void add_counts(struct render_counts *sum, const struct render_counts *counts) {
    sum->rays += counts->rays;
    sum->shadow_rays += counts->shadow_rays;
    sum->nodes += counts->nodes;
    sum->solid_tests += counts->solid_tests;
    sum->leaked_rays += counts->leaked_rays;
}

static void start_band(struct stream *stream, const struct scene *scene, uint32_t pixels) {
    const struct render_counts nothing = {0};
    stream->scene = scene;
    stream->counts = nothing;
    stream->absorbs = scene_absorbs(scene);
    stream->wanted_count = pixels;
    for (uint32_t i = 0; i < pixels; i++) {
        stream->wanted[i] = (uint16_t)i;
    }
}

/* Makes all that a look at the wanted pixels begins with empty. */
static void start_look(struct stream *stream) {
    const uint32_t places = watched(stream) != NULL ? TAIL_PLACES : 1;
    set_memory_begin(&stream->memory, stream->scene);
    queue_clear(&stream->queue, scene_is_grey(stream->scene));
    for (uint32_t i = 0; i < stream->wanted_count; i++) {
        for (uint32_t place = 0; place < places; place++) {
            memset(stream->sums[stream->wanted[i] + place * TARGET_PIXELS], 0,
                   sizeof stream->sums[0]);
        }
    }
}

/* Returns the number of rays of a pixel: of the look at work, and of those before. */
static uint64_t rays_of(const struct stream *stream, uint32_t pixel) {
    uint64_t rays = (uint64_t)stream->sums[pixel][SUM_OF_RAYS];
    if (stream->scene->error > 0) {
        rays += (uint64_t)stream->sums[pixel + TAIL_DOWN * TARGET_PIXELS][SUM_OF_RAYS] +
                (uint64_t)stream->sums[pixel + TAIL_UP * TARGET_PIXELS][SUM_OF_RAYS] +
                stream->pixels.rays[pixel];
    }
    return rays;
}

/* Tells whether a pixel had more rays than it may have. */
static bool is_exhausted(const struct stream *stream) {
    uint64_t most = 0;
    for (uint32_t i = 0; i < stream->wanted_count; i++) {
        uint64_t rays = rays_of(stream, stream->wanted[i]);
        most = rays > most ? rays : most;
    }
    return most > stream->scene->ray_budget;
}

/* Follows all rays of the wanted pixels; false where the queue overflowed or a pixel's budget
 * ended. */
static bool follow_rays(struct stream *stream, uint16_t first_row) {
    uint32_t next = 0, unwatched = 0, block = 0;
    start_look(stream);
    for (;;) {
        while (next < stream->wanted_count && queue_fullest(&stream->queue) < LANES) {
            uint32_t left = stream->wanted_count - next, count = left < LANES ? left : LANES;
            start_eye_rays(stream, first_row, next, count);
            next += count;
        }
        uint32_t count = queue_take(&stream->queue, &block);
        if (count == 0) {
            return !is_exhausted(stream);
        }
        stream->rays = &stream->queue.blocks[block];
        step(stream, count);
        queue_give_back(&stream->queue, block);
        unwatched = (unwatched + 1) % STEPS_UNWATCHED;
        if (stream->queue.overflowed || set_memory_is_full(&stream->memory) ||
            (unwatched == 0 && is_exhausted(stream))) {
            return false;
        }
    }
}

/* Judges the look at a pixel; false if there is to be no other. */
static bool judge(struct stream *stream, uint32_t pixel) {
    struct watched_pixels *pixels = &stream->pixels;
    struct tail *tail = &pixels->tail[pixel];
    struct tail_verdict found;
    const uint64_t in_all = rays_of(stream, pixel);
    const struct tail_rays rays = {in_all - pixels->rays[pixel], in_all, stream->scene->ray_budget};
    for (uint32_t place = 0; place < TAIL_PLACES; place++) {
        for (uint32_t primary = 0; primary < PRIMARIES; primary++) {
            tail->gathered[place][primary] = stream->sums[pixel + place * TARGET_PIXELS][primary];
        }
    }
    tail_judge(stream->scene, tail, pixels->steps[pixel], &rays, &found);
    if (found.uncertainty <= pixels->best[pixel].uncertainty) {
        pixels->best[pixel] = found;
    }
    pixels->rays[pixel] = in_all;
    pixels->steps[pixel] = found.steps;
    return found.steps < TAIL_STEPS;
}

/* Looks at the pixels of a band until each is as accurate as was asked for: refine_pixel() of
 * firmware/refine.c. False where follow_rays() was. */
static bool refine_band(struct stream *stream, uint16_t first_row) {
    watch_begin(&stream->pixels, stream->scene, stream->wanted_count);
    while (stream->wanted_count > 0) {
        uint32_t again = 0;
        for (uint32_t i = 0; i < stream->wanted_count; i++) {
            tail_clear(&stream->pixels.tail[stream->wanted[i]]);
        }
        if (!follow_rays(stream, first_row)) {
            return false;
        }
        for (uint32_t i = 0; i < stream->wanted_count; i++) {
            uint16_t pixel = stream->wanted[i];
            if (judge(stream, pixel)) {
                stream->wanted[again++] = pixel;
            }
        }
        stream->wanted_count = again;
    }
    return true;
}

/* Returns colour_level() of a sum, without a branch: up to white every arithmetic holds all steps
 * exactly. */
static inline uint8_t level_of(int64_t steps) {
    const int64_t white = INT64_C(255) << 16, half = INT64_C(1) << 15;
    int64_t above = steps > 0 ? steps : 0;
    return (uint8_t)(((above < white ? above : white) + half) >> 16);
}

static void show_watched(const struct stream *stream, uint16_t first_row, uint32_t pixels,
                         uint8_t *rgb, struct render_counts *counts) {
    const struct scene *scene = stream->scene;
    for (uint32_t i = 0; i < pixels; i++) {
        const struct tail_verdict *verdict = &stream->pixels.best[i];
        if (tail_note(scene, verdict, counts)) {
            counts->worst_x = (uint16_t)(i % scene->width);
            counts->worst_y = (uint16_t)(first_row + i / scene->width);
        }
        for (uint32_t primary = 0; primary < PRIMARIES; primary++) {
            rgb[PRIMARIES * i + primary] = level_of(verdict->colour[primary]);
        }
    }
}

static bool stream_rows(void *memory, const struct scene *scene, uint16_t first, uint16_t rows,
                        uint8_t *rgb, struct render_counts *counts) {
    struct stream *stream = memory;
    uint32_t pixels = (uint32_t)rows * scene->width;
    start_band(stream, scene, pixels);
    if (watched(stream) != NULL) {
        if (!refine_band(stream, first)) {
            return false;
        }
        show_watched(stream, first, pixels, rgb, counts);
    } else {
        if (!follow_rays(stream, first)) {
            return false;
        }
        for (uint32_t i = 0; i < pixels; i++) {
            for (uint32_t primary = 0; primary < PRIMARIES; primary++) {
                rgb[PRIMARIES * i + primary] = level_of(stream->sums[i][primary]);
            }
        }
    }
    add_counts(counts, &stream->counts);
    return true;
}

/* Tells whether the engine knows a material: factors by wavelength, dispersion and w(theta) are the
 * image's alone. */
static bool material_fits(const struct material *material) {
    return !material->tints && !material->disperses &&
           material->specular_table == SPECULAR_CONSTANT;
}

/* Tells whether the engine knows a scene. Filters and the simplified model are the image's
 * alone. */
static bool stream_fits(const struct scene *scene) {
    for (entry_number i = 0; i < scene->object_count; i++) {
        if (!material_fits(&scene->materials[scene->objects[i].material])) {
            return false;
        }
    }
    return set_memory_fits(scene) && scene->width <= FEATURE_WIDTH && !scene->simple &&
           !scene->filters;
}

extern const struct stream_engine STREAM_SYMBOL(STREAM_REAL, INSTRUCTION_SET);

const struct stream_engine STREAM_SYMBOL(STREAM_REAL, INSTRUCTION_SET) = {
    STREAM_TEXT(STREAM_REAL), STREAM_TEXT(INSTRUCTION_SET), sizeof(struct stream), stream_fits,
    stream_rows};
