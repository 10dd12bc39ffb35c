/* SPDX-License-Identifier: MIT */
/* What a scene file says, as a tree of groups, lists and plain values, before anything is made of
 * it. */
#ifndef SUPERFRAME_SCENE_TREE_H
#define SUPERFRAME_SCENE_TREE_H

#include <stdbool.h>
#include <stddef.h>

enum value_kind {
    VALUE_REFUSED, /* refused already */
    VALUE_GROUP,
    VALUE_LIST,
    VALUE_ARRAY,
    VALUE_STRING,
    VALUE_BOOLEAN,
    VALUE_NUMBER
};

/* A place in the file; both count from 1, a column in bytes. */
struct scene_place {
    unsigned line, column;
};

struct scene_value {
    enum value_kind kind;
    struct scene_place at; /* of its key, or of the element itself */
    const char *name;      /* its key; NULL: an element of a list, or the whole file */
    double number;         /* of VALUE_NUMBER */
    bool truth;            /* of VALUE_BOOLEAN */
    const char *text;      /* of VALUE_STRING */

    /* Of a group { }, a list ( ) or an array [ ]: what it holds, in the file's order. */
    struct scene_value *members;
    size_t count;
    bool is_partial; /* something in it was refused and is missing here */
};

/* Finds what a group holds under a key; NULL: nothing, or no group. */
const struct scene_value *value_member(const struct scene_value *group, const char *key);

/* Tells whether a value is a list or an array. */
bool value_is_sequence(const struct scene_value *value);

/* Memory for what is made of one file, which is freed at one go. All zero: empty. */
struct scene_memory {
    struct scene_block *blocks;
};

/* Returns zeroed memory for anything; NULL: there is none. */
void *memory_take(struct scene_memory *memory, size_t size);

void memory_free(struct scene_memory *memory);

#endif
