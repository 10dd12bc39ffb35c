/* SPDX-License-Identifier: MIT */
/* All rows of a compiled scene, and nothing else: a program whose instructions are counted. */
#include "image.h"

/* Built by tests/cost/whole.sh with IMAGE, SCENE and HEIGHT. */
extern const struct image IMAGE;
extern const struct scene SCENE;

void run(void);
void *memcpy(void *to, const void *from, __SIZE_TYPE__ size);
void *memset(void *to, int value, __SIZE_TYPE__ size);

void *memcpy(void *to, const void *from, __SIZE_TYPE__ size) {
    unsigned char *target = to;
    const unsigned char *source = from;
    while (size-- > 0) {
        *target++ = *source++;
        __asm__ volatile("" : : : "memory"); /* not to be turned into a call of itself */
    }
    return to;
}

void *memset(void *to, int value, __SIZE_TYPE__ size) {
    unsigned char *target = to;
    while (size-- > 0) {
        *target++ = (unsigned char)value;
        __asm__ volatile("" : : : "memory");
    }
    return to;
}

void run(void) {
    struct render_counts counts = {0, 0, 0, 0, 0};
    uint8_t rgb[3 * 640];
    for (uint16_t y = 0; y < HEIGHT; y++) {
        IMAGE.row(&SCENE, y, rgb, &counts);
    }
}
