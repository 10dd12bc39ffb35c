/* SPDX-License-Identifier: MIT */
/* Reads the solids of a scene file: trees of CSG nodes with their places and materials. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/keys.h"

static const struct scene_range angles = {-3600, 3600, NULL};
static const struct scene_range scales = {-1e6, 1e6, "±10⁻⁶ to ±10⁶"};
static const struct scene_range one_or_more = {1, INFINITY, NULL};
static const struct scene_range two_or_more = {2, INFINITY, NULL};
static const double SCALE_LEAST = 1e-6;

/* Holds what stands beside a solid's kind. */
struct placement {
    double scale[3], rotate[3], translate[3];
    const char *material, *part;
};

static const struct placement placement_defaults = {.scale = {1, 1, 1}};

#define LEAF_ROW(kind, meaning_)                                                                   \
    { .name = (kind), .type = KEY_GROUP, .meaning = (meaning_) }
#define NODE_ROW(kind, least, meaning_)                                                            \
    { .name = (kind), .type = KEY_LIST, .range = &(least), .meaning = (meaning_) }

/* The kinds by enum solid_kind, then what may stand beside any kind. */
static const struct scene_key solid_rows[] = {
    [SOLID_BOX] = LEAF_ROW("box", "parallel to the axes; min is less than max along each"),
    [SOLID_BALL] = LEAF_ROW("ball", ""),
    [SOLID_CYLINDER] =
        LEAF_ROW("cylinder", "round its axis from one point to the other, flat at both ends"),
    [SOLID_CONE] = LEAF_ROW("cone", "the radius grows or shrinks from one end to the other; 0 at "
                                    "one of them is a tip. Equal radii are a cylinder, and "
                                    "refused"),
    [SOLID_ELLIPSOID] = LEAF_ROW("ellipsoid", "`radii` along x, y, z"),
    [SOLID_PARABOLOID] =
        LEAF_ROW("paraboloid", "its apex is `from`; `radius` is that of its flat end at `to`"),
    [SOLID_HYPERBOLOID] = LEAF_ROW("hyperboloid", "below"),
    [SOLID_QUADRIC] =
        LEAF_ROW("quadric", "the points with a·x² + b·y² + c·z² + d·xy + e·yz + f·zx + g·x + h·y + "
                            "i·z + j ≤ 0, given as (a, b, c, d, e, f, g, h, i, j); one of a to f "
                            "is not 0"),
    [SOLID_HALF_SPACE] =
        LEAF_ROW("half_space", "the points with normal·p ≤ offset, or behind the plane through a "
                               "point. `normal` points out of the solid"),
    [SOLID_POLYHEDRON] = LEAF_ROW(
        "polyhedron", "the points that are in all of the half-spaces, each given as above. "
                      "It has to be bounded: so pyramids, frustums, prisms, "
                      "parallelepipeds"),
    [SOLID_UNION] =
        NODE_ROW("union", one_or_more, "the points in any of them, without inner faces"),
    [SOLID_INTERSECTION] = NODE_ROW("intersection", one_or_more, "the points in all of them"),
    [SOLID_DIFFERENCE] = NODE_ROW("difference", two_or_more,
                                  "the points of the first that are in none of the others"),
    [SOLID_PART] = {KEY_AT("part", KEY_TEXT, placement, part), .noun = "a part's name",
                    .meaning = "that solid, again"},
    {KEY_AT("material", KEY_TEXT, placement, material), .noun = "a material's name",
     .fallback = "the surrounding solid's, or the object's",
     .meaning = "what the solid is made of. `\"air\"` need not be described"},
    {THREE_KEY("scale", placement, scale, scales),
     .meaning = "along x, y, z, from the origin; below 0 it mirrors too"},
    {NUMBERS_KEY("rotate", placement, rotate, 3, angles), .noun = "3 angles",
     .meaning =
         "about the x axis, then y, then z; counterclockwise as seen from the axis's far end"},
    {NUMBERS_KEY("translate", placement, translate, 3, RANGE_COORDINATE), .noun = "3 lengths",
     .meaning = "along x, y, z, as the last of the three"}};
const struct scene_keys scene_solid_keys = SCENE_KEYS("solid", solid_rows, &placement_defaults);

static int read_solid_at(struct scene_reader *reader, const struct scene_value *group, int level);

/* Computes sine and cosine of an angle in degrees: exact at right angles, so that turned boxes stay
 * aligned with the axes. */
