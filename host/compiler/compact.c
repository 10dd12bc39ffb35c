/* SPDX-License-Identifier: MIT */
/* The scene compiler: drops from the tables what no program names, and sorts them by the
 * programs. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/optimise.h"

enum { NOWHERE = 0xFFFF };

/* The new numbers of the entries of each table. */
struct moves {
    struct compiled_scene old;
    uint16_t primitive[COMPILED_DRAFTS_MOST];
    uint16_t frame[COMPILED_FRAMES_MOST];
    uint16_t surface[COMPILED_SURFACES_MOST];
};

static uint16_t move(uint16_t *moved, uint16_t *count) {
    if (*moved == NOWHERE) {
        *moved = (*count)++;
    }
    return *moved;
}

static uint16_t move_surface(struct moves *moves, struct compiled_scene *scene, uint16_t surface) {
    return move(&moves->surface[surface], &scene->surface_count);
}

static uint8_t move_box(struct moves *moves, struct compiled_scene *scene, uint8_t index) {
    struct compiled_box *box = &scene->boxes[scene->box_count];
    *box = moves->old.boxes[index];
    return scene->box_count++;
}

static void move_faces(struct moves *moves, struct compiled_scene *scene, struct compiled_box *box,
                       unsigned axes) {
    for (int face = 0; face < 6; face++) {
        box->surface[face] =
            (axes >> face % 3 & 1) != 0 ? move_surface(moves, scene, box->surface[face]) : 0;
    }
}

static uint8_t move_polyhedron(struct moves *moves, struct compiled_scene *scene, uint8_t index) {
    const struct compiled_polyhedron *from = &moves->old.polyhedra[index];
    struct compiled_polyhedron *to = &scene->polyhedra[scene->polyhedron_count];
    *to = *from;
    to->first = scene->plane_count;
    for (int i = 0; i < from->count; i++) {
        struct compiled_plane *plane = &scene->planes[scene->plane_count++];
        *plane = moves->old.planes[from->first + i];
        plane->surface = move_surface(moves, scene, plane->surface);
    }
    return scene->polyhedron_count++;
}

static uint8_t move_quadric(struct moves *moves, struct compiled_scene *scene, uint8_t index) {
    struct compiled_quadric *quadric = &scene->quadrics[scene->quadric_count];
    *quadric = moves->old.quadrics[index];
    quadric->surface = move_surface(moves, scene, quadric->surface);
    if (quadric->cuts != 0) {
        quadric->box = move_box(moves, scene, quadric->box);
        move_faces(moves, scene, &scene->boxes[quadric->box], quadric->cuts);
    } else {
        quadric->box = 0;
    }
    return scene->quadric_count++;
}

static uint8_t move_ball(struct moves *moves, struct compiled_scene *scene, uint8_t index) {
    struct compiled_ball *ball = &scene->balls[scene->ball_count];
    *ball = moves->old.balls[index];
    ball->surface = move_surface(moves, scene, ball->surface);
    return scene->ball_count++;
}

static void move_frame(struct moves *moves, struct compiled_scene *scene,
                       struct compiled_primitive *primitive) {
    if (primitive->frame != FRAME_WORLD) {
        uint16_t count = scene->frame_count;
        uint8_t from = primitive->frame;
        primitive->frame = (uint8_t)move(&moves->frame[from], &count);
        scene->frames[primitive->frame] = moves->old.frames[from];
        scene->frame_count = (uint8_t)count;
    }
}

/* Moves a primitive with all that belongs to it. */
static void move_primitive(struct moves *moves, struct compiled_scene *scene, uint8_t index) {
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count++];
    *primitive = moves->old.primitives[index];
    move_frame(moves, scene, primitive);
    switch (primitive->kind) {
    case PRIMITIVE_BOX:
        primitive->index = move_box(moves, scene, primitive->index);
        move_faces(moves, scene, &scene->boxes[primitive->index], 7);
        break;
    case PRIMITIVE_BALL:
        primitive->index = move_ball(moves, scene, primitive->index);
        break;
    case PRIMITIVE_QUADRIC:
        primitive->index = move_quadric(moves, scene, primitive->index);
        break;
    case PRIMITIVE_POLYHEDRON:
        primitive->index = move_polyhedron(moves, scene, primitive->index);
        break;
    }
}

