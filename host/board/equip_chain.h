/* SPDX-License-Identifier: MIT */
/* Puts into the chain of buses what the command line asks for. */
#ifndef SUPERFRAME_EQUIP_CHAIN_H
#define SUPERFRAME_EQUIP_CHAIN_H

#include "board/options.h"
#include "board/port_chain.h"
#include "ports_linux.h"

/* Opens the machine's own ports, and gives up what rights the program has besides. Has to be called
 * before anything else is opened. Returns STATUS_DONE; otherwise the reason is printed. */
int open_own_ports(struct ports_linux *ports, uint16_t base);

/* Puts in the PC's own screen (--native) and the faults (--faults). If the statistics ask for a
 * count of the accesses, puts that in too. Has to be called before any access, and before the
 * recorder is put in. Returns STATUS_DONE; otherwise the reason is printed. */
int equip_chain(struct port_chain *chain, const struct board_options *board, bool counts);

#endif
