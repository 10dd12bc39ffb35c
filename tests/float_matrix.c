/* SPDX-License-Identifier: MIT */
/* A float image of the firmware and its scene as a program of its own, which prints the picture. */

/* tests/float_matrix.sh builds it with the scene's tables, which `superframe compile` made. The
 * picture is rows of R, G, B bytes, in full colour. */
#include <stdio.h>
#include <string.h>

#include "image.h"
#include "outp.h"
#include "scene.h"

#define NAME_JOIN(prefix, name)  NAME_JOIN_(prefix, name)
#define NAME_JOIN_(prefix, name) prefix##name
#define IMAGE                    NAME_JOIN(image_, REAL_NAME)

extern const struct image IMAGE;
extern const struct scene scene_fig3;

/* Rows alone are asked for: no port is written to. */
void outp(uint16_t port, uint8_t value) {
    (void)port;
    (void)value;
}

void outpw(uint16_t port, uint16_t value) {
    (void)port;
    (void)value;
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
    struct render_counts counts;
    memset(&counts, 0, sizeof counts);
    for (uint16_t y = 0; y < scene_fig3.height; y++) {
        uint8_t rgb[3 * 640];
        IMAGE.row(&scene_fig3, y, rgb, &counts);
        if (fwrite(rgb, 3, scene_fig3.width, stdout) != scene_fig3.width) {
            return 1;
        }
    }
    return counts.leaked_rays == 0 ? 0 : 1;
}
