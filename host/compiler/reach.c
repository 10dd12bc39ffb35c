/* SPDX-License-Identifier: MIT */
/* The scene compiler: what the eye's rays, all that they turn into, and shadow rays can touch. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/dead.h"
#include "compiler/tree.h"

static const char out_of_view[] = "it is out of view, and nothing that is seen turns a ray aside";
static const char out_of_light[] =
    "it is out of view, as of the light on what is seen, and nothing "
    "that is seen turns a ray aside";
static const char is_filled[] = "a later object fills its place";
static const char is_sealed[] = "it lies within an opaque object";

/* Whether an object is whole, once that was asked. */
enum closed { CLOSED_UNKNOWN, CLOSED_NO, CLOSED_YES };

/* An object's program as a tree, and the bounds that the object lies within. */
struct solid {
    struct csg_tree tree;
    struct bounds bounds;
    struct bounds spread; /* of all its primitives */
    enum closed closed;
};

struct search {
    const struct compiled_scene *scene;
    struct solid *solids;            /* by object */
    struct neighbours spreads, seen; /* of all objects, and of those that are seen */
    struct compiled_set near, later; /* objects that were found last */
    bool has_memory;
    struct compile_reach *reach;
};

static const struct compiled_material *material_of(const struct compiled_scene *scene,
                                                   uint32_t object) {
    return &scene->materials[scene->objects[object].material];
}

/* ---- Materials ------------------------------------------------------------------------------ */

bool material_is_shaded(const struct compiled_scene *scene,
                        const struct compiled_material *material) {
    return !(scene->filters && material->transparent);
}

static bool has_specular(const struct compiled_material *material) {
    return material->specular > 0 || material->specular_table != SPECULAR_CONSTANT;
}

/* Returns true if rays bend at the material. Between media of one index, rays go straight on, and
 * nothing is reflected. */
static bool refracts(const struct compiled_scene *scene, const struct compiled_material *material) {
    return material->transparent && !scene->simple &&
           material->optical != scene->materials[0].optical;
}

static double largest(const double three[3]) {
    return fmax(three[0], fmax(three[1], three[2]));
}

static double mirror_most(const struct compiled_scene *scene,
                          const struct compiled_material *material) {
    double most = 0;
    if (material->specular_table == SPECULAR_CONSTANT) {
        return material->specular;
    }
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        most = fmax(most, scene->specular_tables[material->specular_table].specular[i]);
    }
    return most;
}

double material_share_most(const struct compiled_scene *scene,
                           const struct compiled_material *material) {
    if (!material->transparent) {
        return mirror_most(scene, material);
    }
    double through = largest(material->transmits) * (scene->simple ? material->transmittance : 1);
    return refracts(scene, material) ? fmax(through, largest(material->reflects)) : through;
}

bool material_turns_aside(const struct compiled_scene *scene,
                          const struct compiled_material *material) {
    return material_share_most(scene, material) > 0 &&
           (!material->transparent || refracts(scene, material));
}

double compiled_colour_most(const struct compiled_scene *scene,
                            const struct compiled_material *material, int channel) {
    double other =
        material->pattern != PATTERN_NONE ? scene->patterns[material->pattern].colour[channel] : 0;
    return fmax(material->colour[channel], other);
}

double compiled_colour_least(const struct compiled_scene *scene,
                             const struct compiled_material *material, int channel) {
    return material->pattern == PATTERN_NONE
               ? material->colour[channel]
               : fmin(material->colour[channel],
                      scene->patterns[material->pattern].colour[channel]);
}

static bool is_lit(const struct compiled_scene *scene, const struct compiled_material *material,
                   const struct compiled_light *light) {
    for (int i = 0; i < 3 && material_is_shaded(scene, material); i++) {
        bool scatters = material->diffuse > 0 && compiled_colour_most(scene, material, i) > 0;
        if (light->colour[i] > 0 && (scatters || has_specular(material))) {
            return true;
        }
    }
    return false;
}

/* ---- Places --------------------------------------------------------------------------------- */

/* Returns true if all of a solid is on the far side of a plane through the eye. The distance has to
 * be more than any rounding. */
