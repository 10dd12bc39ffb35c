/* SPDX-License-Identifier: MIT */
/* The scene compiler as an optimiser: the same picture from less. */
#include "compiler/optimise.h"

#include <stdlib.h>
#include <string.h>

static bool count_uses(struct optimiser *optimiser) {
    struct compiled_scene *scene = optimiser->compiler->scene;
    optimiser->uses = calloc((size_t)scene->primitive_count + 1, sizeof *optimiser->uses);
    if (optimiser->uses == NULL) {
        return compile_fail_memory(optimiser->compiler);
    }
    for (uint32_t i = 0; i < scene->program_length; i++) {
        if (scene->programs[i] < COMPILED_UNION) {
            scene->report.shared += optimiser->uses[scene->programs[i]]++ > 0;
        }
    }
    return true;
}

/* Moves an object to a lower number. */
static void move_object(struct compiled_scene *scene, uint32_t from, uint32_t to) {
    if (from != to) {
        scene->objects[to] = scene->objects[from];
        memcpy(scene->object_names[to], scene->object_names[from], sizeof scene->object_names[0]);
    }
}

static bool fuse(struct optimiser *optimiser) {
    optimise_fuse(optimiser);
    return true;
}

/* Takes the program of each object through one pass, which returns false where nothing is left of
 * an object. Programs only get shorter: they are written over from the front. */
static bool rewrite_programs(struct optimiser *optimiser, bool (*pass)(struct optimiser *optimiser),
                             enum compile_step step) {
    struct compiled_scene *scene = optimiser->compiler->scene;
    uint32_t place = 0, kept = 1;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        if (!csg_read(scene, &scene->objects[i], &optimiser->tree)) {
            return compile_fail_memory(optimiser->compiler);
        }
        if (pass(optimiser)) {
            move_object(scene, i, kept);
            place = csg_write(scene, &scene->objects[kept], &optimiser->tree, place);
            kept++;
        }
    }
    scene->object_count = kept;
    scene->program_length = place;
    compile_show(optimiser->compiler, step);
    return true;
}

static bool optimise(struct optimiser *optimiser) {
    /* What is fused may turn out to be the same as something else, or apart from it. */
    return count_uses(optimiser) && rewrite_programs(optimiser, optimise_simplify, STEP_SIMPLIFY) &&
           rewrite_programs(optimiser, fuse, STEP_FUSE) &&
           rewrite_programs(optimiser, optimise_simplify, STEP_SIMPLIFY_FUSED) &&
           optimise_bound(optimiser);
}

bool compile_optimise(struct compiler *compiler) {
    struct optimiser optimiser = {.compiler = compiler};
    bool is_done = optimise(&optimiser);
    csg_free(&optimiser.tree);
    free(optimiser.uses);
    if (!is_done) {
        return false;
    }
    compile_show(compiler, STEP_BOUND);
    return optimise_compact(compiler);
}
