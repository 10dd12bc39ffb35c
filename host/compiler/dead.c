/* SPDX-License-Identifier: MIT */
/* The scene compiler: marks what can't change the picture, for the tables to leave it out. */
#include "compiler/dead.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/grow.h"

/* A threshold below this is too near to the rounding of weights for a proof. */
#define THRESHOLD_LEAST 0x1p-16

static void mark(struct compile_dead *dead, const char **why, const char *reason) {
    if (*why == NULL && reason != NULL) {
        *why = reason;
        dead->count++;
    }
}

/* ---- Objects and lights --------------------------------------------------------------------- */

static bool mark_parts(struct compiler *compiler, const struct compile_reach *reach) {
    const struct compiled_scene *scene = compiler->scene;
    struct compile_dead *dead = compiler->dead;
    bool *is_compiled = calloc((size_t)dead->part_count + 1, sizeof *is_compiled);
    if (is_compiled == NULL) {
        return compile_fail_memory(compiler);
    }
    dead->has_endless = false;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        is_compiled[scene->objects[i].part] = true;
        mark(dead, &dead->part[scene->objects[i].part], reach->lost[i]);
        dead->has_endless = dead->has_endless || (reach->lost[i] == NULL &&
                                                  !bounds_are_finite(&scene->objects[i].bounds));
    }
    for (uint32_t i = 0; i < dead->part_count; i++) {
        mark(dead, &dead->part[i], is_compiled[i] ? NULL : "no point is in it");
    }
    free(is_compiled);
    return true;
}

static bool mark_lights(const struct compiler *compiler, const struct compile_reach *reach) {
    const struct compiled_scene *scene = compiler->scene;
    bool is_light = false;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const double *colour = scene->lights[i].colour;
        bool is_black = colour[0] <= 0 && colour[1] <= 0 && colour[2] <= 0;
        is_light = is_light || reach->lights[i];
        mark(compiler->dead, &compiler->dead->light[scene->lights[i].file],
             reach->lights[i] ? NULL
             : is_black       ? "it is black"
                              : "nothing that is seen reflects any of it");
    }
    return is_light;
}

/* ---- Materials ------------------------------------------------------------------------------ */

static bool are_equal(const double *values, const double *others, int count) {
    for (int i = 0; i < count; i++) {
        if (values[i] < others[i] || values[i] > others[i]) {
            return false;
        }
    }
    return true;
}

static const char *pattern_is_dead(const struct compiled_scene *scene,
                                   const struct compiled_material *material, bool is_light) {
    bool is_used = material->ambient_share > 0 || (material->diffuse > 0 && is_light);
    if (material->pattern == PATTERN_NONE) {
        return NULL;
    }
    return are_equal(scene->patterns[material->pattern].colour, material->colour, 3)
               ? "both of its colours are the same"
           : !is_used || !material_is_shaded(scene, material) ? "its colours are not to be seen"
                                                              : NULL;
}

static const char *table_is_dead(const struct compiled_scene *scene,
                                 const struct compiled_material *material) {
    if (material->specular_table == SPECULAR_CONSTANT) {
        return NULL;
    }
    const double *specular = scene->specular_tables[material->specular_table].specular;
    return are_equal(specular, specular + 1, SPECULAR_STEPS - 1) ? "all of its values are the same"
                                                                 : NULL;
}

/* Returns why a highlight is dead, or NULL. An opaque material's never is, for the material mirrors
 * by the same number. */
static const char *highlight_is_dead(const struct compiled_scene *scene,
                                     const struct compiled_material *material, bool is_light) {
    bool has_one = material->specular > 0 || material->specular_table != SPECULAR_CONSTANT;
    return has_one && material->transparent && !(is_light && material_is_shaded(scene, material))
               ? "no light makes one"
               : NULL;
}

/* Returns true if a path may go through a boundary between transparent materials. */
static bool lets_paths_in(const struct compiled_scene *scene, const struct compile_reach *reach) {
    for (uint32_t i = 1; i < scene->material_count; i++) {
        const struct compiled_material *material = &scene->materials[i];
        double tau = scene->simple ? material->transmittance : 1;
        for (int j = 0; j < 3 && material->transparent && reach->is_shown[i]; j++) {
            double filter = scene->filters ? material->filter[j] : 1;
            if (tau * material->transmits[j] * filter > 0) {
                return scene->depth > 0 || scene->estimates;
            }
        }
    }
    return false;
}

