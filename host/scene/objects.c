/* SPDX-License-Identifier: MIT */
/* Reads the named parts of a scene file and the objects that it shows. */
#include <string.h>

#include "scene/keys.h"

static const struct scene_key part_rows[] = {
    {KEY_AT("name", KEY_TEXT, scene_part, name), .is_required = true,
     .meaning = "by which solids below use the part"},
    {.name = "solid", .type = KEY_GROUP, .is_required = true, .noun = "a solid"}};
const struct scene_keys scene_part_keys = SCENE_KEYS("part", part_rows, NULL);

static void read_part(struct scene_reader *reader, const struct scene_value *group) {
    const struct scene_scope scope = {reader, group, scene_part_keys.what};
    struct scene_part part = {NULL, -1};
    (void)scene_read_keys(&scope, &scene_part_keys, &part);
    if (part.name == NULL || *part.name == '\0') {
        reader->knows_parts = false;
    }
    if (group->kind != VALUE_GROUP) {
        return;
    }
    const struct scene_value *solid = scene_find_group(group, "solid");
    if (part.name != NULL && *part.name == '\0') {
        (void)scene_fail(reader, scene_place_of(group, "name"),
                         "'name' of the part is empty: it needs a name to be used by");
    }
    for (size_t i = 0; part.name != NULL && i < reader->part_count; i++) {
        if (strcmp(reader->parts[i].name, part.name) == 0) {
            (void)scene_fail(reader, scene_place_of(group, "name"),
                             "duplicate part '%.40s': each part needs a name of its own",
                             part.name);
            reader->knows_parts = false; /* one of the two may be meant as another */
        }
    }
    part.node = solid != NULL ? scene_read_solid(reader, solid) : -1;
    if (part.name != NULL) {
        reader->parts[reader->part_count++] = part;
    }
}

void scene_read_parts(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_value *list = scene_find_list(root, "parts");
    reader->part_list = list;
    reader->knows_parts =
        list == NULL ? value_member(root, "parts") == NULL && !root->is_partial : !list->is_partial;
    reader->parts =
        list == NULL ? NULL : scene_allocate(reader, list->count, sizeof *reader->parts);
    for (size_t i = 0; reader->parts != NULL && i < list->count; i++) {
        read_part(reader, &list->members[i]);
    }
}

/* An object as the file has it. */
struct read_object {
    const char *name, *material;
};

static const struct read_object object_defaults = {.name = ""};
static const struct scene_key object_rows[] = {
    {KEY_AT("name", KEY_TEXT, read_object, name), .meaning = "for messages and reports"},
    {KEY_AT("material", KEY_TEXT, read_object, material), .noun = "a material's name",
     .fallback = "",
     .meaning = "of all its solids that have none of their own; required unless each has one"},
    {.name = "solid", .type = KEY_GROUP, .is_required = true, .noun = "a solid"}};
const struct scene_keys scene_object_keys = SCENE_KEYS("object", object_rows, &object_defaults);

/* Gives an object's material to its solids that have none. */
static void give_material(struct scene_reader *reader, const struct scene_value *group,
                          const char *name, int solid) {
    struct scene_description *scene = reader->scene;
    const int bare = solid >= 0 ? reader->facts[solid].without_material : -1;
    int material = -1;
    if (name != NULL) {
        if (scene_find_material(reader, name, scene_place_of(group, "material"), &material) &&
            solid >= 0 && scene->nodes[solid].material < 0) {
            scene->nodes[solid].material = material;
        }
    } else if (bare >= 0) {
        (void)scene_fail(reader, group->at,
                         "the object lacks a 'material', and its solid on line %u has none "
                         "either: give one to the object, to the solid, or to what the solid is "
                         "a part of",
                         scene->nodes[bare].line);
    }
}

static void read_object(struct scene_reader *reader, const struct scene_value *group) {
    struct scene_description *scene = reader->scene;
    const struct scene_scope scope = {reader, group, scene_object_keys.what};
    struct read_object read = object_defaults;
    bool is_good = scene_read_keys(&scope, &scene_object_keys, &read);
    if (group->kind != VALUE_GROUP) {
        return;
    }
    const struct scene_value *solid = scene_find_group(group, "solid");
    const int index = solid != NULL ? scene_read_solid(reader, solid) : -1;
    if (is_good || read.material != NULL) {
        give_material(reader, group, read.material, index);
    }
    scene->objects[scene->object_count++] = (struct scene_object){
        .line = group->at.line, .name = scene_copy(reader, read.name), .solid = index};
}

/* Checks the number of solids in all objects together; a part's solids count at each use. The
 * firmware's work grows with that number. */
static void check_instances(struct scene_reader *reader, const struct scene_value *list) {
    long sum = 0;
    for (size_t i = 0; i < reader->scene->object_count; i++) {
        const int solid = reader->scene->objects[i].solid;
        sum += solid >= 0 ? reader->facts[solid].instances : 0;
        if (sum > SCENE_INSTANCES_MOST) {
            (void)scene_fail(reader, list->members[i].at,
                             "too many solids up to here: at most %d are allowed, those of a "
                             "part counted each time it is used",
                             SCENE_INSTANCES_MOST);
            return;
        }
    }
    reader->scene->instances = (size_t)sum;
}

void scene_read_objects(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_value *list = scene_find_list(root, "objects");
    struct scene_description *scene = reader->scene;
    if (list == NULL) {
        return;
    }
    scene->objects = scene_allocate(reader, list->count, sizeof *scene->objects);
    for (size_t i = 0; scene->objects != NULL && i < list->count; i++) {
        read_object(reader, &list->members[i]);
    }
    check_instances(reader, list);
}
