/* SPDX-License-Identifier: MIT */
/* The scene compiler as an optimiser: the same picture from less. */
#include "compile_optimise.h"

#include <stdlib.h>
#include <string.h>

static void count_uses(struct optimiser *optimiser) {
    const struct compiled_scene *scene = optimiser->compiler->scene;
    memset(optimiser->uses, 0, sizeof optimiser->uses);
    for (int i = 0; i < scene->program_length; i++) {
        if (scene->programs[i] < CODE_UNION) {
            optimiser->uses[scene->programs[i]]++;
        }
    }
}

/* Programs only get shorter: they are written over from the front. */
static void rewrite_programs(struct optimiser *optimiser) {
    struct compiled_scene *scene = optimiser->compiler->scene;
    uint16_t place = 0;
    for (int i = 1; i < scene->object_count; i++) {
        csg_read(scene, &scene->objects[i], &optimiser->tree);
        optimise_fuse(optimiser);
        place = csg_write(scene, &scene->objects[i], &optimiser->tree, place);
    }
    scene->program_length = place;
}

bool compile_optimise(struct compiler *compiler) {
    struct optimiser *optimiser = calloc(1, sizeof *optimiser);
    if (optimiser == NULL) {
        return compile_fail(compiler, 0, "out of memory");
    }
    optimiser->compiler = compiler;
    count_uses(optimiser);
    rewrite_programs(optimiser);
    optimise_bound(optimiser);
    free(optimiser);
    return optimise_compact(compiler);
}