static void mark_material(struct compiler *compiler, const struct compile_reach *reach,
                          uint32_t index, bool is_light) {
    const struct compiled_scene *scene = compiler->scene;
    const struct compiled_material *material = &scene->materials[index];
    struct compile_dead *dead = compiler->dead;
    const uint8_t file = material->file;
    bool is_used = false, is_kept = false;
    bool is_entered =
        lets_paths_in(scene, reach) || scene->objects[scene->camera.object].material == index;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        bool has_it = scene->objects[i].material == index;
        is_used = is_used || has_it;
        is_kept = is_kept || (has_it && reach->lost[i] == NULL);
    }
    if (!is_kept) {
        mark(dead, &dead->material[file],
             is_used ? "no ray reaches what is made of it" : "no object is made of it");
        return;
    }
    if (!reach->is_shown[index]) {
        mark(dead, &dead->look[file], "nothing is seen of it but its shadow");
        return;
    }
    mark(dead, &dead->pattern[file], pattern_is_dead(scene, material, is_light));
    mark(dead, &dead->table[file], table_is_dead(scene, material));
    mark(dead, &dead->highlight[file], highlight_is_dead(scene, material, is_light));
    mark(dead, &dead->absorption[file],
         material->absorbs && !is_entered ? "no ray enters it" : NULL);
}

bool compile_find_dead(struct compiler *compiler) {
    struct compile_reach reach;
    bool is_found = compile_find_reach(compiler, &reach) && mark_parts(compiler, &reach);
    if (is_found) {
        bool is_light = mark_lights(compiler, &reach);
        for (uint32_t i = 1; i < compiler->scene->material_count; i++) {
            mark_material(compiler, &reach, i, is_light);
        }
    }
    reach_free(&reach);
    return is_found;
}

/* ---- The whole scene ------------------------------------------------------------------------ */

/* Adds a line to what `check` says. */
static void tell(struct compiler *compiler, const char *why, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

static void tell(struct compiler *compiler, const char *why, const char *format, ...) {
    struct compiled_scene *scene = compiler->scene;
    if (why == NULL) {
        return;
    }
    if (GROW(scene->dead, scene->dead_count)) {
        struct compiled_dead *entry = &scene->dead[scene->dead_count++];
        va_list arguments;
        va_start(arguments, format);
        (void)vsnprintf(entry->what, sizeof entry->what, format, arguments);
        va_end(arguments);
        entry->why = why;
    } else {
        compiler->dead->lacks_memory = true;
    }
}

static void tell_named(struct compiler *compiler, const char *why, const char *what,
                       const char *name, unsigned line) {
    if (name[0] != '\0') {
        tell(compiler, why, "%s \"%.40s\" (line %u)", what, name, line);
    } else {
        tell(compiler, why, "%s (line %u)", what, line);
    }
}

static void tell_material(struct compiler *compiler, size_t index) {
    const struct compile_dead *dead = compiler->dead;
    const struct scene_material *material = &compiler->description->materials[index];
    const struct {
        const char *what, *why;
    } parts[] = {
        {"material", dead->material[index]},      {"look of", dead->look[index]},
        {"pattern of", dead->pattern[index]},     {"table of", dead->table[index]},
        {"highlight of", dead->highlight[index]}, {"absorption of", dead->absorption[index]}};
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        tell_named(compiler, parts[i].why, parts[i].what, material->name, material->line);
    }
}

/* Reports all that is marked. Parts of one object that are dead for the same reason are reported
 * once. */
static void tell_marks(struct compiler *compiler) {
    const struct compile_dead *dead = compiler->dead;
    const struct scene_description *description = compiler->description;
    for (uint32_t i = 0; i < dead->part_count; i++) {
        const struct scene_object *object = &description->objects[dead->object_of_part[i]];
        bool is_told = i > 0 && dead->part[i] == dead->part[i - 1] &&
                       dead->object_of_part[i] == dead->object_of_part[i - 1];
        tell_named(compiler, is_told ? NULL : dead->part[i], "object",
                   object->name ? object->name : "", object->line);
    }
    for (size_t i = 0; i < description->light_count; i++) {
        tell_named(compiler, dead->light[i], "light", "", description->lights[i].line);
    }
    for (size_t i = 0; i < description->material_count; i++) {
        tell_material(compiler, i);
    }
}

/* Returns how often a straight line crosses a primitive, at most. */
static unsigned crossings_most(const struct compiled_scene *scene, uint32_t index) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    if (primitive->kind != PRIMITIVE_QUADRIC) {
        return 2;
    }
    const double *square = scene->quadrics[primitive->index].square;
    return square[0] >= 0 && square[1] >= 0 && square[2] >= 0 ? 2 : 4;
}

