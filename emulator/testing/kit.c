/* SPDX-License-Identifier: MIT */
/* The board under test: every access is remembered on its way to the board. */
#include "testing.h"

#include <stdlib.h>

enum { FIRST_CAPACITY = 4096 };

/* Appends an access to the kit's accesses. If out of memory, returns false and fails the bus, so
 * that no assertion holds any more. */
static bool remember(struct superframe_kit *kit, const struct trace_access *access) {
    if (kit->count == kit->capacity) {
        size_t capacity = kit->capacity == 0 ? FIRST_CAPACITY : kit->capacity * 2;
        struct trace_access *more = realloc(kit->accesses, capacity * sizeof *more);
        if (more == NULL) {
            bus_fail(&kit->bus, BUS_IO_ERROR);
            return false;
        }
        kit->accesses = more;
        kit->capacity = capacity;
    }
    kit->accesses[kit->count++] = *access;
    return true;
}

static void kit_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct superframe_kit *kit = (struct superframe_kit *)bus;
    const struct trace_access access = {port, value, (uint8_t)width, false};
    if (remember(kit, &access)) {
        board_write(&kit->board, port, value, width);
    }
}

static uint16_t kit_read(struct bus *bus, uint16_t port, unsigned width) {
    struct superframe_kit *kit = (struct superframe_kit *)bus;
    struct trace_access access = {port, 0, (uint8_t)width, true};
    access.value = (uint16_t)board_read(&kit->board, port, width);
    return remember(kit, &access) ? access.value : 0xFFFF;
}

static const struct bus_operations kit_operations = {kit_write, kit_read, NULL};

struct superframe_kit *superframe_kit_new_desc(const struct board_desc *desc) {
    struct superframe_kit *kit = calloc(1, sizeof *kit);
    if (kit == NULL || !board_init(&kit->board, desc)) {
        free(kit);
        return NULL;
    }
    kit->bus.operations = &kit_operations;
    (void)bus_bind(&kit->bus);
    return kit;
}

struct superframe_kit *superframe_kit_new(enum board_profile profile) {
    struct board_desc desc = board_default_desc(profile);
    return superframe_kit_new_desc(&desc);
}

void superframe_kit_free(struct superframe_kit *kit) {
    if (kit == NULL) {
        return;
    }
    struct bus *bound = bus_bind(NULL);
    if (bound != &kit->bus) {
        (void)bus_bind(bound);
    }
    free(kit->accesses);
    free(kit);
}

void superframe_kit_mark(struct superframe_kit *kit) {
    kit->mark = kit->count;
}
