/* SPDX-License-Identifier: MIT */
/* One pixel, looked at until it is as accurate as was asked for. */
#ifndef SUPERFRAME_REFINE_H
#define SUPERFRAME_REFINE_H

#include "growth.h"

struct refining {
    const struct scene *scene;            /* its error is not 0, and it has an estimate */
    const struct tree_observer *observer; /* may be NULL */
    uint32_t ray_budget;                  /* of all looks at a pixel together */
};

/* Looks at a pixel with lower and lower thresholds, each time from the beginning. Sets *verdict to
 * the best look's, and *tail to the last one's. An observer sees the best look last, and *tail is
 * that look's then. Returns the steps of the last look. Counts the
 * pixel among the exhausted ones if the budget ended the last look. */
uint8_t refine_pixel(const struct refining *refining, const struct ray *eye_ray,
                     struct render_counts *counts, struct tail *tail, struct tail_verdict *verdict);

#endif
