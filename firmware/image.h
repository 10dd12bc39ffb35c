/* SPDX-License-Identifier: MIT */
/* What an image of the firmware shows to the outside: one const table. */
#ifndef SUPERFRAME_IMAGE_H
#define SUPERFRAME_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

/* An image is the firmware in one arithmetic. The host links several and picks one at run time; a
 * target links one. Nothing here depends on the arithmetic: struct scene is opaque to the host. */

struct scene;

/* What a row took, added to whatever is there. One row has up to 640 pixels of a million rays each,
 * with 128 lights: more than 32 bits hold. */
struct render_counts {
    uint64_t rays; /* eye rays, reflected and refracted ones */
    uint64_t shadow_rays;
    uint64_t nodes;       /* boundaries shaded */
    uint64_t solid_tests; /* a ray against a primitive */
    uint64_t leaked_rays; /* rays that left the scene inside a medium: 0 is the only right value */

    uint32_t exhausted_pixels; /* that ended by their budget of rays */

    /* These are 0 where no accuracy is asked for; errors are in steps of 2^-16 level. */
    uint32_t unreached_pixels; /* whose estimated error is larger than was asked for */
    uint32_t estimated_error;  /* of the pixel where that is largest: not a sum */
    uint32_t proved_error;     /* of the pixel where that is largest: none is farther off */
    uint16_t worst_x, worst_y; /* where estimated_error is, where rows are rendered */
};

/* The way that a branch was going when it was pruned. What is above and what is below the objects
 * differs more than anything else that is known of the branch by then. */
enum estimate_way { WAY_DOWN, WAY_UP, WAYS, WAY_ANY = WAYS };

/* Without an accuracy asked for, learning follows a pruned branch so many events beyond the scene's
 * depth level, up to level 255. An image needs room for these events. */
enum { ESTIMATE_EVENTS = 16 };

/* Holds what a training pass over a scene has learned of pruned branches. */
struct estimate {
    int32_t mean[WAYS + 1][3]; /* radiance of one way, or of any, in steps of 2^-16 level */

    /* Of scenes with an accuracy asked for. */
    int32_t mean_variance;   /* of a pixel's means about these, in levels^2 */
    int32_t branch_variance; /* of a branch about its pixel's mean */
    int32_t noise;           /* the latter over the former, in steps of 2^-8 */
    uint8_t first;           /* pixels begin so many half octaves below the scene's threshold */
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

    /* Learns from a few hundred pixels the radiance of the branches that the scene's threshold and
     * depth level prune. The result goes where the scene's estimate points to before rows are
     * rendered. An image without that feature leaves it as it is. */
    void (*learn)(const struct scene *scene, struct estimate *estimate,
                  struct render_counts *counts);

    /* Renders row y into width x 3 bytes, in full colour. Pure: any number of threads may call it.
     */
    void (*row)(const struct scene *scene, uint16_t y, uint8_t *rgb, struct render_counts *counts);

    /* Initialises the board and draws rows, with colours shown as the scene says. Only this member
     * uses ports, through outp() and outpw(). A multiple exposure takes eight drawings. */
    void (*draw)(const struct scene *scene, const struct drawing *drawing);
};

#endif
