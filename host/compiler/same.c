/* SPDX-License-Identifier: MIT */
/* The scene compiler: which directions, planes and frames count as one, however the file writes
 * each. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

/* Tells whether two directions count as one, the second times the sign. A direction may be off by
 * so much that nothing within the scene moves by more than compiler->same. */
static bool same_direction(const struct compiler *compiler, const double a[3], const double b[3],
                           double sign) {
    for (int i = 0; i < 3; i++) {
        if (fabs(a[i] - sign * b[i]) * COMPILE_EXTENT > compiler->same) {
            return false;
        }
    }
    return true;
}

bool compile_same(const struct compiler *compiler, double a, double b) {
    return fabs(a - b) <= compiler->same;
}

/* Numbers that count as one lie in one cell of this many tolerances, or in two neighbouring ones.
 */
#define CELL 64

/* Returns the cell of a number. Numbers whose cells are asked for are far less than 2^52 cells. */
static double cell_of(double number, double tolerance) {
    return floor(number / (CELL * tolerance));
}

/* The cells of all numbers that may count as one with these. */
struct cells {
    double low[3], high[3];
};

static struct cells cells_about(const double place[3], double sign, double tolerance) {
    struct cells cells;
    for (int i = 0; i < 3; i++) {
        cells.low[i] = cell_of(sign * place[i] - 2 * tolerance, tolerance);
        cells.high[i] = cell_of(sign * place[i] + 2 * tolerance, tolerance);
    }
    return cells;
}

static uint64_t direction_key(const double cell[3]) {
    uint64_t key = compile_key(KNOWN_DIRECTION);
    for (int i = 0; i < 3; i++) {
        key = bucket_key_of(key, cell[i]);
    }
    return key;
}

/* Returns the lowest number of a direction in a cell that counts as one with another direction.
 * Returns `lowest` if that is lower. */
static uint32_t find_in_cell(const struct compiler *compiler, const double cell[3],
                             const double direction[3], uint32_t lowest) {
    const struct buckets *known = &compiler->known;
    uint32_t slot = buckets_first(known, direction_key(cell));
    for (; slot != COMPILED_NONE; slot = buckets_next(known, slot)) {
        const uint32_t entry = known->slots[slot].entry;
        const double *other = compiler->directions[entry];
        double sign = vector_dot(direction, other) < 0 ? -1 : 1;
        if (entry < lowest && same_direction(compiler, direction, other, sign)) {
            lowest = entry;
        }
    }
    return lowest;
}

/* Returns the first direction that was met and counts as one with this one, or with its opposite;
 * COMPILED_NONE: there is none. */
static uint32_t find_direction(const struct compiler *compiler, const double direction[3]) {
    uint32_t found = COMPILED_NONE;
    double cell[3];
    for (int sign = -1; sign <= 1; sign += 2) {
        const struct cells about = cells_about(direction, sign, compiler->same / COMPILE_EXTENT);
        for (cell[0] = about.low[0]; cell[0] <= about.high[0]; cell[0]++) {
            for (cell[1] = about.low[1]; cell[1] <= about.high[1]; cell[1]++) {
                for (cell[2] = about.low[2]; cell[2] <= about.high[2]; cell[2]++) {
                    found = find_in_cell(compiler, cell, direction, found);
                }
            }
        }
    }
    return found;
}

bool compile_direction(struct compiler *compiler, double direction[3]) {
    const uint32_t found = find_direction(compiler, direction);
    if (found != COMPILED_NONE) {
        const double *known = compiler->directions[found];
        double sign = vector_dot(direction, known) < 0 ? -1 : 1;
        for (int j = 0; j < 3; j++) {
            direction[j] = sign * known[j];
        }
        return true;
    }
    double cell[3];
    for (int i = 0; i < 3; i++) {
        cell[i] = cell_of(direction[i], compiler->same / COMPILE_EXTENT);
    }
    if (!GROW(compiler->directions, compiler->direction_count)) {
        return compile_fail_memory(compiler);
    }
    memcpy(compiler->directions[compiler->direction_count], direction,
           sizeof compiler->directions[0]);
    return compile_note(compiler, direction_key(cell), compiler->direction_count++) !=
           COMPILED_NONE;
}

uint32_t compile_new_surface(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(compiler->planes, scene->surface_count)) {
        return compile_fail_room(compiler);
    }
    return scene->surface_count++;
}

uint32_t compile_fail_thin(struct compiler *compiler) {
    compile_fail(compiler, compiler->line,
                 "a solid thinner than %g units: its faces are one; make it thicker, or 'weld' "
                 "smaller",
                 ldexp(compiler->same, -compiler->scene->exponent));
    return COMPILED_NONE;
}

