/* SPDX-License-Identifier: MIT */
/* What an image of the firmware shows to the outside: one const table. */
#ifndef SUPERFRAME_IMAGE_H
#define SUPERFRAME_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

/* An image is the firmware in one arithmetic. The host links several and picks one at run time; a
 * target links one. Nothing here depends on the arithmetic: struct scene is opaque to the host. */

struct scene;

/* What a row took, added to whatever is there. */
struct render_counts {
    uint32_t rays; /* eye rays, reflected and refracted ones */
    uint32_t shadow_rays;
    uint32_t nodes;       /* boundaries shaded */
    uint32_t solid_tests; /* a ray against a primitive */
    uint32_t leaked_rays; /* rays that left the scene inside a medium: 0 is the only right value */
};

/* Gives row y as width x 3 bytes R G B, in full colour; false stops the drawing. */
typedef bool row_source(void *context, uint16_t y, uint8_t *rgb);

struct drawing {
    uint16_t base;        /* the board's base address: 00D0h as it came from the factory */
    uint16_t first, last; /* rows first .. last-1 */
    row_source *source;   /* where rows come from; NULL: the image computes them itself */
    void *context;
    uint8_t exposure; /* of a scene shown by exposures: the bit drawn, 0..7; else 0 */
};

struct image {
    const char *name; /* of the arithmetic */

    /* Renders row y into width x 3 bytes, in full colour. Pure: any number of threads may call it.
     */
    void (*row)(const struct scene *scene, uint16_t y, uint8_t *rgb, struct render_counts *counts);

    /* Initialises the board and draws rows, as the scene says that colours are shown, through
     * outp() and outpw(): the only caller of ports. A multiple exposure takes eight drawings. */
    void (*draw)(const struct scene *scene, const struct drawing *drawing);
};

#endif