static bool is_behind(const struct search *search, const struct solid *solid, double inward[3]) {
    const double *eye = search->scene->camera.eye;
    return vector_normalise(inward) && csg_reach(search->scene, &solid->tree, solid->tree.root,
                                                 inward) < vector_dot(inward, eye) - COMPILE_GAP;
}

/* Returns true if a solid reaches into the view. The view is a pyramid whose four sides go through
 * the picture's edges, half a pixel from the outermost rays. What lies behind the eye is outside of
 * the view. */
static bool is_in_view(const struct search *search, const struct solid *solid) {
    const struct compiled_scene *scene = search->scene;
    const struct compiled_camera *camera = &scene->camera;
    const double *steps[2] = {camera->column, camera->row};
    const double sizes[2] = {scene->width, scene->height};
    double inward[3];
    memcpy(inward, camera->forward, sizeof inward);
    if (is_behind(search, solid, inward)) {
        return false;
    }
    for (int side = 0; side < 4; side++) {
        const double *step = steps[side / 2];
        double length = vector_length(step), sign = side % 2 != 0 ? 1 : -1;
        double half = ldexp(length, -camera->shift) * sizes[side / 2] /
                      vector_dot(camera->forward, camera->forward);
        for (int i = 0; i < 3; i++) {
            inward[i] = half * camera->forward[i] + sign * step[i] / length;
        }
        if (is_behind(search, solid, inward)) {
            return false;
        }
    }
    return true;
}

/* Returns true if a part of a solid lies strictly within a primitive. With may_be_it, a part that
 * is the primitive itself will do, too. */
static bool lies_within(const struct search *search, const struct csg_tree *tree, uint32_t index,
                        uint32_t primitive, bool may_be_it) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return node->code == primitive ? may_be_it
                                       : primitive_is_within(search->scene, node->code, primitive);
    }
    if (node->code == COMPILED_DIFFERENCE) {
        return lies_within(search, tree, node->left, primitive, may_be_it);
    }
    const bool one_will_do = node->code == COMPILED_INTERSECTION;
    return lies_within(search, tree, node->left, primitive, may_be_it) == one_will_do
               ? one_will_do
               : lies_within(search, tree, node->right, primitive, may_be_it);
}

static bool object_lies_within(const struct search *search, uint32_t inner, uint32_t outer,
                               bool may_be_it) {
    const struct csg_tree *tree = &search->solids[inner].tree;
    const struct compiled_object *object = &search->scene->objects[outer];
    return object->length == 1 && lies_within(search, tree, tree->root,
                                              search->scene->programs[object->program], may_be_it);
}

static bool are_one_solid(const struct compiled_scene *scene, uint32_t one, uint32_t other) {
    const struct compiled_object *a = &scene->objects[one], *b = &scene->objects[other];
    return a->length == b->length &&
           memcmp(&scene->programs[a->program], &scene->programs[b->program],
                  a->length * sizeof *scene->programs) == 0;
}

/* Finds the objects that may meet bounds, in ascending order. Where memory is out, none is found.
 */
static void find_near(struct search *search, const struct neighbours *among,
                      const struct bounds *bounds, struct compiled_set *found) {
    if (!search->has_memory || !neighbours_find(among, bounds, COMPILE_GAP, found)) {
        search->has_memory = false;
        found->count = 0;
    }
}

/* Returns true if no later object reaches out of an object. */
static bool holds_later_ones(struct search *search, uint32_t object) {
    const struct bounds *bounds = &search->solids[object].bounds;
    find_near(search, &search->spreads, bounds, &search->later);
    for (uint32_t k = 0; k < search->later.count; k++) {
        const uint32_t i = search->later.members[k];
        if (i > object && !bounds_are_apart(&search->solids[i].bounds, bounds, COMPILE_GAP) &&
            !object_lies_within(search, i, object, false)) {
            return false;
        }
    }
    return true;
}

/* Returns true if an opaque object is whole and the eye is outside. Whole means: no later object
 * reaches out of the opaque one, to let a ray come in. */
static bool is_closed(struct search *search, uint32_t object) {
    const struct compiled_scene *scene = search->scene;
    enum closed *closed = &search->solids[object].closed;
    if (*closed == CLOSED_UNKNOWN) {
        const bool is = !material_of(scene, object)->transparent &&
                        !compiled_object_holds(scene, object, scene->camera.eye) &&
                        holds_later_ones(search, object);
        *closed = is ? CLOSED_YES : CLOSED_NO;
    }
    return *closed == CLOSED_YES;
}

