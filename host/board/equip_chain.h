/* SPDX-License-Identifier: MIT */
/* Puts into the chain of buses what the command line asks for. */
#ifndef SUPERFRAME_EQUIP_CHAIN_H
#define SUPERFRAME_EQUIP_CHAIN_H

#include "options/options.h"
#include "board/port_chain.h"
#include "ports_linux.h"

/* Opens the machine's own ports if --bus ports asks for them, and gives up what rights the program
 * has besides: to be called before anything else is opened. STATUS_DONE; else the reason is
 * printed. */
int open_own_ports(struct ports_linux *ports, const struct options *options);

/* The PC's own screen (--native), the faults (--faults), the count for --stats. To be called before
 * any access, and before the recorder is put in. STATUS_DONE; else the reason is printed. */
int equip_chain(struct port_chain *chain, const struct options *options);

#endif
