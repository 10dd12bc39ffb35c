/* SPDX-License-Identifier: MIT */
/* Fuzzes the board as a part of an emulator: accesses of any width to any port, saved states, and
 * what has changed on the screen. The first byte chooses the board, and whether the rest is a state
 * as it is or steps. Patches of a state get a right checksum, which nobody could guess. */
#include <string.h>

#include "board_screen.h"
#include "board_state.h"
#include "fuzz.h"

#include <libdeflate.h>

enum {
    AS_STATE = 1, /* bits of the first byte; two more give the base's jumper */
    LATER = 2,
    WRAPS = 4,
    NOISE = 8,
    JUMPER = 0xE0,
    DEAR_MOST = 1, /* steps of an input that go through a whole state or screen: 20 ms */
    SCREEN_BYTES = BOARD_WIDTH * BOARD_HEIGHT * 3
};

/* What a step does: the first byte of the step, modulo STEPS. */
enum step { WRITE, READ, WRITE_NEAR, READ_NEAR, BLANK, RESET, RESTORE, PATCH, SHOW, STEPS };

/* The same accesses go to both: the second gets four bytes as two words, and no refused width. */
static struct board board, other, before;
static uint8_t saved[BOARD_STATE_BYTES], again[BOARD_STATE_BYTES];
static uint8_t screen[SCREEN_BYTES], whole[SCREEN_BYTES];
static unsigned dear;

static void power_on(unsigned flags) {
    struct board_desc desc = board_default_desc((flags & LATER) != 0 ? BOARD_LATER : BOARD_1987);
    unsigned jumper = flags >> 5 & 7;
    desc.base = (uint16_t)(BOARD_FACTORY_BASE + (jumper < 7 ? jumper << 9 : 0));
    desc.outside = (flags & WRAPS) != 0 ? BOARD_OUTSIDE_WRAPS : BOARD_OUTSIDE_IGNORED;
    desc.noise = (flags & NOISE) != 0;
    assert(board_init(&board, &desc));
    memcpy(&other, &board, sizeof other);
    memset(screen, 0, sizeof screen);
    dear = 0;
}

/* ---- Accesses ------------------------------------------------------------------------------- */

static void write_both(uint16_t port, uint32_t value, unsigned width) {
    board_write(&board, port, value, width);
    if (width == 4) {
        board_write(&other, port, value & 0xFFFF, 2);
        board_write(&other, (uint16_t)(port + 2), value >> 16, 2);
    } else if (width == 1 || width == 2) {
        board_write(&other, port, value, width);
    }
}

static void read_both(uint16_t port, unsigned width) {
    uint32_t answer = board_read(&board, port, width), expected = UINT32_MAX;
    if (width == 4) {
        expected = board_read(&other, port, 2);
        expected |= board_read(&other, (uint16_t)(port + 2), 2) << 16;
    } else if (width == 1 || width == 2) {
        expected = board_read(&other, port, width);
        assert(expected <= (width == 1 ? 0xFFU : 0xFFFFU));
    }
    assert(answer == expected);
}

/* ---- States --------------------------------------------------------------------------------- */

/* Holds that both boards are in the same state. Their saved bytes would say so too, slowly. */
static void check_equal(void) {
    assert(board.x == other.x && board.y == other.y && board.place == other.place);
    assert(board.index == other.index && board.mode == other.mode);
    assert(board.accesses == other.accesses && board.log_count == other.log_count);
    assert(memcmp(board.controller, other.controller, sizeof board.controller) == 0);
    assert(memcmp(board.writes, other.writes, sizeof board.writes) == 0);
    assert(memcmp(board.reads, other.reads, sizeof board.reads) == 0);
    assert(memcmp(board.notes, other.notes, sizeof board.notes) == 0);
    assert(memcmp(board.memory, other.memory, sizeof board.memory) == 0);
}

/* Puts a state into the other board: a refused one changes nothing, and one that is taken is saved
 * again as the same bytes. Returns whether it was taken. */
static bool take_state(size_t count) {
    memcpy(&before, &other, sizeof before);
    enum board_state_status status = board_restore(&other, saved, count);
    assert(board_state_text(status)[0] != '\0');
    if (status != BOARD_STATE_OK) {
        assert(memcmp(&before, &other, sizeof before) == 0);
        return false;
    }
    board_save(&other, again);
    assert(count == sizeof saved && memcmp(saved, again, sizeof saved) == 0);
    return true;
}

