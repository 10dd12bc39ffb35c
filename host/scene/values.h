/* SPDX-License-Identifier: MIT */
/* Typed values of a group of a scene file; every refusal names the key and what is allowed. */
#ifndef SUPERFRAME_SCENE_VALUES_H
#define SUPERFRAME_SCENE_VALUES_H

#include "scene/reader_internal.h"

/* A group and what it describes ("camera", "ball"), for messages. */
struct scene_scope {
    struct scene_reader *reader;
    const struct scene_value *group;
    const char *what;
};

/* Both ends belong to the range. */
struct scene_range {
    double least, most;
};

extern const struct scene_range RANGE_LENGTH;     /* radii, sizes: greater than zero */
extern const struct scene_range RANGE_COORDINATE; /* coordinates, and all that may be negative */
extern const struct scene_range RANGE_SHARE;      /* 0 to 1 */
extern const struct scene_range RANGE_COLOUR;     /* levels; 255 is white */

/* The functions below read the value of `key`. Where an optional key is missing, the functions
 * succeed and leave what the caller has put there. On failure the functions return false, with the
 * failure recorded. */
enum scene_presence { OPTIONAL, REQUIRED };

bool scope_number(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  struct scene_range range, double *value);
/* Reads `count` numbers of an array or a list. */
bool scope_numbers(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   struct scene_range range, int count, double *values);
/* Reads three numbers, or one for all three. */
bool scope_three(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 struct scene_range range, double values[3]);
bool scope_integer(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                   int least, int most, int *value);
bool scope_boolean(const struct scene_scope *scope, const char *key, bool *value);
/* Reads a string, which stays the tree's. */
bool scope_string(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                  const char **value);
/* Finds a group, or a list; NULL where an optional one is missing. */
bool scope_group(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                 const struct scene_value **group);
bool scope_list(const struct scene_scope *scope, const char *key, enum scene_presence presence,
                int least, int most, const struct scene_value **list);

/* Reads one of the words of a list, which ends with NULL, as the word's index in that list. */
bool scope_choice(const struct scene_scope *scope, const char *key, const char *const *words,
                  int *index);

bool scope_has(const struct scene_scope *scope, const char *key);

/* Returns the line of a key, or the group's line where the group has no such key. */
unsigned scope_line(const struct scene_scope *scope, const char *key);

/* Refuses every key that is not in the list, which ends with NULL. */
bool scope_check_keys(const struct scene_scope *scope, const char *const *known);

/* Checks that an element of a list is a group; `what` names the element in the message. */
bool scene_is_group(struct scene_reader *reader, const struct scene_value *element,
                    const char *what);

#endif