/* Returns the reason why no ray can meet an object; NULL if a ray may meet the object. */
static const char *find_cover(struct search *search, uint32_t object) {
    find_near(search, &search->spreads, &search->solids[object].spread, &search->near);
    for (uint32_t k = 0; k < search->near.count; k++) {
        const uint32_t i = search->near.members[k];
        if (i > object && (are_one_solid(search->scene, i, object) ||
                           object_lies_within(search, object, i, true))) {
            return is_filled;
        }
        if (i < object && object_lies_within(search, object, i, false) && is_closed(search, i)) {
            return is_sealed;
        }
    }
    return NULL;
}

/* ---- Paths from the eye --------------------------------------------------------------------- */

static bool sends_paths_anywhere(const struct search *search) {
    const struct compiled_scene *scene = search->scene;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        if (search->reach->is_seen[i] && material_turns_aside(scene, material_of(scene, i))) {
            return scene->depth > 0 || scene->estimates;
        }
    }
    return false;
}

static void follow_paths(struct search *search) {
    const struct compiled_scene *scene = search->scene;
    struct compile_reach *reach = search->reach;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        reach->lost[i] = find_cover(search, i);
        reach->is_seen[i] = reach->lost[i] == NULL && is_in_view(search, &search->solids[i]);
    }
    bool anywhere = sends_paths_anywhere(search);
    for (uint32_t i = 1; i < scene->object_count; i++) {
        reach->is_seen[i] = reach->is_seen[i] || (anywhere && reach->lost[i] == NULL);
        if (reach->is_seen[i]) {
            reach->is_shown[scene->objects[i].material] = true;
            search->has_memory =
                search->has_memory && neighbours_add(&search->seen, &search->solids[i].spread, i);
        }
    }
}

/* ---- Shadow rays ---------------------------------------------------------------------------- */

static void find_lights(struct search *search) {
    const struct compiled_scene *scene = search->scene;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        for (uint32_t j = 1; j < scene->material_count; j++) {
            search->reach->lights[i] = search->reach->lights[i] ||
                                       (search->reach->is_shown[j] &&
                                        is_lit(scene, &scene->materials[j], &scene->lights[i]));
        }
    }
}

/* Returns bounds of the path from anywhere on a solid to a light. */
static struct bounds way_to_light(const struct solid *from, const struct compiled_light *light) {
    struct bounds way = from->bounds;
    if (!light->parallel) {
        bounds_include(&way, light->position);
        return way;
    }
    for (int i = 0; i < 3; i++) {
        way.high[i] = light->towards[i] > 0 ? HUGE_VAL : way.high[i];
        way.low[i] = light->towards[i] < 0 ? -HUGE_VAL : way.low[i];
    }
    return way;
}

/* Returns bounds of all that has what lies within some bounds on its path to a light. They are
 * these bounds without an end on the side that is turned away from the light. */
static struct bounds shade_of(const struct bounds *bounds, const struct compiled_light *light) {
    struct bounds shade = *bounds;
    for (int i = 0; i < 3; i++) {
        const double at = light->position[i];
        const bool is_below =
            light->parallel ? light->towards[i] < 0 : at < bounds->low[i] - 2 * COMPILE_GAP;
        const bool is_above =
            light->parallel ? light->towards[i] > 0 : at > bounds->high[i] + 2 * COMPILE_GAP;
        if (is_above || (!is_below && !light->parallel)) {
            shade.low[i] = -HUGE_VAL;
        }
        if (is_below || (!is_above && !light->parallel)) {
            shade.high[i] = HUGE_VAL;
        }
    }
    return shade;
}

