/* SPDX-License-Identifier: MIT */
/* Parts of a scene's file that can't change its picture: found by what rays reach, and left out. */
#ifndef SUPERFRAME_COMPILE_DEAD_H
#define SUPERFRAME_COMPILE_DEAD_H

#include "compiler/compiler_internal.h"

/* The reach of rays in a compiled scene, by the numbers of its tables. */
struct compile_reach {
    const char **lost; /* by object: why no ray touches it; NULL: one may */
    bool *is_seen;     /* by object: on a path from the eye; false: by shadow rays at most */
    bool is_shown[COMPILED_MATERIALS_MOST]; /* an object of that material is seen */
    bool *lights; /* by light: it lights something that is shown, if nothing is in between */
};

/* Finds what rays may reach, never too little; false with the failure recorded. Call reach_free()
 * in either case. */
bool compile_find_reach(struct compiler *compiler, struct compile_reach *reach);
void reach_free(struct compile_reach *reach);

/* Returns true if surfaces of the material have an intensity of their own. */
bool material_is_shaded(const struct compiled_scene *scene,
                        const struct compiled_material *material);

/* Returns the largest share of a ray's weight that goes on from a surface of the material in one
 * direction. */
double material_share_most(const struct compiled_scene *scene,
                           const struct compiled_material *material);

/* Returns true if rays leave a surface of the material in other directions than they came. */
bool material_turns_aside(const struct compiled_scene *scene,
                          const struct compiled_material *material);

/* Marks in compiler->dead what the compiled scene proves to be dead. The scene is to be compiled
 * again where that is more than before. Returns false with the failure recorded. */
bool compile_find_dead(struct compiler *compiler);

/* Settles what the scene as a whole requires, and lists what is dead. Returns false with the
 * failure recorded. */
bool compile_settle(struct compiler *compiler);

#endif
