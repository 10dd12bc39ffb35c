/* SPDX-License-Identifier: MIT */
/* What a run did with the ports. */
#include "trace_statistics.h"

#include <string.h>

enum { PRIMARIES = 0x7 };

bool trace_statistics_init(struct trace_statistics *statistics, const struct board_desc *desc) {
    memset(statistics, 0, sizeof *statistics);
    return board_init(&statistics->board, desc);
}

static bool is_primary(unsigned offset) {
    return offset >= BOARD_RED && offset <= BOARD_BLUE;
}

/* Returns the place of a primary's register among red, green and blue. */
static unsigned primary_of(unsigned offset) {
    return offset / 2 - BOARD_RED / 2;
}

/* Returns what the register at an even offset holds now. For red, green and blue that is the
 * pixel's primary, 0 where there is no pixel. */
static unsigned register_value(const struct board *board, unsigned offset) {
    switch (offset) {
    case BOARD_CONTROL_1:
        return board->index;
    case BOARD_CONTROL_2:
        return board->controller[board->index];
    case BOARD_X:
        return board->x;
    case BOARD_Y:
        return board->y;
    case BOARD_MODE:
        return board->mode;
    default:
        return board->place < 0 ? 0 : board->memory[(uint32_t)board->place + primary_of(offset)];
    }
}

/* Tells whether a register, or a pixel's primary, was written before. */
static bool was_written(const struct trace_statistics *statistics, unsigned offset) {
    const struct board *board = &statistics->board;
    if (offset == BOARD_CONTROL_2) {
        return board->controller_written[board->index] != 0;
    }
    if (is_primary(offset)) {
        return board->place >= 0 &&
               (statistics->touched[board->place / 3] >> primary_of(offset) & 1) != 0;
    }
    return (statistics->written_registers >> offset / 2 & 1) != 0;
}

static void touch(struct trace_statistics *statistics, uint32_t pixel, unsigned primaries) {
    unsigned touched = statistics->touched[pixel];
    unsigned again = touched & primaries;
    statistics->touched[pixel] = (uint8_t)(touched | primaries | again << 3);
}

/* Counts a fill of the later boards. The fill is redundant if its four pixels had been written and
 * none changes. */
static void add_fill(struct trace_statistics *statistics, const struct trace_access *access) {
    struct board *board = &statistics->board;
    uint8_t before[12] = {0};
    unsigned written = PRIMARIES;
    uint32_t pixel = board->place < 0 ? 0 : (uint32_t)board->place / 3 & ~(uint32_t)3;
    memcpy(before, board->memory + (size_t)pixel * 3, sizeof before);
    bool has_pixel = board->place >= 0;
    board_write(board, access->port, access->value, access->width);
    if (!has_pixel) {
        return;
    }
    for (uint32_t i = 0; i < 4; i++) {
        written &= statistics->touched[pixel + i];
        touch(statistics, pixel + i, PRIMARIES);
    }
    if (written == PRIMARIES &&
        memcmp(before, board->memory + (size_t)pixel * 3, sizeof before) == 0) {
        statistics->redundant_writes++;
    }
}

/* Counts a write that sets the register, or the primary, at an even offset. */
static void add_write(struct trace_statistics *statistics, const struct trace_access *access,
                      unsigned offset) {
    struct board *board = &statistics->board;
    bool was = was_written(statistics, offset);
    unsigned before = register_value(board, offset);
    int32_t place = board->place;
    uint16_t x = board->x;
    board_write(board, access->port, access->value, access->width);
    if (is_primary(offset)) {
        if (place >= 0) {
            unsigned primary = primary_of(offset);
            unsigned after = board->memory[(uint32_t)place + primary];
            statistics->redundant_writes += was && before == after ? 1 : 0;
            touch(statistics, (uint32_t)place / 3, 1U << primary);
        }
        /* By mode bit 40h a write of blue sets X too. */
        statistics->written_registers |= board->x != x ? 1U << BOARD_X / 2 : 0;
        return;
    }
    statistics->redundant_writes += was && before == register_value(board, offset) ? 1 : 0;
    statistics->written_registers = (uint16_t)(statistics->written_registers | 1U << offset / 2);
}

uint16_t trace_statistics_add(struct trace_statistics *statistics,
                              const struct trace_access *access) {
    struct board *board = &statistics->board;
    unsigned offset = (uint16_t)(access->port - board->desc.base);
    if (access->is_read) {
        statistics->reads++;
        return (uint16_t)board_read(board, access->port, access->width);
    }
    statistics->writes++;
    bool is_odd = (offset & 1) != 0;
    unsigned even = offset & ~1U;
    bool is_position = even == BOARD_X || even == BOARD_Y;
    if (offset >= BOARD_PORTS || (is_odd && (access->width == BUS_WORD || !is_position))) {
        /* Elsewhere, split in two or without effect: such a write can't be redundant. */
        board_write(board, access->port, access->value, access->width);
    } else if (offset == BOARD_RED && access->width == BUS_WORD &&
               board->desc.profile == BOARD_LATER) {
        add_fill(statistics, access);
    } else {
        add_write(statistics, access, even);
    }
    return 0;
}

struct trace_pixels trace_statistics_pixels(const struct trace_statistics *statistics) {
    struct trace_pixels pixels = {0, 0, 0};
    for (size_t i = 0; i < (size_t)BOARD_WIDTH * BOARD_HEIGHT; i++) {
        if (statistics->touched[i] == 0) {
            pixels.never++;
        } else if (statistics->touched[i] <= PRIMARIES) {
            pixels.once++;
        } else {
            pixels.again++;
        }
    }
    return pixels;
}