/* Returns 1 or -1, so that a direction and its opposite become one. */
static double side_of(const double direction[3]) {
    int i = 0;
    while (i < 2 && direction[i] == 0) {
        i++;
    }
    return direction[i] < 0 ? -1 : 1;
}

/* Returns the key of an axis of a frame, or of a plane's normal: the same for its opposite. */
static uint64_t axis_key(uint64_t key, const double axis[3]) {
    for (int i = 0; i < 3; i++) {
        key = bucket_key_of(key, side_of(axis) * axis[i]);
    }
    return key;
}

uint32_t compile_plane_surface(struct compiler *compiler, const double normal[3], double offset) {
    const struct buckets *known = &compiler->known;
    const uint64_t key = axis_key(compile_key(KNOWN_PLANE), normal);
    const double place = side_of(normal) * offset, same = compiler->same;
    uint32_t surface = COMPILED_NONE;
    const double first = cell_of(place - 2 * same, same);
    const int cells = 1 + (int)(cell_of(place + 2 * same, same) - first);
    for (int i = 0; i < cells; i++) {
        uint32_t slot = buckets_first(known, bucket_key_of(key, first + i));
        for (; slot != COMPILED_NONE; slot = buckets_next(known, slot)) {
            const uint32_t entry = known->slots[slot].entry;
            const struct compile_plane *plane = &compiler->planes[entry];
            double sign = vector_parallel(normal, plane->normal);
            if (entry < surface && sign != 0 &&
                compile_same(compiler, sign * offset, plane->offset)) {
                surface = entry;
            }
        }
    }
    if (surface != COMPILED_NONE) {
        return surface;
    }
    surface = compile_new_surface(compiler);
    if (surface != COMPILED_NONE) {
        memcpy(compiler->planes[surface].normal, normal, 3 * sizeof *normal);
        compiler->planes[surface].offset = offset;
    }
    return compile_note(compiler, bucket_key_of(key, cell_of(place, same)), surface);
}

double compile_place_of_plane(const struct compiler *compiler, uint32_t surface,
                              const double axis[3]) {
    const struct compile_plane *plane = &compiler->planes[surface];
    return vector_parallel(axis, plane->normal) < 0 ? -plane->offset : plane->offset;
}

/* Sorts axes into those of a frame, up to their order and signs. Returns false if they do not
 * match, or the third axis would have to stay and does not. */
static bool sort_axes(const struct compiled_scene *scene, uint32_t frame, double axis[3][3],
                      bool third_stays, int permutation[3], double sign[3]) {
    for (int i = 0; i < 3; i++) {
        int j = 0;
        while (j < 3 && vector_parallel(axis[j], compiled_axis(scene, frame, i)) == 0) {
            j++;
        }
        if (j == 3) {
            return false;
        }
        permutation[i] = j;
        sign[i] = vector_parallel(axis[j], compiled_axis(scene, frame, i));
    }
    return !third_stays || permutation[2] == 2;
}

/* Returns the key of three axes, in any order and with any signs. */
static uint64_t frame_key(double axis[3][3]) {
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += axis_key(compile_key(KNOWN_FRAME), axis[i]);
    }
    return bucket_key(compile_key(KNOWN_FRAME), sum);
}

bool compile_frame(struct compiler *compiler, double axis[3][3], bool third_stays,
                   int permutation[3], double sign[3], uint32_t *frame) {
    struct compiled_scene *scene = compiler->scene;
    for (int i = 0; i < 3; i++) {
        if (!compile_direction(compiler, axis[i])) {
            return false;
        }
    }
    if (sort_axes(scene, COMPILED_FRAME_WORLD, axis, third_stays, permutation, sign)) {
        *frame = COMPILED_FRAME_WORLD;
        return true;
    }
    const uint64_t key = frame_key(axis);
    uint32_t slot = buckets_first(&compiler->known, key);
    *frame = COMPILED_NONE;
    for (; slot != COMPILED_NONE; slot = buckets_next(&compiler->known, slot)) {
        const uint32_t entry = compiler->known.slots[slot].entry;
        if (entry < *frame && sort_axes(scene, entry, axis, third_stays, permutation, sign)) {
            *frame = entry;
        }
    }
    if (*frame != COMPILED_NONE) {
        return sort_axes(scene, *frame, axis, third_stays, permutation, sign);
    }
    if (!GROW(scene->frames, scene->frame_count)) {
        return compile_fail_memory(compiler);
    }
    memcpy(scene->frames[scene->frame_count].axis, axis, sizeof scene->frames[0].axis);
    for (int i = 0; i < 3; i++) {
        permutation[i] = i;
        sign[i] = 1;
    }
    *frame = compile_note(compiler, key, scene->frame_count++);
    return *frame != COMPILED_NONE;
}
