/* SPDX-License-Identifier: MIT */
/* The keys that a group of a scene file may have, as rows. From the rows come the reading of the
 * file, its refusals, and the reference in docs/scene-format.md. */
#ifndef SUPERFRAME_SCENE_KEYS_H
#define SUPERFRAME_SCENE_KEYS_H

#include "scene/reader_internal.h"

/* Both ends belong to the range. */
struct scene_range {
    double least, most;
    const char *name; /* for the reference; NULL: its ends are shown */
};

extern const struct scene_range RANGE_LENGTH;     /* radii, sizes: greater than zero */
extern const struct scene_range RANGE_COORDINATE; /* coordinates, and all that may be negative */
extern const struct scene_range RANGE_SHARE;      /* 0 to 1 */
extern const struct scene_range RANGE_COLOUR;     /* levels; 255 is white */

/* A group and what it describes ("camera", "ball"), for messages. */
struct scene_scope {
    struct scene_reader *reader;
    const struct scene_value *group;
    const char *what;
};

enum key_type {
    KEY_NUMBER,  /* double */
    KEY_NUMBERS, /* double[count] */
    KEY_THREE,   /* double[3]; in the file, one number may stand for all three */
    KEY_WHOLE,   /* int */
    KEY_TRUTH,   /* bool */
    KEY_TEXT,    /* const char *, the tree's */
    KEY_WORD,    /* int, the index of one of `words` */
    KEY_GROUP,   /* what follows is read by whoever reads the group that has the key */
    KEY_LIST,    /* the same; the range is that of its length */
    KEY_OTHER    /* read by `read` */
};

struct scene_key {
    const char *name;
    enum key_type type;
    size_t offset; /* of what is read, in the struct that the group becomes */
    int count;     /* of KEY_NUMBERS */
    const struct scene_range *range;
    const char *const *words; /* of KEY_WORD, up to NULL */
    void (*read)(const struct scene_scope *scope, const struct scene_value *value, void *into);
    bool is_required;

    /* For the reference. */
    const char *noun;     /* what the value is; NULL: its type and its range say so */
    const char *fallback; /* what a missing key means; NULL: what stands in the defaults */
    const char *meaning;
};

/* The type of a key, and where its value goes: member `into` of a struct. */
#define KEY_AT(key, type_, where, into)                                                            \
    .name = (key), .type = (type_), .offset = offsetof(struct where, into)
#define NUMBER_KEY(key, where, into, limits)                                                       \
    KEY_AT(key, KEY_NUMBER, where, into), .range = &(limits)
#define NUMBERS_KEY(key, where, into, number, limits)                                              \
    KEY_AT(key, KEY_NUMBERS, where, into), .count = (number), .range = &(limits)
#define THREE_KEY(key, where, into, limits)                                                        \
    KEY_AT(key, KEY_THREE, where, into), .count = 3, .range = &(limits)
#define OTHER_KEY(key, reader)              .name = (key), .type = KEY_OTHER, .read = (reader)
#define WHOLE_KEY(key, where, into, limits) KEY_AT(key, KEY_WHOLE, where, into), .range = &(limits)

/* All keys of one sort of group. */
struct scene_keys {
    const char *what; /* "camera" */
    const struct scene_key *rows;
    size_t count;
    const void *defaults; /* of the struct that the group becomes; NULL: all zero */
};

#define SCENE_KEYS(name_, rows_, defaults_)                                                        \
    { name_, rows_, sizeof(rows_) / sizeof(rows_)[0], defaults_ }

/* Reads the members of a group into the struct that it becomes, which holds the defaults. Refuses
 * what is no group, keys without a row, required keys that are missing, and what a row does not
 * allow. Returns true if nothing was refused. `scope->what` may say more than `keys->what`. */
bool scene_read_keys(const struct scene_scope *scope, const struct scene_keys *keys, void *into);

/* Finds the list or the group under a key; NULL: the value is missing or was refused. */
const struct scene_value *scene_find_group(const struct scene_value *group, const char *key);
const struct scene_value *scene_find_list(const struct scene_value *group, const char *key);

/* Returns the place of a key, or the group's where the group has no such key. */
struct scene_place scene_place_of(const struct scene_value *group, const char *key);

/* Reads a number, or numbers of an array or a list, as KEY_NUMBER and KEY_NUMBERS do. */
bool scene_read_number(const struct scene_scope *scope, const char *key,
                       const struct scene_value *value, const struct scene_range *range,
                       double *number);
bool scene_read_numbers(const struct scene_scope *scope, const char *key,
                        const struct scene_value *value, const struct scene_range *range, int count,
                        double *numbers);

enum {
    SCENE_KINDS = SOLID_PART + 1, /* of solids: the first rows of scene_solid_keys */
    SCENE_TRANSPARENT_ROW = 8 /* from here on, rows of a material are of transparent ones only */
};

/* The sorts of groups, for the reference; those of a solid's kinds are in scene_leaves. */
extern const struct scene_keys scene_top_keys, scene_attenuation_keys, scene_camera_keys,
    scene_light_keys, scene_material_keys, scene_pattern_keys, scene_solid_keys, scene_plane_keys,
    scene_part_keys, scene_object_keys;

/* A kind of leaf: its keys, of struct solid_node, and what is to be checked when they are read.
 * `check` is NULL where nothing is. */
struct scene_leaf {
    struct scene_keys keys;
    void (*check)(const struct scene_scope *scope, struct solid_node *node);
};

/* By enum solid_kind. The keys of a solid are these kinds in this order, and then the nodes. */
extern const struct scene_leaf scene_leaves[];
extern const size_t scene_leaf_count;

#endif
