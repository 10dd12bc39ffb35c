/* SPDX-License-Identifier: MIT */
/* The ports of a PC-9801 that a booting floppy meets, the bus behind them all. */
#include "boot/pc98_ports.h"

#include <stddef.h>

/* The keyboard's 8251. A key that is pressed gives its number, Esc 00h. The status has the two bits
 * of an idle transmitter set at all times. */
enum {
    KEYBOARD_DATA = 0x41,
    KEYBOARD_STATUS = 0x43,
    KEY_IS_WAITING = 0x02,
    KEYBOARD_IDLE = 0x85,
    KEY_ESCAPE = 0x00
};

/* Reset and address line 20. Source: UNDOCUMENTED (io_cpu). */
enum {
    RESET = 0xF0,
    LINE_20_ON = 0xF2, /* any write; bit 0 of a read: the line is off */
    LINE_20 = 0xF6,
    LINE_20_IS_ON = 0x02,
    LINE_20_IS_OFF = 0x03
};

/* Ports of the PC's own screen. What they are set to is not modelled: the text is taken to be on,
 * and the graphics are given from outside. */
static const uint16_t screen_ports[] = {0x68, 0x6A, 0xA0, 0xA2, 0xA4, 0xA6, 0xA8, 0xAA, 0xAC, 0xAE};

static bool is_of_the_screen(uint16_t port) {
    for (size_t i = 0; i < sizeof screen_ports / sizeof screen_ports[0]; i++) {
        if (port == screen_ports[i]) {
            return true;
        }
    }
    return false;
}

static bool escape_is_waiting(const struct pc98_ports *ports) {
    return ports->escape_after != 0 && ports->keyboard_reads >= ports->escape_after &&
           !ports->escape_is_taken;
}

bool pc98_ports_wait_in_vain(const struct pc98_ports *ports) {
    return ports->polls > PC98_POLLS_OF_A_WAIT &&
           (ports->escape_after == 0 || ports->escape_is_taken);
}

uint32_t pc98_port_read(struct pc98_ports *ports, uint16_t port, unsigned width) {
    if (width == 1 && port == KEYBOARD_STATUS) {
        ports->keyboard_reads++;
        ports->polls++;
        return KEYBOARD_IDLE | (escape_is_waiting(ports) ? KEY_IS_WAITING : 0U);
    }
    if (width == 1 && port == KEYBOARD_DATA) {
        uint32_t key = escape_is_waiting(ports) ? KEY_ESCAPE : 0xFF;
        ports->escape_is_taken = ports->escape_is_taken || escape_is_waiting(ports);
        return key;
    }
    ports->polls = 0;
    if (width == 1 && port == LINE_20_ON) {
        return ports->is_line_20_on ? 0xFE : 0xFF;
    }
    if (width == 4) {
        uint32_t low = bus_read(ports->bus, port, BUS_WORD);
        return low | (uint32_t)bus_read(ports->bus, (uint16_t)(port + 2), BUS_WORD) << 16;
    }
    return bus_read(ports->bus, port, width);
}

/* Does a write to a port of the machine itself; false if the port is none. */
static bool write_machine(struct pc98_ports *ports, uint16_t port, uint8_t value) {
    switch (port) {
    case RESET:
        ports->is_reset = true;
        return true;
    case LINE_20_ON:
        ports->is_line_20_on = true;
        return true;
    case LINE_20:
        if (value == LINE_20_IS_ON || value == LINE_20_IS_OFF) {
            ports->is_line_20_on = value == LINE_20_IS_ON;
        }
        return true;
    default:
        return is_of_the_screen(port);
    }
}

void pc98_port_write(struct pc98_ports *ports, uint16_t port, uint32_t value, unsigned width) {
    ports->polls = 0;
    if (write_machine(ports, port, (uint8_t)value)) {
        return;
    }
    if (width == 4) {
        bus_write(ports->bus, port, (uint16_t)value, BUS_WORD);
        bus_write(ports->bus, (uint16_t)(port + 2), (uint16_t)(value >> 16), BUS_WORD);
        return;
    }
    bus_write(ports->bus, port, (uint16_t)value, width);
}
