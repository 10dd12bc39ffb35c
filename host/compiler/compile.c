/* SPDX-License-Identifier: MIT */
/* The scene compiler: from a description to the firmware's tables, centred and scaled. */
#include "compiler/dead.h"
#include "scene/load.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A scene whose contents reach less far has no scale. */
#define REACH_LEAST 1e-12

/* Tells whether every part of an object of the file is dead, and there are some. *part is the first
 * of the part's numbers that may be its own, and becomes that of the next object. */
static bool object_is_dead(const struct compile_dead *dead, size_t object, uint32_t *part) {
    bool has_part = false, is_dead = true;
    for (; *part < dead->part_count && dead->object_of_part[*part] == object; ++*part) {
        has_part = true;
        is_dead = is_dead && dead->part[*part] != NULL;
    }
    return has_part && is_dead;
}

/* Returns the bounds of all that has an end: finite solids, the eye, the point lights. Leaves out
 * what is dead; dead is NULL to leave out nothing. */
static struct bounds content_bounds(const struct scene_description *description,
                                    const struct compile_dead *dead) {
    struct bounds all = bounds_nothing;
    uint32_t part = 0;
    bounds_include(&all, description->camera.eye);
    for (size_t i = 0; i < description->light_count; i++) {
        if (!description->lights[i].parallel && (dead == NULL || dead->light[i] == NULL)) {
            bounds_include(&all, description->lights[i].position);
        }
    }
    for (size_t i = 0; i < description->object_count; i++) {
        if (dead != NULL && object_is_dead(dead, i, &part)) {
            continue;
        }
        struct bounds solid =
            solid_bounds(description, description->objects[i].solid, &affine_identity);
        if (bounds_are_finite(&solid) && !bounds_are_empty(&solid)) {
            all = bounds_union(&all, &solid);
        }
    }
    return all;
}

/* The error of a file's coordinates after a few roundings, relative to the farthest of them. */
#define FILE_ROUNDING 0x1p-50

static double bounds_half(const struct bounds *bounds) {
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        reach = fmax(reach, bounds->high[i] / 2 - bounds->low[i] / 2);
    }
    return reach;
}

/* Refuses a scene that has no size: a polyhedron that is open, or nothing but half-spaces. */
static bool fail_without_size(struct compiler *compiler, double reach) {
    const struct scene_description *from = compiler->description;
    for (size_t i = 0; i < from->node_count && reach < REACH_LEAST; i++) {
        if (from->nodes[i].kind != SOLID_POLYHEDRON) {
            continue;
        }
        struct bounds bounds = solid_bounds(from, (int)i, &affine_identity);
        if (!bounds_are_finite(&bounds)) {
            return compile_fail(compiler, from->nodes[i].line,
                                "a polyhedron without an end, and nothing else that has a size: "
                                "add the planes that close it");
        }
    }
    return reach < REACH_LEAST
               ? compile_fail(compiler, 0,
                              "nothing here has a size (solids, eye and lights lie within %g "
                              "units): add a bounded solid, or give a light a place",
                              reach)
               : compile_fail(compiler, 0,
                              "solids, eye and lights reach %g units from their middle; up to 1e12 "
                              "is allowed: choose another unit of length",
                              reach);
}

/* Scales by what is not dead. Dead things count, too, where something endless is seen, as they
 * decide where it ends. They also count where nothing else has a size, or where compile_round()
 * asks for them. */
bool compile_scaling(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    const bool is_whole = compiler->dead->has_endless || compiler->dead->keeps_scale;
    const struct compile_dead *dead = is_whole ? NULL : compiler->dead;
    struct bounds all = content_bounds(compiler->description, dead);
    if (!(bounds_half(&all) >= REACH_LEAST)) {
        all = content_bounds(compiler->description, NULL);
    }
    double reach = bounds_half(&all);
    for (int i = 0; i < 3; i++) {
        scene->centre[i] = all.low[i] / 2 + all.high[i] / 2;
    }
    if (!(reach <= 1e12 && reach >= REACH_LEAST)) {
        return fail_without_size(compiler, reach);
    }
    scene->exponent = (int)floor(log2(COMPILE_EXTENT / reach));
    scene->has_world = compiler->description->world > 0;
    if (scene->has_world) {
        int farther = (int)floor(log2(COMPILE_WORLD / compiler->description->world));
        scene->exponent = farther < scene->exponent ? farther : scene->exponent;
    }
    double farthest = 0;
    for (int i = 0; i < 3; i++) {
        farthest = fmax(farthest, fmax(fabs(all.low[i]), fabs(all.high[i])));
    }
    double weld = compiler->description->weld;
    compiler->same = fmax(COMPILE_SAME, ldexp(FILE_ROUNDING * farthest, scene->exponent));
    compiler->same = fmax(compiler->same, ldexp(weld, scene->exponent));
    if (compiler->same > COMPILE_WELD_MOST) {
        return compile_fail(compiler, 0,
                            weld > 0 ? "'weld' is %g; at most %g is allowed for this scene's size"
                                     : "the file's numbers are rounded to %g so far from the "
                                       "origin; at most %g is allowed: move the scene nearer to it",
                            weld > 0 ? weld : FILE_ROUNDING * farthest,
                            ldexp(COMPILE_WELD_MOST, -scene->exponent));
    }
    compiler->scaling = affine_identity;
    for (int i = 0; i < 3; i++) {
        compiler->scaling.m[i][i] = ldexp(1, scene->exponent);
        compiler->scaling.m[i][3] = -ldexp(scene->centre[i], scene->exponent);
    }
    return true;
}

