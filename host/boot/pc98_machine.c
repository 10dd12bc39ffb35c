/* SPDX-License-Identifier: MIT */
/* The parts of a PC-9801 that a booting floppy meets: the disk, the keyboard, the text screen. */
#include "boot/pc98_machine.h"

/* The keyboard's 8251; a key that is pressed gives its number, Esc 00h. */
enum { KEYBOARD_DATA = 0x41, KEYBOARD_STATUS = 0x43, KEY_IS_WAITING = 0x02, KEY_ESCAPE = 0x00 };

bool pc98_disk_place(unsigned cylinder, unsigned head, unsigned sector, size_t bytes,
                     size_t *offset) {
    if (cylinder >= PC98_CYLINDERS || head >= PC98_HEADS || sector < 1 || sector > PC98_SECTORS) {
        return false;
    }
    size_t place = (size_t)(cylinder * PC98_HEADS + head) * PC98_SECTORS + sector - 1;
    *offset = place * PC98_SECTOR_BYTES;
    return bytes <= PC98_DISK_BYTES - *offset;
}

void pc98_text_read(const uint8_t vram[PC98_TEXT_BYTES], struct pc98_text *text) {
    for (unsigned row = 0; row < PC98_TEXT_ROWS; row++) {
        unsigned length = 0;
        for (unsigned column = 0; column < PC98_TEXT_COLUMNS; column++) {
            const uint8_t *cell = &vram[2 * (row * PC98_TEXT_COLUMNS + column)];
            char letter = cell[0] == 0 && cell[1] == 0 ? ' ' : '?';
            if (cell[1] == 0 && cell[0] >= 0x20 && cell[0] < 0x7F) {
                letter = (char)cell[0];
            }
            text->row[row][column] = letter;
            length = letter == ' ' ? length : column + 1;
        }
        text->row[row][length] = '\0';
    }
}

static bool escape_is_waiting(const struct pc98_ports *ports) {
    return ports->escape_after != 0 && ports->keyboard_reads >= ports->escape_after &&
           !ports->escape_is_taken;
}

uint32_t pc98_port_read(struct pc98_ports *ports, uint16_t port, unsigned width) {
    if (width == 4) {
        uint32_t low = bus_read(ports->bus, port, BUS_WORD);
        return low | (uint32_t)bus_read(ports->bus, (uint16_t)(port + 2), BUS_WORD) << 16;
    }
    if (width == 1 && port == KEYBOARD_STATUS) {
        ports->keyboard_reads++;
        return escape_is_waiting(ports) ? KEY_IS_WAITING : 0;
    }
    if (width == 1 && port == KEYBOARD_DATA) {
        uint32_t key = escape_is_waiting(ports) ? KEY_ESCAPE : 0xFF;
        ports->escape_is_taken = ports->escape_is_taken || escape_is_waiting(ports);
        return key;
    }
    return bus_read(ports->bus, port, width);
}

void pc98_port_write(struct pc98_ports *ports, uint16_t port, uint32_t value, unsigned width) {
    if (width == 4) {
        bus_write(ports->bus, port, (uint16_t)value, BUS_WORD);
        bus_write(ports->bus, (uint16_t)(port + 2), (uint16_t)(value >> 16), BUS_WORD);
        return;
    }
    bus_write(ports->bus, port, (uint16_t)value, width);
}
