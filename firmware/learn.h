/* SPDX-License-Identifier: MIT */
/* The estimated radiance of pruned branches, learned from a few hundred pixels. */
#ifndef SUPERFRAME_LEARN_H
#define SUPERFRAME_LEARN_H

#include "image.h"

/* Learns the radiance of pruned branches, as image.h says of learn(). */
void learn_estimate(const struct scene *scene, struct estimate *estimate,
                    struct render_counts *counts);

#endif
