/* SPDX-License-Identifier: MIT */
/* A gradient on the SuperFrame board at 00D0h. */
#ifndef GRADIENT_H
#define GRADIENT_H

/* Sets the board up and draws all 640 x 400 pixels: (x * 255 / 639, y * 255 / 399, 128). */
void draw_gradient(void);

#endif
