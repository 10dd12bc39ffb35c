/* SPDX-License-Identifier: MIT */
/* Reads the named parts of a scene file and the objects that it shows. */
#include <stdlib.h>
#include <string.h>

#include "scene/values.h"

/* Allocates the nodes' table, as large as a file may need; trim_nodes() shortens the table. */
static bool make_nodes(struct scene_reader *reader) {
    struct scene_description *scene = reader->scene;
    scene->nodes = scene_allocate(reader, SCENE_NODES_MOST, sizeof *scene->nodes);
    return scene->nodes != NULL;
}

static void trim_nodes(struct scene_description *scene) {
    struct solid_node *trimmed = realloc(scene->nodes, scene->node_count * sizeof *scene->nodes);
    if (trimmed) {
        scene->nodes = trimmed;
    }
}

static bool read_part(struct scene_reader *reader, const struct scene_value *group) {
    static const char *const keys[] = {"name", "solid", NULL};
    const struct scene_scope scope = {reader, group, "part"};
    const struct scene_value *solid;
    struct scene_part part = {"", 0};
    if (!scene_is_group(reader, group, "part") || !scope_check_keys(&scope, keys) ||
        !scope_string(&scope, "name", REQUIRED, &part.name) ||
        !scope_group(&scope, "solid", REQUIRED, &solid)) {
        return false;
    }
    if (!*part.name) {
        return scene_fail(reader, scope_line(&scope, "name"),
                          "'name' of the part is empty: it needs a name to be used by");
    }
    for (size_t i = 0; i < reader->part_count; i++) {
        if (strcmp(reader->parts[i].name, part.name) == 0) {
            return scene_fail(reader, scope_line(&scope, "name"),
                              "duplicate part '%.40s': each part needs a name of its own",
                              part.name);
        }
    }
    if (!scene_read_solid(reader, solid, &part.node)) {
        return false;
    }
    reader->parts[reader->part_count++] = part;
    return true;
}

bool scene_read_parts(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_scope top = {reader, root, "scene"};
    if (!make_nodes(reader) ||
        !scope_list(&top, "parts", OPTIONAL, 0, SCENE_NODES_MOST - 1, &reader->part_list)) {
        return false;
    }
    int count = reader->part_list ? (int)reader->part_list->count : 0;
    reader->parts = scene_allocate(reader, (size_t)count, sizeof *reader->parts);
    if (!reader->parts) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        if (!read_part(reader, &reader->part_list->members[i])) {
            return false;
        }
    }
    return true;
}

static bool read_object(struct scene_reader *reader, const struct scene_value *group) {
    static const char *const keys[] = {"name", "material", "solid", NULL};
    struct scene_description *scene = reader->scene;
    const struct scene_scope scope = {reader, group, "object"};
    struct scene_object object = {.line = group->line};
    const struct scene_value *solid;
    const char *name = "", *material = NULL;
    if (!scene_is_group(reader, group, "object") || !scope_check_keys(&scope, keys) ||
        !scope_string(&scope, "name", OPTIONAL, &name) ||
        !scope_string(&scope, "material", OPTIONAL, &material) ||
        !scope_group(&scope, "solid", REQUIRED, &solid) ||
        !scene_read_solid(reader, solid, &object.solid)) {
        return false;
    }
    struct solid_node *node = &scene->nodes[object.solid];
    int bare = reader->facts[object.solid].without_material;
    if (material) {
        int index;
        if (!scene_find_material(reader, material, scope_line(&scope, "material"), &index)) {
            return false;
        }
        node->material = node->material < 0 ? index : node->material;
    } else if (bare >= 0) {
        return scene_fail(reader, object.line,
                          "the object lacks a 'material', and its solid on line %u has none "
                          "either: give one to the object, to the solid, or to what the solid is "
                          "a part of",
                          scene->nodes[bare].line);
    }
    object.name = scene_copy(reader, name);
    if (!object.name) {
        return false;
    }
    scene->objects[scene->object_count++] = object;
    return true;
}

/* Checks the number of solids in all objects together, a part's counted at each use. The firmware's
 * work grows with that number. */
static bool check_instances(struct scene_reader *reader) {
    long sum = 0;
    for (size_t i = 0; i < reader->scene->object_count; i++) {
        const struct scene_object *object = &reader->scene->objects[i];
        sum += reader->facts[object->solid].instances;
        if (sum > SCENE_INSTANCES_MOST) {
            return scene_fail(reader, object->line,
                              "too many solids up to here: at most %d are allowed, those of a "
                              "part counted each time it is used",
                              SCENE_INSTANCES_MOST);
        }
    }
    return true;
}

bool scene_read_objects(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_scope top = {reader, root, "scene"};
    const struct scene_value *list;
    if (!scope_list(&top, "objects", REQUIRED, 1, SCENE_OBJECTS_MOST, &list)) {
        return false;
    }
    int count = (int)list->count;
    reader->scene->objects = scene_allocate(reader, (size_t)count, sizeof *reader->scene->objects);
    if (!reader->scene->objects) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        if (!read_object(reader, &list->members[i])) {
            return false;
        }
    }
    trim_nodes(reader->scene);
    return check_instances(reader);
}
