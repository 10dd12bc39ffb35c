/* SPDX-License-Identifier: MIT */
/* One form of a scene, drawn in one arithmetic: levels, path signatures, what the oracle says. */
#ifndef SUPERFRAME_RELATIONS_RENDERING_H
#define SUPERFRAME_RELATIONS_RENDERING_H

#include "oracle.h"
#include "render/arithmetic.h"
#include "syntax.h"

enum { RENDERING_PIXELS_MOST = 48 * 30, RENDERING_TEXT_MOST = 128 * 1024 };

/* A form as the program has read and compiled it. */
struct form {
    const struct syntax *syntax;
    struct compiled_scene *compiled;          /* NULL: refused */
    int materials[SYNTAX_MATERIALS_MOST + 1]; /* of the compiled ones: numbers in the syntax, from
                                                 ORACLE_AIR; those that nobody uses are not there */
    struct scene_error error;
};

struct rendering_pixel {
    int level[3];
    uint64_t signature;
    bool is_cut_by_depth;
};

struct rendering {
    int width, height;
    struct rendering_pixel pixels[RENDERING_PIXELS_MOST];
    uint64_t leaked, segments; /* rays that leaked; points that the oracle was asked about */
    bool is_wrong;             /* the oracle disagrees, at this pixel */
    int wrong_x, wrong_y;
    char wrong[160];
};

/* Reads and compiles. False with form->error where the program refuses the scene. */
bool form_start(struct form *form, const struct syntax *syntax);

void form_end(struct form *form);

/* Draws. A material that is `invisible` counts as air in signatures; ORACLE_AIR: none is. False
 * with form->error where the arithmetic refuses the scene. */
bool rendering_draw(struct form *form, const struct arithmetic *arithmetic, int invisible,
                    struct rendering *picture);

#endif
