/* SPDX-License-Identifier: MIT */
/* Tables put one behind the other into one block of memory. */
#ifndef SUPERFRAME_BLOCK_H
#define SUPERFRAME_BLOCK_H

#include <stddef.h>

/* Without memory, a block is measured only. */
struct block {
    char *memory; /* NULL: nothing is written */
    size_t used;
};

/* Any table begins at a multiple of so many bytes from the first. */
enum { BLOCK_STEP = 64 };

/* Takes room for a table; NULL while the block is measured. */
static inline void *block_take(struct block *block, size_t count, size_t bytes) {
    size_t place = block->used;
    block->used += (count * bytes + BLOCK_STEP - 1) / BLOCK_STEP * BLOCK_STEP;
    return block->memory == NULL ? NULL : block->memory + place;
}

/* Loads all entries of a table into the block, and points the scene at the table. */
#define LOAD_TABLE(type, count, table, source, load_entry)                                         \
    {                                                                                              \
        const size_t entries = (count);                                                            \
        /* NOLINTNEXTLINE(bugprone-macro-parentheses): a type takes none */                        \
        type *loaded = block_take(block, entries, sizeof(type));                                   \
        for (size_t i = 0; loaded != NULL && i < entries; i++) {                                   \
            load_entry(&loaded[i], &(source)[i]);                                                  \
        }                                                                                          \
        to->table = loaded;                                                                        \
    }

#endif
