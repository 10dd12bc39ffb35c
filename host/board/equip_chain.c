/* SPDX-License-Identifier: MIT */
/* Puts into the chain of buses what the command line asks for. */
#include "board/equip_chain.h"

#include "base/complain.h"
#include "board/screen_file.h"

int open_own_ports(struct ports_linux *ports, uint16_t base) {
    char message[PORTS_LINUX_MESSAGE_SIZE];
    switch (ports_linux_open(ports, base, &ports_linux_system, message)) {
    case PORTS_LINUX_OPEN:
        return STATUS_DONE;
    case PORTS_LINUX_OWNED:
        return bad_input("--bus ports: %s", message);
    case PORTS_LINUX_REFUSED:
        break;
    }
    complain("--bus ports: %s", message);
    return STATUS_FAILED;
}

int equip_chain(struct port_chain *chain, const struct board_options *board, bool counts) {
    if (board->native != NULL) {
        if (!native_read(&chain->native, board->native)) {
            return STATUS_BAD_INPUT;
        }
        chain->has_native = true;
    }
    if (board->has_faults) {
        port_chain_spoil(chain, &board->faults);
    }
    if (counts) {
        port_chain_count(chain);
    }
    return STATUS_DONE;
}