static void clear_tables(struct compiled_scene *scene) {
    scene->primitive_count = scene->frame_count = scene->box_count = scene->ball_count = 0;
    scene->polyhedron_count = scene->quadric_count = 0;
    scene->surface_count = scene->plane_count = 0;
}

static bool move_all(struct compiler *compiler, struct moves *moves) {
    struct compiled_scene *scene = compiler->scene;
    moves->old = *scene;
    memset(moves->primitive, 0xFF, sizeof moves->primitive);
    memset(moves->frame, 0xFF, sizeof moves->frame);
    memset(moves->surface, 0xFF, sizeof moves->surface);
    clear_tables(scene);
    for (int i = 0; i < scene->program_length; i++) {
        uint8_t code = scene->programs[i];
        if (code >= PROGRAM_UNION) {
            continue;
        }
        if (moves->primitive[code] == NOWHERE) {
            if (scene->primitive_count == COMPILED_PRIMITIVES_MOST) {
                return compile_fail(compiler, moves->old.primitives[code].line,
                                    "more than %d different solids", COMPILED_PRIMITIVES_MOST);
            }
            moves->primitive[code] = scene->primitive_count;
            move_primitive(moves, scene, code);
        }
        scene->programs[i] = (uint8_t)moves->primitive[code];
    }
    return true;
}

/* Notes which primitives each surface bounds. */
static void bind_surfaces(struct compiled_scene *scene) {
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        struct compiled_face faces[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, i, faces);
        for (int j = 0; j < count; j++) {
            compiled_set_include(&scene->surfaces[faces[j].surface], i);
        }
        if (primitive->kind == PRIMITIVE_BALL) {
            compiled_set_include(&scene->surfaces[scene->balls[primitive->index].surface], i);
        } else if (primitive->kind == PRIMITIVE_QUADRIC) {
            compiled_set_include(&scene->surfaces[scene->quadrics[primitive->index].surface], i);
        }
    }
}

static bool is_only_in(const struct compiled_set *set, int primitive) {
    for (int i = 0; i < COMPILED_PRIMITIVES_MOST; i++) {
        if (i != primitive && compiled_set_has(set, i)) {
            return false;
        }
    }
    return true;
}

/* Sets each quadric's reach, with room for rounding, and whether rays that leave it by its curved
 * face leave it for good. They do not if it shares that surface: the other primitive may go on
 * where it is cut. A ray can then leave the other one by that surface and enter it. */
static void finish_quadrics(struct compiled_scene *scene) {
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        if (primitive->kind != PRIMITIVE_QUADRIC) {
            continue;
        }
        struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
        const double *square = quadric->square;
        double low[3], high[3];
        quadric_extent(scene, quadric, &scene->boxes[quadric->box], primitive->frame, low, high);
        double reach = quadric_ball(quadric, low, high) * (1 + 0x1p-10) + 0x1p-10;
        quadric->reach = reach < COMPILE_FAR ? reach : 0;
        quadric->left_for_good = square[0] >= 0 && square[1] >= 0 && square[2] >= 0 &&
                                 is_only_in(&scene->surfaces[quadric->surface], i);
    }
}

bool optimise_compact(struct compiler *compiler) {
    struct moves *moves = calloc(1, sizeof *moves);
    if (moves == NULL) {
        return compile_fail(compiler, 0, "out of memory");
    }
    bool good = move_all(compiler, moves);
    free(moves);
    if (good) {
        bind_surfaces(compiler->scene);
        finish_quadrics(compiler->scene);
    }
    return good;
}
