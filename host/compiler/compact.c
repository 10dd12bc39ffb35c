/* SPDX-License-Identifier: MIT */
/* The scene compiler: drops from the tables what no program names, and sorts them by the
 * programs. */
#include <math.h>
#include <stdlib.h>

#include "base/grow.h"
#include "compiler/optimise.h"

/* The tables as they were, and the new numbers of their entries: COMPILED_NONE is none yet. */
struct moves {
    struct compiled_scene old;
    uint32_t *primitive, *frame, *surface;
};

/* Returns the new number of an entry, which is the next one where the entry has none yet. */
static uint32_t move(uint32_t *moved, uint32_t *count) {
    if (*moved == COMPILED_NONE) {
        *moved = (*count)++;
    }
    return *moved;
}

static uint32_t move_surface(struct moves *moves, struct compiled_scene *scene, uint32_t surface) {
    return move(&moves->surface[surface], &scene->surface_count);
}

static void move_faces(struct moves *moves, struct compiled_scene *scene, struct compiled_box *box,
                       unsigned axes) {
    for (int face = 0; face < 6; face++) {
        box->surface[face] =
            (axes >> face % 3 & 1) != 0 ? move_surface(moves, scene, box->surface[face]) : 0;
    }
}

static bool move_box(struct moves *moves, struct compiled_scene *scene, uint32_t *index,
                     unsigned axes) {
    if (!GROW(scene->boxes, scene->box_count)) {
        return false;
    }
    struct compiled_box *box = &scene->boxes[scene->box_count];
    *box = moves->old.boxes[*index];
    *index = scene->box_count++;
    move_faces(moves, scene, box, axes);
    return true;
}

static bool move_polyhedron(struct moves *moves, struct compiled_scene *scene, uint32_t *index) {
    const struct compiled_polyhedron *from = &moves->old.polyhedra[*index];
    if (!GROW(scene->polyhedra, scene->polyhedron_count)) {
        return false;
    }
    struct compiled_polyhedron *to = &scene->polyhedra[scene->polyhedron_count];
    *to = *from;
    *index = scene->polyhedron_count++;
    to->first = scene->plane_count;
    for (uint32_t i = 0; i < from->count; i++) {
        if (!GROW(scene->planes, scene->plane_count)) {
            return false;
        }
        struct compiled_plane *plane = &scene->planes[scene->plane_count++];
        *plane = moves->old.planes[from->first + i];
        plane->surface = move_surface(moves, scene, plane->surface);
    }
    return true;
}

static bool move_quadric(struct moves *moves, struct compiled_scene *scene, uint32_t *index) {
    if (!GROW(scene->quadrics, scene->quadric_count)) {
        return false;
    }
    struct compiled_quadric *quadric = &scene->quadrics[scene->quadric_count];
    *quadric = moves->old.quadrics[*index];
    *index = scene->quadric_count++;
    quadric->surface = move_surface(moves, scene, quadric->surface);
    if (quadric->cuts != 0) {
        return move_box(moves, scene, &quadric->box, quadric->cuts);
    }
    quadric->box = 0;
    return true;
}

static bool move_ball(struct moves *moves, struct compiled_scene *scene, uint32_t *index) {
    if (!GROW(scene->balls, scene->ball_count)) {
        return false;
    }
    struct compiled_ball *ball = &scene->balls[scene->ball_count];
    *ball = moves->old.balls[*index];
    *index = scene->ball_count++;
    ball->surface = move_surface(moves, scene, ball->surface);
    return true;
}

static bool move_frame(struct moves *moves, struct compiled_scene *scene, uint32_t *frame) {
    const uint32_t from = *frame;
    if (from == COMPILED_FRAME_WORLD) {
        return true;
    }
    if (moves->frame[from] == COMPILED_NONE && !GROW(scene->frames, scene->frame_count)) {
        return false;
    }
    *frame = move(&moves->frame[from], &scene->frame_count);
    scene->frames[*frame] = moves->old.frames[from];
    return true;
}

/* Moves a primitive with all that belongs to it; false if memory is out. */
static bool move_primitive(struct moves *moves, struct compiled_scene *scene, uint32_t index) {
    if (!GROW(scene->primitives, scene->primitive_count)) {
        return false;
    }
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count];
    *primitive = moves->old.primitives[index];
    moves->primitive[index] = scene->primitive_count++;
    if (!move_frame(moves, scene, &primitive->frame)) {
        return false;
    }
    switch (primitive->kind) {
    case PRIMITIVE_BOX:
        return move_box(moves, scene, &primitive->index, 7);
    case PRIMITIVE_BALL:
        return move_ball(moves, scene, &primitive->index);
    case PRIMITIVE_QUADRIC:
        return move_quadric(moves, scene, &primitive->index);
    case PRIMITIVE_POLYHEDRON:
        break;
    }
    return move_polyhedron(moves, scene, &primitive->index);
}

