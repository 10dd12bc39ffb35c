/* SPDX-License-Identifier: MIT */
/* A firmware image and its scene as a program of its own, which prints its trace_hash. */

/* tests/trace_hash_matrix.sh builds it with the scene's tables, which `superframe compile` made.
 * Nothing of the host's is in it: this file is the hardware. */
#include <stdio.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "image.h"
#include "outp.h"
#include "scene.h"

extern const struct image image_fx;
extern const struct scene scene_fig3;

static XXH3_state_t hash;
static unsigned long writes;

/* Five bytes a write: port, width, value, little-endian. */
static void take(uint16_t port, uint8_t width, uint16_t value) {
    const uint8_t bytes[5] = {(uint8_t)(port & 0xFF), (uint8_t)(port >> 8), width,
                              (uint8_t)(value & 0xFF), (uint8_t)(value >> 8)};
    XXH3_64bits_update(&hash, bytes, sizeof bytes);
    writes++;
}

void outp(uint16_t port, uint8_t value) {
    take(port, 1, value);
}

void outpw(uint16_t port, uint16_t value) {
    take(port, 2, value);
}

uint8_t inp(uint16_t port) {
    (void)port;
    return 0xFF;
}

uint16_t inpw(uint16_t port) {
    (void)port;
    return 0xFFFF;
}

int main(void) {
    const struct drawing drawing = {0x00D0, 0, scene_fig3.height, 0, 0, 0};
    XXH3_64bits_reset(&hash);
    image_fx.draw(&scene_fig3, &drawing);
    const unsigned long long result = XXH3_64bits_digest(&hash);
    printf("%08lx%08lx %lu\n", (unsigned long)(result >> 32), (unsigned long)(result & 0xFFFFFFFFu),
           writes);
    return 0;
}
