/* SPDX-License-Identifier: MIT */
/* Reads the solids of a scene file: trees of CSG nodes with their places and materials. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/values.h"

static const struct scene_range RANGE_ANGLE = {-3600, 3600};
static const struct scene_range RANGE_SCALE = {-1e6, 1e6};
static const double SCALE_LEAST = 1e-6;

/* The keys that hold a solid's kind, after those of the leaves. */
static const char *const node_keys[] = {"union", "intersection", "difference", "part"};
static const char *const placement_keys[] = {"material", "scale", "rotate", "translate"};

enum {
    NODE_KEYS = sizeof node_keys / sizeof *node_keys,
    PLACEMENT_KEYS = sizeof placement_keys / sizeof *placement_keys,
    SOLID_KEYS_MOST = 32
};

static bool read_solid_at(struct scene_reader *reader, const struct scene_value *group, int level,
                          int *index);

/* Computes sine and cosine of an angle in degrees: exact at right angles, so that turned boxes stay
 * aligned with the axes. */
static void sine_and_cosine(double degrees, double *sine, double *cosine) {
    double turn = fmod(degrees, 360);
    double quarters = turn / 90;
    if (floor(quarters) == quarters) {
        static const double sines[4] = {0, 1, 0, -1};
        int quarter = ((int)quarters + 4) % 4;
        *sine = sines[quarter];
        *cosine = sines[(quarter + 1) % 4];
        return;
    }
    double radians = turn * (3.14159265358979323846 / 180);
    *sine = sin(radians);
    *cosine = cos(radians);
}

/* Turns the placement about axis 0, 1 or 2, counterclockwise as seen against the axis. */
static void turn_about(struct affine *placement, int axis, double degrees) {
    double sine, cosine;
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    sine_and_cosine(degrees, &sine, &cosine);
    for (int column = 0; column < 4; column++) {
        double first = placement->m[j][column], second = placement->m[k][column];
        placement->m[j][column] = cosine * first - sine * second;
        placement->m[k][column] = sine * first + cosine * second;
    }
}

/* Reads the placement: scale, then rotate about x, y and z in turn, then translate. */
static bool read_placement(const struct scene_scope *scope, struct solid_node *node) {
    double scale[3] = {1, 1, 1}, rotate[3] = {0}, translate[3] = {0};
    if (!scope_three(scope, "scale", OPTIONAL, RANGE_SCALE, scale) ||
        !scope_numbers(scope, "rotate", OPTIONAL, RANGE_ANGLE, 3, rotate) ||
        !scope_numbers(scope, "translate", OPTIONAL, RANGE_COORDINATE, 3, translate)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        if (fabs(scale[i]) < SCALE_LEAST) {
            return scene_fail(scope->reader, scope_line(scope, "scale"),
                              "'scale' of the %s is %.10g along an axis: %.10g to %.10g is "
                              "allowed, or the same below zero for a mirror image",
                              scope->what, scale[i], SCALE_LEAST, RANGE_SCALE.most);
        }
        node->placement.m[i][i] = scale[i];
    }
    for (int axis = 0; axis < 3; axis++) {
        turn_about(&node->placement, axis, rotate[axis]);
    }
    for (int i = 0; i < 3; i++) {
        node->placement.m[i][3] = translate[i];
    }
    return true;
}

static bool read_node_material(const struct scene_scope *scope, struct solid_node *node) {
    const char *name = NULL;
    node->material = -1;
    if (!scope_string(scope, "material", OPTIONAL, &name)) {
        return false;
    }
    return !name ||
           scene_find_material(scope->reader, name, scope_line(scope, "material"), &node->material);
}

static bool set_children(struct scene_reader *reader, struct solid_node *node, const int *children,
                         size_t count) {
    node->children = scene_allocate(reader, count, sizeof *node->children);
    if (!node->children) {
        return false;
    }
    node->child_count = count;
    memcpy(node->children, children, count * sizeof *children);
    return true;
}