/* Returns how many boundaries of what lets light through a straight line crosses, at most. */
static unsigned boundaries_most(struct compiler *compiler) {
    const struct compiled_scene *scene = compiler->scene;
    bool *is_counted = calloc((size_t)scene->primitive_count + 1, sizeof *is_counted);
    unsigned most = 0;
    if (is_counted == NULL) {
        compiler->dead->lacks_memory = true;
        return SCENE_DEPTH_MOST;
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        bool counts = scene->materials[object->material].transparent;
        for (uint32_t j = 0; j < object->length && counts; j++) {
            uint32_t code = scene->programs[object->program + j];
            if (code < COMPILED_UNION && !is_counted[code]) {
                is_counted[code] = true;
                most += crossings_most(scene, code);
            }
        }
    }
    free(is_counted);
    return most;
}

/* Returns true if no ray comes back from a mirror to the same one. That holds for a convex one with
 * nothing let into it, seen from outside. */
static bool never_mirrors_itself(const struct compiler *compiler, uint32_t index) {
    const struct compiled_scene *scene = compiler->scene;
    const struct compiled_object *object = &scene->objects[index];
    for (uint32_t i = index + 1; i < scene->object_count; i++) {
        if (bounds_overlap(&scene->objects[i].bounds, &scene->objects[index].bounds)) {
            return false;
        }
    }
    return object->length == 1 &&
           scene->primitives[scene->programs[object->program]].left_for_good &&
           !compiled_object_holds(scene, index, scene->camera.eye);
}

/* Returns the most events that a path can have, judged by what can turn the path aside. */
static unsigned events_most(struct compiler *compiler) {
    const struct compiled_scene *scene = compiler->scene;
    unsigned mirrors = 0;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct compiled_material *material = &scene->materials[scene->objects[i].material];
        if (material_turns_aside(scene, material)) {
            if (material->transparent || mirrors > 0 || !never_mirrors_itself(compiler, i)) {
                return SCENE_DEPTH_MOST;
            }
            mirrors++;
        }
    }
    return boundaries_most(compiler) * (mirrors + 1) + mirrors;
}

/* Returns one more than the most events of a path that the threshold lets pass, so that the
 * threshold ends the path. An estimate looks below the threshold: no such bound then. */
static unsigned events_above_threshold(const struct compiled_scene *scene, double share) {
    if (scene->estimates || share >= 1 || scene->threshold < THRESHOLD_LEAST) {
        return SCENE_DEPTH_MOST;
    }
    double events = floor(log(scene->threshold * (1 - 0x1p-6)) / log(share));
    return events < SCENE_DEPTH_MOST ? (unsigned)events + 1 : SCENE_DEPTH_MOST;
}

static void settle_depth(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    double share = 0;
    for (uint32_t i = 1; i < scene->material_count; i++) {
        share = fmax(share, material_share_most(scene, &scene->materials[i]));
    }
    scene->has_branches = share > 0;
    scene->depth_asked = scene->depth;
    const char *why = "what is seen neither mirrors nor lets light through";
    unsigned most = 0;
    if (scene->has_branches) {
        unsigned events = events_most(compiler);
        unsigned above = events_above_threshold(scene, share);
        most = events < above ? events : above;
        why = events <= above ? "no path is mirrored or let through more often"
                              : "the threshold ends every path by then";
    }
    if (most < scene->depth) {
        scene->depth = (uint8_t)most;
        tell(compiler, why, "depth beyond %u", most);
    }
}

/* Switches off what the whole scene asks for, where nothing needs it. */
static void settle_switch(struct compiler *compiler, bool *is_on, bool is_needed, const char *what,
                          const char *why) {
    tell(compiler, *is_on && !is_needed ? why : NULL, "%s", what);
    *is_on = *is_on && is_needed;
}

bool compile_settle(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    static const char nothing_transparent[] = "nothing that is seen is transparent";
    static const char no_light[] = "no light lights anything";
    bool has_transparency = false, has_highlight = false;
    tell_marks(compiler);
    settle_depth(compiler);
    for (uint32_t i = 1; i < scene->material_count; i++) {
        const struct compiled_material *material = &scene->materials[i];
        has_transparency = has_transparency || material->transparent;
        has_highlight = has_highlight || material->specular > 0 ||
                        material->specular_table != SPECULAR_CONSTANT;
    }
    bool has_light = scene->light_count > 0;
    settle_switch(compiler, &scene->filters, has_transparency, "filters", nothing_transparent);
    settle_switch(compiler, &scene->simple, has_transparency, "simplified model",
                  nothing_transparent);
    settle_switch(compiler, &scene->fades, has_light, "fading", no_light);
    settle_switch(compiler, &scene->blinn, has_light && has_highlight, "highlights by beta",
                  has_light ? "every material's specular is 0" : no_light);
    return !compiler->dead->lacks_memory || compile_fail_memory(compiler);
}
