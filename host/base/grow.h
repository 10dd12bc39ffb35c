/* SPDX-License-Identifier: MIT */
/* Tables on the heap that grow by one entry at a time. */
#ifndef SUPERFRAME_GROW_H
#define SUPERFRAME_GROW_H

#include <stdbool.h>
#include <stddef.h>

/* A table of n entries has room for n rounded up to a power of two, so that n tells the room. NULL
 * is a table without entries. free() frees a table. */

/* Makes room in a table of `count` entries for one more, which is all zero. The table may move:
 * pointers into it are lost. Returns false if memory is out, with the table as it was. */
#define GROW(table, count) grow_table(&(table), (count), sizeof *(table))

/* Does so for a pointer to the table and the size of its entries. */
bool grow_table(void *table, size_t count, size_t size);

#endif