static bool read_children(const struct scene_scope *scope, const char *key, int level,
                          struct solid_node *node) {
    struct scene_reader *reader = scope->reader;
    const struct scene_value *list;
    int least = node->kind == SOLID_DIFFERENCE ? 2 : 1;
    if (!scope_list(scope, key, REQUIRED, least, SCENE_NODES_MOST - 1, &list)) {
        return false;
    }
    size_t count = list->count;
    int *children = scene_allocate(reader, count, sizeof *children);
    if (!children) {
        return false;
    }
    bool sound = true;
    for (size_t i = 0; sound && i < count; i++) {
        const struct scene_value *element = &list->members[i];
        sound = scene_is_group(reader, element, "solid") &&
                read_solid_at(reader, element, level + 1, &children[i]);
    }
    sound = sound && set_children(reader, node, children, count);
    free(children);
    return sound;
}

/* Returns the name of a part that is still to be read; NULL: it has none. */
static const char *part_name(const struct scene_value *part) {
    const struct scene_value *name = value_member(part, "name");
    return name != NULL && name->kind == VALUE_STRING ? name->text : NULL;
}

/* Looks for a part among those read so far only, so that no part can hold itself. */
static bool read_part_use(const struct scene_scope *scope, struct solid_node *node) {
    struct scene_reader *reader = scope->reader;
    const char *name = "";
    if (!scope_string(scope, "part", REQUIRED, &name)) {
        return false;
    }
    for (size_t i = 0; i < reader->part_count; i++) {
        if (strcmp(reader->parts[i].name, name) == 0) {
            return set_children(reader, node, &reader->parts[i].node, 1);
        }
    }
    int length = reader->part_list ? (int)reader->part_list->count : 0;
    for (int i = 0; i < length; i++) {
        const struct scene_value *part = &reader->part_list->members[i];
        const char *later = NULL;
        if (part->kind == VALUE_GROUP && (later = part_name(part)) != NULL &&
            strcmp(later, name) == 0) {
            return scene_fail(reader, scope_line(scope, "part"),
                              "part '%.40s' is only given on line %u: a part can use parts that "
                              "stand above it only, never itself",
                              name, part->line);
        }
    }
    const char *names[SCENE_NODES_MOST + 1] = {NULL};
    for (size_t i = 0; i < reader->part_count && i < SCENE_NODES_MOST; i++) {
        names[i] = reader->parts[i].name;
    }
    const char *nearest = nearest_word(name, names);
    if (nearest) {
        return scene_fail(reader, scope_line(scope, "part"),
                          "unknown part '%.40s'; did you mean '%.40s'?", name, nearest);
    }
    return scene_fail(reader, scope_line(scope, "part"),
                      "unknown part '%.40s': it has to be the 'name' of one of 'parts'", name);
}

/* Finds the one key that says what a solid is. *kind is the key's index in scene_leaves
 * followed by node_keys. */
static bool find_kind(struct scene_reader *reader, const struct scene_value *group, size_t *kind) {
    const char *keys[SOLID_KEYS_MOST + 1] = {NULL};
    size_t count = 0;
    for (size_t i = 0; i < scene_leaf_count; i++) {
        keys[count++] = scene_leaves[i].key;
    }
    for (size_t i = 0; i < NODE_KEYS; i++) {
        keys[count++] = node_keys[i];
    }
    size_t kinds = count, found = kinds;
    for (size_t i = 0; i < PLACEMENT_KEYS; i++) {
        keys[count++] = placement_keys[i];
    }
    const struct scene_scope scope = {reader, group, "solid"};
    if (!scope_check_keys(&scope, keys)) {
        return false;
    }
    for (size_t i = 0; i < kinds; i++) {
        if (!scope_has(&scope, keys[i])) {
            continue;
        }
        if (found < kinds) {
            return scene_fail(reader, scope_line(&scope, keys[i]),
                              "a solid is of one kind, and this one has both '%s' and '%s': join "
                              "two solids by union = ( {...}, {...} )",
                              keys[found], keys[i]);
        }
        found = i;
    }
    if (found == kinds) {
        return scene_fail(reader, group->line,
                          "this solid is empty: it needs box, ball, cylinder, cone, ellipsoid, "
                          "paraboloid, hyperboloid, quadric, half_space, polyhedron, union, "
                          "intersection, difference or part");
    }
    *kind = found;
    return true;
}

