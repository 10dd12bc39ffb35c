/* SPDX-License-Identifier: MIT */
/* One frame of the scene that a target was built for. */
#ifndef SUPERFRAME_TARGETS_FRAME_H
#define SUPERFRAME_TARGETS_FRAME_H

/* Draws the whole picture through the ports, all eight exposures of a multiple one, and hands on
 * what is buffered. */
void frame_draw(void);

#endif
