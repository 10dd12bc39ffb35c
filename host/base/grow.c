/* SPDX-License-Identifier: MIT */
/* Tables on the heap that grow by one entry at a time. */
#include "base/grow.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* More entries have no numbers: the last numbers of 32 bits stand for something else. */
#define ENTRIES_MOST (UINT32_MAX / 2)

bool grow_table(void *table, size_t count, size_t size) {
    char *entries; /* the pointer is read and written as bytes, for it may point to anything */
    memcpy(&entries, table, sizeof entries);
    if ((count & (count - 1)) == 0) {
        size_t room = count > 0 ? 2 * count : 1;
        if (count >= ENTRIES_MOST || room > SIZE_MAX / size) {
            return false;
        }
        char *moved = realloc(entries, room * size);
        if (moved == NULL) {
            return false;
        }
        entries = moved;
        memcpy(table, &moved, sizeof moved);
    }
    memset(entries + count * size, 0, size);
    return true;
}
