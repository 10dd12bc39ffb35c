/* SPDX-License-Identifier: MIT */
/* What the parts of the scene reader share; callers of the reader need scene/description.h only. */
#ifndef SUPERFRAME_SCENE_READER_H
#define SUPERFRAME_SCENE_READER_H

#include <stdbool.h>
#include <stddef.h>

#include "scene/description.h"
#include "scene/tree.h"

enum {
    SCENE_TEXT_MOST = 1024 * 1024, /* bytes of a scene file */
    SCENE_BRACKETS_MOST = 64,      /* { ( [ within each other */
    SCENE_KEYS_MOST = 100,         /* keys of one group */
    SCENE_ELEMENTS_MOST = 1024,    /* of one list */
    SCENE_STRING_MOST = 200        /* bytes of a string */
};

/* A named solid, which the solids after it may use. */
struct scene_part {
    const char *name; /* the tree's */
    int node;
};

/* What is known of a node beyond its description. */
struct scene_node_facts {
    int height;           /* levels from the node down, its own and those of parts included */
    long instances;       /* nodes below it and itself, a part's counted at every use */
    int without_material; /* a leaf below it that no material reaches, or -1 */
};

/* One reading of one file. */
struct scene_reader {
    const char *path;
    struct scene_error *error;
    struct scene_memory memory;      /* of the tree */
    struct scene_description *scene; /* what has been read so far */
    double wavelengths[3];           /* of R, G, B, in nm */
    const struct scene_value *part_list;
    struct scene_part *parts;
    size_t part_count;
    struct scene_node_facts facts[SCENE_NODES_MOST];
};

/* Records why the file is refused, and returns false. Line 0 counts as line 1. */
bool scene_fail(struct scene_reader *reader, unsigned line, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Allocates zeroed memory for count things. Returns NULL with the failure recorded; a count of 0 is
 * no failure. */
void *scene_allocate(struct scene_reader *reader, size_t count, size_t size);

/* Copies a string into new memory. Returns NULL with the failure recorded. */
char *scene_copy(struct scene_reader *reader, const char *text);

/* Reads a text into a tree, in the reader's memory; *root is the group of the whole file. Returns
 * false with the failure recorded. */
bool scene_parse(struct scene_reader *reader, const char *text, size_t length,
                 struct scene_value *root);

/* Reads one section of the file: the materials, the parts or the objects. */
bool scene_read_materials(struct scene_reader *reader, const struct scene_value *root);
bool scene_read_parts(struct scene_reader *reader, const struct scene_value *root);
bool scene_read_objects(struct scene_reader *reader, const struct scene_value *root);

/* Finds the index of the material of that name. Returns false, with the failure recorded for that
 * line, if there is none. */
bool scene_find_material(struct scene_reader *reader, const char *name, unsigned line, int *index);

/* Reads a solid from its group into the scene's nodes; *index is the solid's place there. */
bool scene_read_solid(struct scene_reader *reader, const struct scene_value *group, int *index);

/* Reads the members of a leaf of one kind from its group. */
struct scene_leaf {
    const char *key;
    bool (*read)(struct scene_reader *reader, const struct scene_value *group,
                 struct solid_node *node);
};
extern const struct scene_leaf scene_leaves[];
extern const size_t scene_leaf_count;

#endif
