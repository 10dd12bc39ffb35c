/* SPDX-License-Identifier: MIT */
/* The parts of a PC-9801 that a booting floppy meets: the disk, the keyboard, the text screen. */
#ifndef SUPERFRAME_EMULATOR_PC98_MACHINE_H
#define SUPERFRAME_EMULATOR_PC98_MACHINE_H

#include "bus.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    PC98_CYLINDERS = 77,
    PC98_HEADS = 2,
    PC98_SECTORS = 8, /* on a track, counted from 1 */
    PC98_SECTOR_BYTES = 1024,
    PC98_DISK_BYTES = PC98_CYLINDERS * PC98_HEADS * PC98_SECTORS * PC98_SECTOR_BYTES,
    PC98_TEXT_COLUMNS = 80,
    PC98_TEXT_ROWS = 25,
    PC98_TEXT_BYTES = 2 * PC98_TEXT_COLUMNS * PC98_TEXT_ROWS
};

/* Finds the offset in bytes at which a read by INT 1Bh begins on the disk. Returns false if there
 * is no such sector, or the read goes past the disk's end. */
bool pc98_disk_place(unsigned cylinder, unsigned head, unsigned sector, size_t bytes,
                     size_t *offset);

/* The text screen, a string a row, trailing blanks cut. */
struct pc98_text {
    char row[PC98_TEXT_ROWS][PC98_TEXT_COLUMNS + 1];
};

/* Reads the characters of the text VRAM; what is not printable ASCII becomes '?', 0 a blank. */
void pc98_text_read(const uint8_t vram[PC98_TEXT_BYTES], struct pc98_text *text);

/* The ports: the keyboard's two, and the bus behind all others. */
struct pc98_ports {
    struct bus *bus;
    uint64_t keyboard_reads; /* of the status */
    uint64_t escape_after;   /* Esc waits from that read on; 0: no key is ever pressed */
    bool escape_is_taken;
};

/* Does one IN or OUT of `width` bytes: 1, 2 or 4. Four bytes are two words, the lower port
 * first. */
uint32_t pc98_port_read(struct pc98_ports *ports, uint16_t port, unsigned width);
void pc98_port_write(struct pc98_ports *ports, uint16_t port, uint32_t value, unsigned width);

#endif
