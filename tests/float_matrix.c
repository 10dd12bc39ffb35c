/* SPDX-License-Identifier: MIT */
/* A float image of the firmware and its scene as a program of its own, which prints the picture. */

/* tests/float_matrix.sh builds it with the scene's tables, which `superframe compile` made. The
 * picture is rows of R, G, B bytes, in full colour. */
#include <stdio.h>
#include <string.h>

#include "image.h"
#include "scene.h"

#define NAME_JOIN(prefix, name)  NAME_JOIN_(prefix, name)
#define NAME_JOIN_(prefix, name) prefix##name
#define IMAGE                    NAME_JOIN(image_, REAL_NAME)

extern const struct image IMAGE;
extern const struct scene scene_fig3;

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
