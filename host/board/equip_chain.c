/* SPDX-License-Identifier: MIT */
/* Puts into the chain of buses what the command line asks for. */
#include "board/equip_chain.h"

#include "board/screen_file.h"
#include "command/command.h"

int open_own_ports(struct ports_linux *ports, const struct options *options) {
    char message[PORTS_LINUX_MESSAGE_SIZE];
    if (options->bus != BUS_CHOICE_PORTS) {
        return STATUS_DONE;
    }
    switch (ports_linux_open(ports, options->base, &ports_linux_system, message)) {
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

int equip_chain(struct port_chain *chain, const struct options *options) {
    const struct board_options *board = &options->board;
    if (board->native != NULL) {
        if (!native_read(&chain->native, board->native)) {
            return STATUS_BAD_INPUT;
        }
        chain->has_native = true;
    }
    if (board->has_faults) {
        port_chain_spoil(chain, &board->faults);
    }
    if (options->stats != NULL) {
        port_chain_count(chain);
    }
    return STATUS_DONE;
}
