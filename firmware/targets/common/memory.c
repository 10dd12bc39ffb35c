/* SPDX-License-Identifier: MIT */
/* What a compiler calls by itself for copies of structs: byte by byte, to keep the code small. */
#include <stddef.h>
#include <stdint.h>

/* Replaces string.h, which a freestanding compiler does not have. The file is compiled with
 * -fno-builtin -fno-tree-loop-distribute-patterns. Else the compiler would turn each loop into a
 * call of the loop's own function. */
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