/* Checks that a node with its children keeps the limits, and records what is to be known of the
 * node later. */
static bool add_facts(struct scene_reader *reader, const struct solid_node *node, int index) {
    struct scene_node_facts facts = {1, 1, -1};
    for (size_t i = 0; i < node->child_count; i++) {
        const struct scene_node_facts *child = &reader->facts[node->children[i]];
        facts.instances += child->instances;
        if (child->height + 1 > facts.height) {
            facts.height = child->height + 1;
        }
        if (facts.without_material < 0) {
            facts.without_material = child->without_material;
        }
    }
    if (node->child_count == 0) {
        facts.without_material = index;
    }
    if (node->material >= 0) {
        facts.without_material = -1;
    }
    if (facts.height > SCENE_NESTING_MOST) {
        return scene_fail(reader, node->line,
                          "solids nest too deep from here: at most %d levels are allowed, those "
                          "of parts included",
                          SCENE_NESTING_MOST);
    }
    if (facts.instances > SCENE_INSTANCES_MOST) {
        return scene_fail(reader, node->line,
                          "too many solids from here: at most %d are allowed, those of a part "
                          "counted each time it is used",
                          SCENE_INSTANCES_MOST);
    }
    reader->facts[index] = facts;
    return true;
}

/* Reads what a solid of that kind needs into the node: a leaf's members, or the children. */
static bool read_body(const struct scene_scope *scope, size_t kind, int level,
                      struct solid_node *node) {
    if (kind < scene_leaf_count) {
        const struct scene_value *body;
        node->kind = (enum solid_kind)kind;
        return scope_group(scope, scene_leaves[kind].key, REQUIRED, &body) &&
               scene_leaves[kind].read(scope->reader, body, node);
    }
    size_t which = kind - scene_leaf_count;
    node->kind = (enum solid_kind)(SOLID_UNION + which);
    if (node->kind == SOLID_PART) {
        return read_part_use(scope, node);
    }
    return read_children(scope, node_keys[which], level, node);
}

static bool add_node(struct scene_reader *reader, struct solid_node *node, int *index) {
    struct scene_description *scene = reader->scene;
    if (scene->node_count == SCENE_NODES_MOST) {
        return scene_fail(reader, node->line,
                          "too many solids in the file: at most %d are allowed; a part that is "
                          "used many times counts once",
                          SCENE_NODES_MOST);
    }
    *index = (int)scene->node_count;
    if (!add_facts(reader, node, *index)) {
        return false;
    }
    scene->nodes[scene->node_count++] = *node;
    return true;
}

static bool read_solid_at(struct scene_reader *reader, const struct scene_value *group, int level,
                          int *index) {
    struct solid_node node = {.line = group->line};
    const struct scene_scope scope = {reader, group, "solid"};
    size_t kind = 0;
    if (level > SCENE_NESTING_MOST) {
        return scene_fail(reader, node.line, "solids nest too deep: at most %d levels are allowed",
                          SCENE_NESTING_MOST);
    }
    if (find_kind(reader, group, &kind) && read_placement(&scope, &node) &&
        read_node_material(&scope, &node) && read_body(&scope, kind, level, &node) &&
        add_node(reader, &node, index)) {
        return true;
    }
    free(node.planes);
    free(node.children);
    return false;
}

bool scene_read_solid(struct scene_reader *reader, const struct scene_value *group, int *index) {
    return read_solid_at(reader, group, 1, index);
}
