/* SPDX-License-Identifier: MIT */
/* What the parts of the scene reader share; callers of the reader need scene/description.h only. */
#ifndef SUPERFRAME_SCENE_READER_H
#define SUPERFRAME_SCENE_READER_H

#include <stdbool.h>
#include <stddef.h>

#include "scene/description.h"
#include "scene/tree.h"

/* A named solid, which the solids after it may use. */
struct scene_part {
    const char *name; /* the tree's */
    int node;         /* -1: it was refused */
};

/* What is known of a node beyond its description. */
struct scene_node_facts {
    int height;           /* levels from the node down, its own and those of parts included */
    long instances;       /* nodes below it and itself, a part's counted at every use */
    int without_material; /* a leaf below it that no material reaches, or -1 */
};

/* Something that is wrong, and where; `line` 0: nowhere in the file. */
struct scene_refusal {
    struct scene_place at;
    char text[SCENE_REFUSAL_MOST];
};

/* One reading of one file. */
struct scene_reader {
    const char *path;
    struct scene_refusal refusals[SCENE_REFUSALS_MOST];
    size_t refusal_count;              /* of all, those beyond the array included */
    struct scene_memory memory;        /* of the tree */
    struct scene_description *scene;   /* what has been read so far */
    double wavelengths[3];             /* of R, G, B, in nm */
    bool knows_materials, knows_parts; /* false: some were refused unread */
    const struct scene_value *part_list;
    struct scene_part *parts;
    size_t part_count;
    struct scene_node_facts *facts; /* of scene->nodes */
    size_t node_room;               /* of both */
};

/* Records that something is wrong, and returns false. */
bool scene_fail(struct scene_reader *reader, struct scene_place at, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Writes what was recorded into *error, in the file's order. `text`, ended by NUL, is the file's.
 */
void scene_report(const struct scene_reader *reader, const char *text, struct scene_error *error);

/* Takes zeroed memory of the description for count things. Returns NULL with the failure recorded.
 */
void *scene_allocate(struct scene_reader *reader, size_t count, size_t size);

/* Makes room for one more thing in memory that realloc() gave, of which `count` are in use. Returns
 * the memory; NULL with the failure recorded, and the old memory as it was. */
void *scene_grow(struct scene_reader *reader, void *things, size_t count, size_t *room,
                 size_t size);

/* Copies a string into the description's memory. Returns NULL with the failure recorded. */
char *scene_copy(struct scene_reader *reader, const char *text);

/* Reads a text, ended by NUL, into a tree in the reader's memory. What is wrong is recorded, and is
 * missing in *root, the group of the whole file, or is VALUE_REFUSED there. */
void scene_parse(struct scene_reader *reader, const char *text, size_t length,
                 struct scene_value *root);

/* Reads one section of the file: the materials, the parts or the objects. */
void scene_read_materials(struct scene_reader *reader, const struct scene_value *root);
void scene_read_parts(struct scene_reader *reader, const struct scene_value *root);
void scene_read_objects(struct scene_reader *reader, const struct scene_value *root);

/* Finds the index of the material of that name. Returns false, with the failure recorded for that
 * place, if there is none. */
bool scene_find_material(struct scene_reader *reader, const char *name, struct scene_place at,
                         int *index);

/* Reads a solid from its group into the scene's nodes. Returns the solid's place there; -1 with the
 * failure recorded. */
int scene_read_solid(struct scene_reader *reader, const struct scene_value *group);

#endif
