/* SPDX-License-Identifier: MIT */
/* A firmware image and its scene as a program of its own, whose every port write is looked at.
 *
 * tests/check_uninitialised.sh builds it under clang's memory sanitizer, with SCENE and IMAGE as
 * names. The sanitizer reports a branch, or an address, that depends on memory which nobody wrote:
 * each value here becomes an address. */
#include <stdio.h>

#include "image.h"
#include "outp.h"
#include "scene.h"

extern const struct image IMAGE;
extern const struct scene SCENE;

static unsigned long values[65536], bytes[256];

void outp(uint16_t port, uint8_t value) {
    values[port]++;
    bytes[value]++;
}

void outpw(uint16_t port, uint16_t value) {
    values[port]++;
    values[value]++;
}

uint8_t inp(uint16_t port) {
    (void)port;
    return 0xFF;
}

uint16_t inpw(uint16_t port) {
    (void)port;
    return 0xFFFF;
}

/* Renders a row apart from the board as well, for what a row counts is drawn nowhere. */
int main(void) {
    static uint8_t rgb[3 * 640];
    struct drawing drawing = {0x00D0, 0, SCENE.height, 0, 0, 0};
    struct render_counts counts = {0};
    IMAGE.draw(&SCENE, &drawing);
    if (SCENE.show == SHOW_EXPOSURES) {
        drawing.exposure = 7;
        IMAGE.draw(&SCENE, &drawing);
    }
    struct scene scene = SCENE;
    struct estimate estimate;
    if (scene.estimates) {
        IMAGE.learn(&SCENE, &estimate, &counts);
        scene.estimate = &estimate;
    }
    IMAGE.row(&scene, SCENE.height / 2, rgb, &counts);
    printf("%lu rays, %lu shadow rays, %lu nodes, %lu tests, %lu leaked, %lu exhausted, %lu "
           "unreached, "
           "worst %lu of pixel %u %u, proved %lu\n",
           (unsigned long)counts.rays, (unsigned long)counts.shadow_rays,
           (unsigned long)counts.nodes, (unsigned long)counts.solid_tests,
           (unsigned long)counts.leaked_rays, (unsigned long)counts.exhausted_pixels,
           (unsigned long)counts.unreached_pixels, (unsigned long)counts.estimated_error,
           counts.worst_x, counts.worst_y, (unsigned long)counts.proved_error);
    return bytes[0] + values[0x00D0] > 0 ? 0 : 1;
}