/* Changes some bytes of a state of the board. If that is a state, both boards go on from there. */
static void patch(struct input *input) {
    board_save(&board, saved);
    for (unsigned count = take_byte(input) % 8 + 1; count > 0; count--) {
        unsigned place = take_number(input) % 2600; /* the memory's first bytes too */
        saved[place] = (uint8_t)take_byte(input);
    }
    uint32_t checksum = libdeflate_crc32(0, saved, sizeof saved - 4);
    for (unsigned i = 0; i < 4; i++) {
        saved[sizeof saved - 4 + i] = (uint8_t)(checksum >> 8 * i);
    }
    if (take_state(sizeof saved)) {
        assert(board_restore(&board, saved, sizeof saved) == BOARD_STATE_OK);
    }
}

/* ---- The screen ----------------------------------------------------------------------------- */

/* Draws what has changed, and holds that the screen is then what it would be drawn from scratch.
 * There the PC's picture is black. */
static void show(struct input *input) {
    struct board_area area = board_take_changes(&board);
    assert(area.x + area.width <= BOARD_WIDTH && area.y + area.height <= BOARD_HEIGHT);
    for (unsigned y = area.y; y < area.y + area.height; y++) {
        uint8_t *line = screen + ((size_t)y * BOARD_WIDTH + area.x) * 3;
        struct board_area piece = {area.x, y, area.width, 1};
        memset(line, 0, (size_t)area.width * 3);
        board_draw_over_area(&board, piece, line, 0);
    }
    memset(whole, 0, sizeof whole);
    board_draw_over(&board, whole);
    assert(memcmp(screen, whole, sizeof whole) == 0);
    unsigned x = take_number(input), y = take_number(input);
    struct board_area any = {x, y, take_number(input), take_number(input)};
    if (x < BOARD_WIDTH && y < BOARD_HEIGHT) { /* what is drawn twice stays */
        board_draw_over_area(&board, any, whole + ((size_t)y * BOARD_WIDTH + x) * 3,
                             BOARD_WIDTH * (size_t)3);
    } else {
        board_draw_over_area(&board, any, NULL, 0);
    }
    assert(memcmp(screen, whole, sizeof whole) == 0);
}

static void do_step(enum step step, struct input *input) {
    bool is_near = step == WRITE_NEAR || step == READ_NEAR;
    uint16_t port = 0;
    unsigned width = 0;
    if (step <= READ_NEAR) {
        port =
            (uint16_t)(is_near ? board.desc.base - 4U + take_byte(input) % 24 : take_number(input));
        width = take_byte(input);
        width = width < 0xF0 ? width % 5 : width * 0x01010101U;
    }
    switch (step) {
    case WRITE:
    case WRITE_NEAR: {
        uint32_t low = take_number(input);
        write_both(port, low | (uint32_t)take_number(input) << 16, width);
        break;
    }
    case READ:
    case READ_NEAR:
        read_both(port, width);
        break;
    case BLANK: {
        enum board_blanking blanking = (enum board_blanking)(take_byte(input) % BOARD_BLANKINGS);
        board_set_blanking(&board, blanking);
        board_set_blanking(&other, blanking);
        break;
    }
    case RESET:
        board_reset(&board);
        board_reset(&other);
        break;
    case RESTORE:
        if (dear++ < DEAR_MOST) {
            board_save(&board, saved);
            assert(board_restore(&other, saved, sizeof saved) == BOARD_STATE_OK);
            check_equal();
        }
        break;
    case PATCH:
        if (dear++ < DEAR_MOST) {
            patch(input);
        }
        break;
    case SHOW:
        if (dear++ < DEAR_MOST) {
            show(input);
        }
        break;
    case STEPS:
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    struct input input = {bytes, count};
    unsigned flags = take_byte(&input);
    power_on(flags);
    if ((flags & AS_STATE) != 0) {
        size_t size = input.count < sizeof saved ? input.count : sizeof saved;
        memcpy(saved, input.bytes, size);
        (void)take_state(size);
        return 0;
    }
    while (input.count > 0) {
        do_step((enum step)(take_byte(&input) % STEPS), &input);
    }
    check_equal();
    return 0;
}