/* Returns true if an object may be met between something lit and a light. */
static bool is_in_light(struct search *search, uint32_t object) {
    const struct compiled_scene *scene = search->scene;
    const struct bounds *bounds = &search->solids[object].bounds;
    for (uint32_t j = 0; j < scene->light_count; j++) {
        const struct compiled_light *light = &scene->lights[j];
        const struct bounds shade = shade_of(bounds, light);
        find_near(search, &search->seen, &shade, &search->near);
        for (uint32_t k = 0; k < search->near.count; k++) {
            const uint32_t i = search->near.members[k];
            const struct bounds way = way_to_light(&search->solids[i], light);
            if (is_lit(scene, material_of(scene, i), light) &&
                !bounds_are_apart(&way, bounds, COMPILE_GAP)) {
                return true;
            }
        }
    }
    return false;
}

/* Returns true if an object keeps light off, or may fill a part of an earlier object that does. */
static bool matters_to_shadows(struct search *search, uint32_t object) {
    const struct compiled_scene *scene = search->scene;
    const struct bounds *bounds = &search->solids[object].bounds;
    if (material_of(scene, object)->casts_shadow) {
        return true;
    }
    find_near(search, &search->spreads, bounds, &search->near);
    for (uint32_t k = 0; k < search->near.count && search->near.members[k] < object; k++) {
        const uint32_t i = search->near.members[k];
        if (material_of(scene, i)->casts_shadow &&
            !bounds_are_apart(&search->solids[i].bounds, bounds, COMPILE_GAP)) {
            return true;
        }
    }
    return false;
}

static void follow_shadow_rays(struct search *search) {
    struct compile_reach *reach = search->reach;
    for (uint32_t i = 1; i < search->scene->object_count; i++) {
        if (reach->is_seen[i] || reach->lost[i] != NULL) {
            continue;
        }
        if (!matters_to_shadows(search, i)) {
            reach->lost[i] = out_of_view;
        } else if (!is_in_light(search, i)) {
            reach->lost[i] = out_of_light;
        }
    }
}

/* Returns the bounds of all primitives of an object: what lies within one of them, too, is near. */
static struct bounds spread_of(const struct compiled_scene *scene,
                               const struct compiled_object *object) {
    struct bounds all = bounds_nothing;
    for (uint32_t i = 0; i < object->length; i++) {
        const uint32_t code = scene->programs[object->program + i];
        if (code < COMPILED_UNION) {
            const struct bounds one = primitive_bounds(scene, code);
            bounds_include(&all, one.low);
            bounds_include(&all, one.high);
        }
    }
    return all;
}

/* Reads the objects' programs; false if memory is out. */
static bool read_solids(struct search *search) {
    const struct compiled_scene *scene = search->scene;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        struct solid *solid = &search->solids[i];
        if (!csg_read(scene, &scene->objects[i], &solid->tree)) {
            return false;
        }
        solid->bounds = csg_bounds(scene, &solid->tree, solid->tree.root);
        solid->spread = spread_of(scene, &scene->objects[i]);
        if (!neighbours_add(&search->spreads, &solid->spread, i)) {
            return false;
        }
    }
    return true;
}

static void free_solids(struct search *search) {
    for (uint32_t i = 0; i < search->scene->object_count && search->solids != NULL; i++) {
        csg_free(&search->solids[i].tree);
    }
    free(search->solids);
    neighbours_clear(&search->spreads);
    neighbours_clear(&search->seen);
    compiled_set_clear(&search->near);
    compiled_set_clear(&search->later);
}

bool compile_find_reach(struct compiler *compiler, struct compile_reach *reach) {
    const struct compiled_scene *scene = compiler->scene;
    const struct compile_reach found = {
        .lost = calloc(scene->object_count, sizeof *reach->lost),
        .is_seen = calloc(scene->object_count, sizeof *reach->is_seen),
        .lights = calloc((size_t)scene->light_count + 1, sizeof *reach->lights)};
    struct search search = {.scene = scene,
                            .solids = calloc(scene->object_count, sizeof *search.solids),
                            .reach = reach,
                            .has_memory = true};
    *reach = found;
    bool is_read = found.lost != NULL && found.is_seen != NULL && found.lights != NULL &&
                   search.solids != NULL && read_solids(&search);
    if (is_read) {
        follow_paths(&search);
        find_lights(&search);
        follow_shadow_rays(&search);
    }
    free_solids(&search);
    return (is_read && search.has_memory) || compile_fail_memory(compiler);
}

void reach_free(struct compile_reach *reach) {
    free(reach->lost);
    free(reach->is_seen);
    free(reach->lights);
}
