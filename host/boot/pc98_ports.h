/* SPDX-License-Identifier: MIT */
/* The ports of a PC-9801 that a booting floppy meets, the bus behind them all. */
#ifndef SUPERFRAME_PC98_PORTS_H
#define SUPERFRAME_PC98_PORTS_H

#include "bus.h"

#include <stdbool.h>
#include <stdint.h>

/* So many reads of the keyboard's status, with no other port in between, are a wait for a key. */
enum { PC98_POLLS_OF_A_WAIT = 2000000 };

/* The ports. Those of the machine itself end here: the keyboard, the graphics, address line 20 and
 * the reset. All others go to the bus. Begins as all zero but for the bus and escape_after. */
struct pc98_ports {
    struct bus *bus;
    uint64_t keyboard_reads; /* of the status */
    uint64_t escape_after;   /* Esc waits from that read on; 0: no key is ever pressed */
    bool escape_is_taken;
    uint32_t polls;     /* reads of the keyboard's status since the last other access */
    bool is_line_20_on; /* false: address bit 20 is 0 whatever the program says, as at power-on */
    bool is_reset;      /* by OUT F0h */
};

/* Does one IN or OUT of `width` bytes: 1, 2 or 4. Four bytes are two words, the lower port
 * first. */
uint32_t pc98_port_read(struct pc98_ports *ports, uint16_t port, unsigned width);
void pc98_port_write(struct pc98_ports *ports, uint16_t port, uint32_t value, unsigned width);

/* Tells whether the program waits for a key, and no key will come any more. */
bool pc98_ports_wait_in_vain(const struct pc98_ports *ports);

#endif
