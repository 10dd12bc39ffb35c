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

    /* Pixels that ended by their budget of rays, or at the last level short of the accuracy. */
    uint32_t exhausted_pixels;

    /* Of scenes with an accuracy asked for: the worst pixel's, not sums. */
    uint32_t estimated_error;  /* in steps of 2^-16 level: what was pruned, times its spread */
    uint16_t worst_x, worst_y; /* that pixel, where rows are rendered */
    uint32_t proved_error; /* in levels: what was pruned, at its brightest, to the depth level */
};

/* The way that a branch was going when it was pruned. What is above and what is below the objects
 * differs more than anything else that is known of the branch by then. */
enum estimate_way { WAY_DOWN, WAY_UP, WAYS, WAY_ANY = WAYS };

/* The estimated radiance of the branches that one threshold prunes; intensities in steps of 2^-16
 * level. */
struct estimate_level {
    int32_t mean[WAYS + 1][3]; /* of one way, or of any; red, green, blue */

    /* Three standard deviations: of a pixel, over the root of the sum of the squares of the pruned
     * weights. */
    int32_t spread;

    /* The sum of those squares, in steps of 2^-52, at which a pixel is as accurate as was asked
     * for. */
    int64_t squares_most;
};

enum { ESTIMATE_LEVELS = 20 };

/* Without an accuracy asked for, learning follows a pruned branch so many events beyond the scene's
 * depth level, up to level 255. An image needs room for these events. */
enum { ESTIMATE_EVENTS = 16 };

/* The training pass over a scene. Level 0 is of the scene's own threshold, each next level
 * of half the threshold before. All levels but level 0 are for an accuracy that is asked for. */
struct estimate {
    struct estimate_level level[ESTIMATE_LEVELS];
    uint8_t first;   /* the level where pixels begin */
    uint8_t typical; /* the level that most of the harder ones take */
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