/* Takes the tables that are to be made anew out of the scene. */
static void take_tables(struct compiled_scene *scene) {
    scene->primitive_count = scene->frame_count = scene->box_count = scene->ball_count = 0;
    scene->polyhedron_count = scene->quadric_count = 0;
    scene->surface_count = scene->plane_count = 0;
    scene->frames = NULL;
    scene->primitives = NULL;
    scene->boxes = NULL;
    scene->balls = NULL;
    scene->polyhedra = NULL;
    scene->planes = NULL;
    scene->quadrics = NULL;
}

static void free_moves(struct moves *moves) {
    free(moves->old.frames);
    free(moves->old.primitives);
    free(moves->old.boxes);
    free(moves->old.balls);
    free(moves->old.polyhedra);
    free(moves->old.planes);
    free(moves->old.quadrics);
    free(moves->primitive);
    free(moves->frame);
    free(moves->surface);
}

/* Returns new numbers for so many entries, none of which has one yet; NULL if memory is out. */
static uint32_t *no_numbers(uint32_t count) {
    uint32_t *numbers = malloc(((size_t)count + 1) * sizeof *numbers);
    for (uint32_t i = 0; i < count && numbers != NULL; i++) {
        numbers[i] = COMPILED_NONE;
    }
    return numbers;
}

static bool move_all(struct moves *moves, struct compiled_scene *scene) {
    moves->primitive = no_numbers(moves->old.primitive_count);
    moves->frame = no_numbers(moves->old.frame_count);
    moves->surface = no_numbers(moves->old.surface_count);
    if (moves->primitive == NULL || moves->frame == NULL || moves->surface == NULL) {
        return false;
    }
    for (uint32_t i = 0; i < scene->program_length; i++) {
        uint32_t code = scene->programs[i];
        if (code >= COMPILED_UNION) {
            continue;
        }
        if (moves->primitive[code] == COMPILED_NONE && !move_primitive(moves, scene, code)) {
            return false;
        }
        scene->programs[i] = moves->primitive[code];
    }
    return true;
}

/* Notes which primitives each surface bounds; false if memory is out. */
static bool bind_surfaces(struct compiled_scene *scene) {
    scene->surfaces = calloc((size_t)scene->surface_count + 1, sizeof *scene->surfaces);
    bool is_bound = scene->surfaces != NULL;
    for (uint32_t i = 0; i < scene->primitive_count && is_bound; i++) {
        const uint32_t curve = compiled_curve(scene, i);
        struct compiled_face faces[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, i, faces);
        for (int j = 0; j < count; j++) {
            is_bound = is_bound && compiled_set_include(&scene->surfaces[faces[j].surface], i);
        }
        is_bound = is_bound &&
                   (curve == COMPILED_NONE || compiled_set_include(&scene->surfaces[curve], i));
    }
    return is_bound;
}

/* Sets each quadric's reach, with room for rounding, and whether rays that leave it by its curved
 * face leave it for good. They do not if it shares that surface: the other primitive may go on
 * where it is cut. A ray can then leave the other one by that surface and enter it. */
static void finish_quadrics(struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        if (primitive->kind != PRIMITIVE_QUADRIC) {
            continue;
        }
        struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
        const double *square = quadric->square;
        double low[3], high[3];
        quadric_extent(scene, quadric, compiled_box_of(scene, quadric), primitive->frame, low,
                       high);
        double reach = quadric_ball(quadric, low, high) * (1 + 0x1p-10) + 0x1p-10;
        quadric->reach = reach < COMPILE_FAR ? reach : 0;
        quadric->left_for_good = square[0] >= 0 && square[1] >= 0 && square[2] >= 0 &&
                                 scene->surfaces[quadric->surface].count == 1;
    }
}

bool optimise_compact(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    struct moves moves = {.old = *scene};
    take_tables(scene);
    bool is_done = move_all(&moves, scene);
    free_moves(&moves);
    if (!is_done || !bind_surfaces(scene)) {
        return compile_fail_memory(compiler);
    }
    finish_quadrics(scene);
    return true;
}
