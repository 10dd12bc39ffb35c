/* SPDX-License-Identifier: MIT */
/* The interface of the WebAssembly module: the firmware, one scene, and the emulated board. */
#ifndef SUPERFRAME_TARGETS_WASM_H
#define SUPERFRAME_TARGETS_WASM_H

#include <stdint.h>

/* ---- What the page provides: module "env" ---------------------------------------------------- */

/* Told of each write to a port, after the board in the module has got it: width 1 or 2 bytes. */
__attribute__((import_module("env"), import_name("port_write"))) void
page_port_write(uint32_t port, uint32_t value, uint32_t width);

/* ---- What the module provides, besides its `memory` ------------------------------------------ */

/* The picture's size in pixels; up to 320 x 200 each is shown as 2 x 2 dots. */
uint32_t superframe_width(void);
uint32_t superframe_height(void);

/* Powers the board on, black. To be called first. */
void superframe_reset(void);

/* Draws rows first .. last-1 through the ports; each call initialises the board again and keeps its
 * picture. 0 .. height draws all, and makes the rest of the screen black. */
void superframe_draw(uint32_t first, uint32_t last);

/* Where the board's frame memory lies: R, G, B, 640 pixels a line, 400 lines. */
uint32_t superframe_pixels(void);

/* Accesses that the board does not allow; 0 is the only right value. */
uint32_t superframe_violations(void);

#endif
