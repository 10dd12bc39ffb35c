/* SPDX-License-Identifier: MIT */
/* One pixel of an image of the firmware as a host sees it. */
#ifndef SUPERFRAME_OBSERVE_H
#define SUPERFRAME_OBSERVE_H

#include "image.h"
#include "render/observed.h"

/* Renders one pixel and tells its tree, as pixel() of render/arithmetic.h says. */
void observe_pixel(const struct scene *scene, uint16_t x, uint16_t y, double intensity[3],
                   struct render_counts *counts, const struct pixel_observer *observer);

#endif
