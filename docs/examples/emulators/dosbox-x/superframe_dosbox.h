/* SPDX-License-Identifier: MIT */
/* The SuperFrame board in DOSBox-X. docs/emulators.md says where each function is called. */
#ifndef SUPERFRAME_DOSBOX_H
#define SUPERFRAME_DOSBOX_H

#include <cstdint>

/* Powers the board on, takes its ports, and registers its save state: when PC-98 mode is entered.
 */
void SUPERFRAME_Start();

/* Resets the board, with the machine. */
void SUPERFRAME_Reset();

/* Draws the board over line y, 640 pixels of 32 bits: between VGA_DrawLine() and
 * RENDER_DrawLine(), which gets what this returns. */
uint8_t *SUPERFRAME_DrawLine(uint8_t *line, unsigned y);

#endif
