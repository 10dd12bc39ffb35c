/* SPDX-License-Identifier: MIT */
/* What a compiler calls by itself for copies of structs: byte by byte, for it is small. */
#include <stddef.h>
#include <stdint.h>

/* Declared here: a freestanding compiler has no string.h. The file is compiled with
 * -fno-builtin -fno-tree-loop-distribute-patterns, or a loop would be turned into a call of itself.
 */
void *memcpy(void *to, const void *from, size_t count);
void *memmove(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);

void *memcpy(void *to, const void *from, size_t count) {
    uint8_t *target = to;
    const uint8_t *source = from;
    while (count-- > 0) {
        *target++ = *source++;
    }
    return to;
}

void *memmove(void *to, const void *from, size_t count) {
    uint8_t *target = to;
    const uint8_t *source = from;
    if (target <= source) {
        return memcpy(to, from, count);
    }
    while (count-- > 0) {
        target[count] = source[count];
    }
    return to;
}

void *memset(void *to, int value, size_t count) {
    uint8_t *target = to;
    while (count-- > 0) {
        *target++ = (uint8_t)value;
    }
    return to;
}