static void sine_and_cosine(double turned, double *sine, double *cosine) {
    double turn = fmod(turned, 360);
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
static void turn_about(struct affine *placement, int axis, double turned) {
    double sine, cosine;
    int j = (axis + 1) % 3, k = (axis + 2) % 3;
    sine_and_cosine(turned, &sine, &cosine);
    for (int column = 0; column < 4; column++) {
        double first = placement->m[j][column], second = placement->m[k][column];
        placement->m[j][column] = cosine * first - sine * second;
        placement->m[k][column] = sine * first + cosine * second;
    }
}

/* Places a node: scale, then rotate about x, y and z in turn, then translate. */
static void place(const struct scene_scope *scope, const struct placement *read,
                  struct solid_node *node) {
    for (int i = 0; i < 3; i++) {
        if (fabs(read->scale[i]) < SCALE_LEAST) {
            (void)scene_fail(scope->reader, scene_place_of(scope->group, "scale"),
                             "'scale' of the %s is %.10g along an axis: %.10g to %.10g is "
                             "allowed, or the same below zero for a mirror image",
                             scope->what, read->scale[i], SCALE_LEAST, scales.most);
            return;
        }
        node->placement.m[i][i] = read->scale[i];
    }
    for (int axis = 0; axis < 3; axis++) {
        turn_about(&node->placement, axis, read->rotate[axis]);
    }
    for (int i = 0; i < 3; i++) {
        node->placement.m[i][3] = read->translate[i];
    }
}

/* Reads the children of a node. Returns false where one was refused. */
static bool read_children(struct scene_reader *reader, const struct scene_value *list, int level,
                          struct solid_node *node) {
    int *children = scene_allocate(reader, list->count, sizeof *children);
    bool is_good = children != NULL && !list->is_partial;
    for (size_t i = 0; children != NULL && i < list->count; i++) {
        children[i] = read_solid_at(reader, &list->members[i], level + 1);
        is_good = is_good && children[i] >= 0;
    }
    node->children = children;
    node->child_count = list->count;
    return is_good;
}

/* Returns the name of a part that is still to be read; NULL: the part has no name. */
static const char *part_name(const struct scene_value *part) {
    const struct scene_value *name = part->kind == VALUE_GROUP ? value_member(part, "name") : NULL;
    return name != NULL && name->kind == VALUE_STRING ? name->text : NULL;
}

/* Refuses a part that is not known, or is known only below. */
static void refuse_part(struct scene_reader *reader, const char *name, struct scene_place at) {
    const char **names = calloc(reader->part_count + 1, sizeof *names), *nearest = NULL;
    for (size_t i = 0; reader->part_list != NULL && i < reader->part_list->count; i++) {
        const struct scene_value *part = &reader->part_list->members[i];
        const char *later = part_name(part);
        if (later != NULL && strcmp(later, name) == 0) {
            (void)scene_fail(reader, at,
                             "part '%.40s' is only given on line %u: a part can use parts that "
                             "stand above it only, never itself",
                             name, part->at.line);
            free(names);
            return;
        }
    }
    for (size_t i = 0; names != NULL && i < reader->part_count; i++) {
        names[i] = reader->parts[i].name;
    }
    nearest = names != NULL ? nearest_word(name, names) : NULL;
    free(names);
    if (nearest != NULL) {
        (void)scene_fail(reader, at, "unknown part '%.40s'; did you mean '%.40s'?", name, nearest);
    } else {
        (void)scene_fail(reader, at,
                         "unknown part '%.40s': it has to be the 'name' of one of 'parts'", name);
    }
}

/* Looks for a part among those read so far only, so that no part can hold itself. Returns false
 * where there is none, or where it was refused. */
static bool use_part(const struct scene_scope *scope, const char *name, struct solid_node *node) {
    struct scene_reader *reader = scope->reader;
    for (size_t i = 0; i < reader->part_count; i++) {
        if (strcmp(reader->parts[i].name, name) == 0) {
            node->children = &reader->parts[i].node;
            node->child_count = 1;
            return reader->parts[i].node >= 0;
        }
    }
    if (reader->knows_parts) {
        refuse_part(reader, name, scene_place_of(scope->group, "part"));
    }
    return false;
}

/* Finds the one key that says what a solid is. Returns false where there is none, or two. That
 * there is none is said unless a key was refused, which may be meant as one. */
static bool find_kind(const struct scene_scope *scope, bool is_good, enum solid_kind *kind) {
    const char *found = NULL;
    for (int i = 0; i < SCENE_KINDS; i++) {
        const char *key = solid_rows[i].name;
        if (value_member(scope->group, key) == NULL) {
            continue;
        }
        if (found != NULL) {
            return scene_fail(scope->reader, scene_place_of(scope->group, key),
                              "a solid is of one kind, and this one has both '%s' and '%s': join "
                              "two solids by union = ( {...}, {...} )",
                              found, key);
        }
        found = key;
        *kind = (enum solid_kind)i;
    }
    return found != NULL ||
           (is_good &&
            scene_fail(scope->reader, scope->group->at,
                       "this solid is empty: it needs box, ball, cylinder, cone, ellipsoid, "
                       "paraboloid, hyperboloid, quadric, half_space, polyhedron, union, "
                       "intersection, difference or part"));
}

/* Reads what a solid of that kind needs into the node: a leaf's members, or the children. Returns
 * false where some of it was refused. */
static bool read_body(const struct scene_scope *scope, const char *part, int level,
                      struct solid_node *node) {
    const char *key = solid_rows[node->kind].name;
    if (node->kind == SOLID_PART) {
        return part != NULL && use_part(scope, part, node);
    }
    if (node->kind >= SOLID_UNION) {
        const struct scene_value *list = scene_find_list(scope->group, key);
        return list != NULL && read_children(scope->reader, list, level, node);
    }
    const struct scene_leaf *leaf = &scene_leaves[node->kind];
    const struct scene_scope body = {scope->reader, scene_find_group(scope->group, key), key};
    const size_t before = scope->reader->refusal_count;
    if (body.group == NULL || !scene_read_keys(&body, &leaf->keys, node)) {
        return false;
    }
    if (leaf->check != NULL) {
        leaf->check(&body, node);
    }
    return scope->reader->refusal_count == before;
}

/* Checks that a node with its children keeps the limits, and records what is to be known of the
 * node later. */
static bool add_facts(struct scene_reader *reader, const struct solid_node *node,
                      struct scene_place at, int index) {
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
    reader->facts[index] = facts;
    if (facts.height > SCENE_NESTING_MOST) {
        return scene_fail(reader, at,
                          "solids nest too deep from here: at most %d levels are allowed, those "
                          "of parts included",
                          SCENE_NESTING_MOST);
    }
    return facts.instances <= SCENE_INSTANCES_MOST ||
           scene_fail(reader, at,
                      "too many solids from here: at most %d are allowed, those of a part "
                      "counted each time it is used",
                      SCENE_INSTANCES_MOST);
}

/* Adds a node to the scene's. Returns its place; -1 with the failure recorded. */
static int add_node(struct scene_reader *reader, const struct solid_node *node,
                    struct scene_place at) {
    struct scene_description *scene = reader->scene;
    const size_t count = scene->node_count;
    size_t room = reader->node_room;
    struct solid_node *nodes = scene_grow(reader, scene->nodes, count, &room, sizeof *nodes);
    if (nodes == NULL) {
        return -1;
    }
    scene->nodes = nodes;
    struct scene_node_facts *facts =
        scene_grow(reader, reader->facts, count, &reader->node_room, sizeof *facts);
    if (facts == NULL) {
        return -1;
    }
    reader->facts = facts;
    if (!add_facts(reader, node, at, (int)count)) {
        return -1;
    }
    scene->nodes[scene->node_count++] = *node;
    return (int)count;
}

static int read_solid_at(struct scene_reader *reader, const struct scene_value *group, int level) {
    const struct scene_scope scope = {reader, group, scene_solid_keys.what};
    struct solid_node node = {.line = group->at.line, .material = -1};
    struct placement read = placement_defaults;
    if (level > SCENE_NESTING_MOST) {
        (void)scene_fail(reader, group->at, "solids nest too deep: at most %d levels are allowed",
                         SCENE_NESTING_MOST);
        return -1;
    }
    bool is_good = scene_read_keys(&scope, &scene_solid_keys, &read);
    if (group->kind != VALUE_GROUP || !find_kind(&scope, is_good, &node.kind)) {
        return -1;
    }
    if (is_good) {
        const size_t before = reader->refusal_count;
        place(&scope, &read, &node);
        is_good = reader->refusal_count == before;
    }
    if (read.material != NULL &&
        !scene_find_material(reader, read.material, scene_place_of(group, "material"),
                             &node.material)) {
        is_good = false;
    }
    return read_body(&scope, read.part, level, &node) && is_good
               ? add_node(reader, &node, group->at)
               : -1;
}

int scene_read_solid(struct scene_reader *reader, const struct scene_value *group) {
    return read_solid_at(reader, group, 1);
}