/* Takes one step and shows the tables where it succeeds. */
static bool step(struct compiler *compiler, bool (*work)(struct compiler *compiler),
                 enum compile_step done) {
    if (!work(compiler)) {
        return false;
    }
    compile_show(compiler, done);
    return true;
}

/* Meets the world's axes first: what counts as one of these is it. */
static bool meet_axes(struct compiler *compiler) {
    for (int i = 0; i < 3; i++) {
        double axis[3] = {i == 0, i == 1, i == 2};
        if (!compile_direction(compiler, axis)) {
            return false;
        }
    }
    return true;
}

/* Makes the tables of what is not dead so far. */
static bool compile_tables(struct compiler *compiler) {
    if (!compile_scaling(compiler) || !meet_axes(compiler) || !compile_materials(compiler) ||
        !step(compiler, compile_objects, STEP_OBJECTS) ||
        !step(compiler, compile_optimise, STEP_COMPACT) || !compile_pattern_faces(compiler) ||
        !step(compiler, compile_view, STEP_VIEW) || !compile_colour(compiler)) {
        return false;
    }
    return compile_lights(compiler);
}

/* Frees the tables of a round that are not the scene's. */
static void end(struct compiler *compiler) {
    free(compiler->planes);
    free(compiler->directions);
    buckets_clear(&compiler->known);
    curves_clear(&compiler->curves);
    neighbours_clear(&compiler->solids);
}

/* Forgets all of the last round but what is dead. */
static void begin(struct compiler *compiler) {
    const struct compiler fresh = {.description = compiler->description,
                                   .scene = compiler->scene,
                                   .error = compiler->error,
                                   .observer = compiler->observer,
                                   .dead = compiler->dead};
    end(compiler);
    *compiler = fresh;
    compiled_scene_clear(compiler->scene);
    snprintf(compiler->scene->path, sizeof compiler->scene->path, "%s",
             compiler->description->path);
}

/* Makes the tables. Where what is left fails at its own scale, makes them again at the whole
 * scene's. */
static bool compile_round(struct compiler *compiler) {
    begin(compiler);
    if (compile_tables(compiler)) {
        return true;
    }
    if (compiler->dead->count == 0 || compiler->dead->keeps_scale) {
        return false;
    }
    compiler->dead->keeps_scale = true;
    begin(compiler);
    return compile_tables(compiler);
}

/* Checks that the file's materials have room. */
static bool check_room(struct compiler *compiler) {
    const struct scene_description *from = compiler->description;
    if (from->material_count >= COMPILED_MATERIALS_MOST) {
        return compile_fail(compiler, from->materials[COMPILED_MATERIALS_MOST - 1].line,
                            "the scene has %zu materials: at most %d are allowed",
                            from->material_count, COMPILED_MATERIALS_MOST - 1);
    }
    return true;
}

/* Makes the tables, and makes them anew as long as they prove more to be dead. What is left may
 * have another scale then. */
static bool compile_live(struct compiler *compiler) {
    unsigned known;
    if (!check_room(compiler)) {
        return false;
    }
    compiler->dead->light =
        calloc(compiler->description->light_count + 1, sizeof *compiler->dead->light);
    if (compiler->dead->light == NULL) {
        return compile_fail_memory(compiler);
    }
    do {
        known = compiler->dead->count;
        if (!compile_round(compiler) || !compile_find_dead(compiler)) {
            return false;
        }
    } while (compiler->dead->count > known);
    if (!compile_settle(compiler)) {
        return false;
    }
    compile_light_bounds(compiler);
    return step(compiler, compile_shadows, STEP_SHADOWS) && compile_solids(compiler) &&
           step(compiler, compile_enclosures, STEP_ENCLOSURES) && compile_near(compiler) &&
           compile_nesting(compiler) && compile_hierarchy(compiler) && compile_uses(compiler);
}

struct compiled_scene *scene_compile_observed(const struct scene_description *description,
                                              const struct compile_observer *observer,
                                              struct scene_error *error) {
    struct compiled_scene *scene = calloc(1, sizeof *scene);
    struct compile_dead dead = {.count = 0};
    if (scene == NULL) {
        snprintf(error->text, sizeof error->text, "%.100s: out of memory", description->path);
        return NULL;
    }
    struct compiler compiler = {.description = description,
                                .scene = scene,
                                .error = error,
                                .observer = observer,
                                .dead = &dead};
    bool is_done = compile_live(&compiler);
    end(&compiler);
    free(dead.part);
    free(dead.light);
    free(dead.object_of_part);
    if (!is_done) {
        compiled_scene_free(scene);
        return NULL;
    }
    return scene;
}

struct compiled_scene *scene_compile(const struct scene_description *description,
                                     struct scene_error *error) {
    return scene_compile_observed(description, NULL, error);
}

struct compiled_scene *load_compiled_scene(const char *name_or_path,
                                           const struct scene_overrides *overrides,
                                           struct scene_error *error) {
    struct scene_description *description = load_scene_with(name_or_path, overrides, error);
    if (description == NULL) {
        return NULL;
    }
    struct compiled_scene *compiled = scene_compile(description, error);
    scene_description_free(description);
    return compiled;
}
