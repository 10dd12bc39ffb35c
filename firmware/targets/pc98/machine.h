/* SPDX-License-Identifier: MIT */
/* The PC-9801 as far as the image uses it: text VRAM and keyboard. */
#ifndef SUPERFRAME_TARGETS_PC98_MACHINE_H
#define SUPERFRAME_TARGETS_PC98_MACHINE_H

#include <stdbool.h>
#include <stdint.h>

enum { TEXT_COLUMNS = 80, TEXT_ROWS = 25 };

/* Makes the whole text screen blank. */
void text_clear(void);

/* Writes ASCII in row 0..24, from column 0..79 on; returns the column after the text. What is past
 * the line's end is lost. */
uint8_t text_put(uint8_t row, uint8_t column, const char *text);

/* Writes a number, 0..65535, as text_put() writes text. */
uint8_t text_put_number(uint8_t row, uint8_t column, uint16_t number);

/* Shows the text, or hides every cell without changing it. Text that was put while hidden is
 * shown. */
void text_show(bool is_shown);

/* Waits until a key is pressed. Returns false at once if there is no keyboard. */
bool key_wait(void);

/* Tells whether Esc was pressed since the last call. Reads at most a few waiting keys. */
bool escape_pressed(void);

#endif
