/* SPDX-License-Identifier: MIT */
/* The interface of the WebAssembly module: the firmware, one scene, and the emulated board. */
#ifndef SUPERFRAME_TARGETS_WASM_H
#define SUPERFRAME_TARGETS_WASM_H

#include <stdint.h>

/* ---- What the page provides: module "env" ---------------------------------------------------- */

/* Tells the page of a write to a port, after the board in the module has got the write. width is 1
 * or 2 bytes. */
__attribute__((import_module("env"), import_name("port_write"))) void
page_port_write(uint32_t port, uint32_t value, uint32_t width);

/* ---- What the module provides, besides its `memory` ------------------------------------------ */

/* Returns the picture's width or height in pixels. Up to 320 x 200, each pixel is shown as 2 x 2
 * dots. */
uint32_t superframe_width(void);
uint32_t superframe_height(void);

/* Powers the board on, its memory black. To be called first. */
void superframe_reset(void);

/* Draws rows first..last-1 through the ports. Each call initialises the board again and keeps the
 * board's picture. 0..height draws all, and makes the rest of the screen black. */
void superframe_draw(uint32_t first, uint32_t last);

/* Returns where the board's frame memory lies: R, G, B, 640 pixels a line, 400 lines. */
uint32_t superframe_pixels(void);

/* Returns how many violations the board has counted; 0 is the only right value. */
uint32_t superframe_violations(void);

#endif
