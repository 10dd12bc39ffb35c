/* SPDX-License-Identifier: MIT */
/* The tree of a scene file's values, and its memory. */
#include "scene/tree.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK_BYTES = 65536, ALIGNMENT = 16 };

/* Memory that is handed out from its beginning; `bytes` follow. */
struct scene_block {
    struct scene_block *before;
    size_t used, size;
    double bytes[];
};

const struct scene_value *value_member(const struct scene_value *group, const char *key) {
    for (size_t i = 0; group->kind == VALUE_GROUP && i < group->count; i++) {
        if (strcmp(group->members[i].name, key) == 0) {
            return &group->members[i];
        }
    }
    return NULL;
}

bool value_is_sequence(const struct scene_value *value) {
    return value->kind == VALUE_LIST || value->kind == VALUE_ARRAY;
}

void *memory_take(struct scene_memory *memory, size_t size) {
    struct scene_block *block = memory->blocks;
    size = (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (block == NULL || block->size - block->used < size) {
        size_t room = size > BLOCK_BYTES ? size : BLOCK_BYTES;
        block = calloc(1, sizeof *block + room);
        if (block == NULL) {
            return NULL;
        }
        block->before = memory->blocks;
        block->size = room;
        memory->blocks = block;
    }
    void *taken = (unsigned char *)block->bytes + block->used;
    block->used += size;
    return taken;
}

void memory_free(struct scene_memory *memory) {
    while (memory->blocks != NULL) {
        struct scene_block *before = memory->blocks->before;
        free(memory->blocks);
        memory->blocks = before;
    }
}
