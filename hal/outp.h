/* SPDX-License-Identifier: MIT */
/* The seam between firmware and hardware: the four port accesses of DOS's conio.h. */
#ifndef SUPERFRAME_HAL_OUTP_H
#define SUPERFRAME_HAL_OUTP_H

#include <stdint.h>

/* All four take the port first and the value second, as conio.h does. Linux's outb() takes the
 * value first; hal/ports_linux.c is the one file that swaps the two.
 *
 * On a bare target each is one instruction (or a store to a memory-mapped bus). On the host each
 * goes to the bus that bus_bind() named (bus.h). With no bus bound, or after the bus has failed,
 * writes are dropped and reads give FFh or FFFFh. bus_bound_status() then says why. */

/* Writes one byte: an even port drives D7-0, an odd port D15-8. */
void outp(uint16_t port, uint8_t value);

/* Writes one word. The low byte goes to the port, the high byte to the port above. */
void outpw(uint16_t port, uint16_t value);

/* Reads one byte. A port that nobody decodes gives FFh. */
uint8_t inp(uint16_t port);

/* Reads one word. A port that nobody decodes gives FFFFh. */
uint16_t inpw(uint16_t port);

#endif
