/* SPDX-License-Identifier: MIT */
/* The board plugged into a bus. */
#include "board.h"

#include <stddef.h>

static void bus_to_board_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    board_write(((struct board_bus *)bus)->board, port, value, width);
}

static uint16_t bus_to_board_read(struct bus *bus, uint16_t port, unsigned width) {
    return (uint16_t)board_read(((struct board_bus *)bus)->board, port, width);
}

static const struct bus_operations board_operations = {bus_to_board_write, bus_to_board_read, NULL};

void board_bus_init(struct board_bus *board_bus, struct board *board) {
    board_bus->bus.operations = &board_operations;
    board_bus->bus.status = BUS_OK;
    board_bus->board = board;
}
