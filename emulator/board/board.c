/* SPDX-License-Identifier: MIT */
/* What each port access does to the board. */
#include "board.h"

#include "board_internal.h"

enum {
    /* 17.73 ms at 56.4 Hz, at 0.4 us an access (the only figure known, an emulator's model). */
    FRAME_ACCESSES = 44326,
    FRAME_SHOWN_ACCESSES = FRAME_ACCESSES * 10 / 11 /* 400 of 440 lines */
};

/* ---- The position --------------------------------------------------------------------------- */

/* Widens the changes by the column and the line that X and Y name. Each counts by itself, since the
 * other may be outside at first. Noted here, a change costs nothing where a pixel is written. */
static void note_place(struct board *board, unsigned x, unsigned y) {
    struct board_changes *changes = &board->changes;
    if (x < BOARD_WIDTH) {
        board_note_columns(board, x, x + 1);
    }
    if (y < BOARD_MEMORY_HEIGHT) {
        changes->top = y < changes->top ? (uint16_t)y : changes->top;
        changes->bottom = y >= changes->bottom ? (uint16_t)(y + 1) : changes->bottom;
    }
}

void board_locate(struct board *board) {
    uint32_t x = board->x;
    uint32_t y = board->y;
    board->is_wrapped = false;
    if (x >= BOARD_WIDTH && board->desc.outside == BOARD_OUTSIDE_WRAPS) {
        x -= BOARD_WIDTH; /* X has 10 bits, so this is at most 383 */
        board->is_wrapped = true;
    }
    bool is_shown = x < BOARD_WIDTH && y < BOARD_HEIGHT;
    bool is_hidden = board->desc.profile == BOARD_LATER && x < BOARD_HIDDEN_WIDTH &&
                     y >= BOARD_HEIGHT && y < BOARD_HIDDEN_HEIGHT;
    board->place = is_shown || is_hidden ? (int32_t)((y * BOARD_WIDTH + x) * 3) : -1;
    note_place(board, x, y);
}

void board_forget_changes(struct board *board) {
    static const struct board_changes none = {BOARD_WIDTH, BOARD_MEMORY_HEIGHT, 0, 0, false, false};
    board->changes = none;
    board_locate(board);
}

static void set_x(struct board *board, unsigned x) {
    board->x = (uint16_t)(x & BOARD_X_MASK);
    board_locate(board);
}

static void set_y(struct board *board, unsigned y) {
    board->y = (uint16_t)(y & BOARD_Y_MASK);
    board_locate(board);
}

/* ---- Notes ---------------------------------------------------------------------------------- */

/* The access that is being served, for the log. */
struct access {
    uint16_t port;
    uint16_t value;
    uint8_t width;
    bool is_read;
};

/* Counts a use of a behaviour that may be a violation. If the board's profile calls the behaviour
 * one and the log has room, the access is logged. */
static void report(struct board *board, enum board_behaviour behaviour, struct access access) {
    board_note_use(board, behaviour);
    if (board->log_count < BOARD_LOG_SIZE &&
        board_behaviour_is_violation(behaviour, board->desc.profile)) {
        struct board_violation *entry = &board->log[board->log_count++];
        entry->access = board->accesses;
        entry->behaviour = behaviour;
        entry->port = access.port;
        entry->value = access.value;
        entry->width = access.width;
        entry->is_read = access.is_read;
    }
}

/* ---- Pixels --------------------------------------------------------------------------------- */

/* Reports a pixel access away from the shown 640 x 400. Returns false if there is no pixel. Both
 * ends of place are checked: a board that was read back from a file may have any place. */
static bool pixel_is_there(struct board *board, struct access access) {
    if (board->place < 0 || board->is_wrapped) {
        report(board, access.is_read ? BOARD_OUTSIDE_READ : BOARD_OUTSIDE_WRITE, access);
    }
    if (board->place >= BOARD_WIDTH * BOARD_HEIGHT * 3) {
        board_note_use(board, BOARD_HIDDEN_ACCESS);
    }
    return board->place >= 0 && board->place <= BOARD_MEMORY_BYTES - 3;
}

static inline void write_primary(struct board *board, unsigned primary, struct access access) {
    if (board_pixel_is_plain(board) || pixel_is_there(board, access)) {
        board->changes.is_written = true;
        board->memory[(uint32_t)board->place + primary] = (uint8_t)access.value;
    }
}

static uint8_t read_primary(struct board *board, unsigned primary, struct access access) {
    if (board_pixel_is_plain(board) || pixel_is_there(board, access)) {
        return board->memory[(uint32_t)board->place + primary];
    }
    return 0xFF;
}

/* Writes a word to red. The later boards fill all three primaries of four pixels with the low byte.
 * The board of 1987 takes the word as a byte. */
static void fill(struct board *board, struct access access) {
    report(board, BOARD_RED_WORD_WRITE, access);
    if (board->desc.profile == BOARD_1987) {
        write_primary(board, 0, access);
        return;
    }
    if ((board->x & 3) != 0 || access.value != 0) {
        report(board, BOARD_FILL_UNSEEN, access);
    }
    if (board_pixel_is_plain(board) || pixel_is_there(board, access)) {
        /* Lines begin at a multiple of four pixels, so rounding the pixel rounds X. */
        uint32_t pixel = (uint32_t)board->place / 3 & ~(uint32_t)3;
        board_note_columns(board, pixel % BOARD_WIDTH, pixel % BOARD_WIDTH + 4);
        board->changes.is_written = true;
        for (uint32_t i = 0; i < 4 * 3; i++) {
            board->memory[pixel * 3 + i] = (uint8_t)access.value;
        }
    }
}

/* ---- Control 1, control 2, mode ------------------------------------------------------------- */

static void write_data(struct board *board, struct access access) {
    uint8_t value = (uint8_t)access.value;
    board_note_use(board, BOARD_DATA_WRITE);
    board->controller[board->index] = value;
    board->controller_written[board->index] = 1;
    board->changes.is_all = true;
    if (board_index_is_start_address(board->index)) {
        if (value != 0xFF) {
            report(board, BOARD_START_ADDRESS, access);
        }
    } else if (!board_index_is_initialised(board->index)) {
        report(board, BOARD_UNKNOWN_INDEX, access);
    }
}

static bool is_blank(const struct board *board) {
    return board->blanking == BOARD_BLANKING_COUNTED
               ? board->accesses % FRAME_ACCESSES >= FRAME_SHOWN_ACCESSES
               : board->blanking == BOARD_BLANKING_ON;
}

static uint8_t read_data(struct board *board, struct access access) {
    if (board->desc.profile == BOARD_LATER && board->index == BOARD_STATUS_INDEX) {
        board_note_use(board, BOARD_STATUS_READ);
        return is_blank(board) ? BOARD_STATUS_BLANK : 0;
    }
    if (board->controller_written[board->index] == 0) {
        access.value = board->controller[board->index];
        report(board, BOARD_UNWRITTEN_READ, access);
    } else {
        board_note_use(board, BOARD_DATA_READ);
    }
    return board->controller[board->index];
}

static void write_mode(struct board *board, struct access access) {
    uint8_t mode = (uint8_t)access.value;
    board->mode = mode;
    board->is_stepping = board_steps(board);
    board->changes.is_all = true;
    if (mode == BOARD_MODE_PC || mode == BOARD_MODE_BOTH || mode == BOARD_MODE_BOARD) {
        board_note_use(board, BOARD_MODE_WRITE);
    } else {
        report(board, BOARD_MODE_UNKNOWN, access);
    }
}

/* Steps X by one after a write of blue. Which access steps X is not known, but blue is the last
 * primary of a pixel in every driver. */
static void step_x(struct board *board, struct access access) {
    report(board, BOARD_AUTO_INCREMENT, access);
    set_x(board, board->x + 1U);
}

/* ---- Writes --------------------------------------------------------------------------------- */

static void write_byte(struct board *board, unsigned offset, struct access access) {
    switch (offset) {
    case BOARD_CONTROL_1:
        board_note_use(board, BOARD_INDEX_WRITE);
        board->index = (uint8_t)access.value;
        break;
    case BOARD_CONTROL_2:
        write_data(board, access);
        break;
    case BOARD_X:
        board_note_use(board, BOARD_POSITION_LOW_WRITE);
        set_x(board, (board->x & 0xFF00U) | access.value);
        break;
    case BOARD_X + 1:
        report(board, BOARD_POSITION_HIGH_WRITE, access);
        set_x(board, (board->x & 0x00FFU) | (unsigned)access.value << 8);
        break;
    case BOARD_Y:
        board_note_use(board, BOARD_POSITION_LOW_WRITE);
        set_y(board, (board->y & 0xFF00U) | access.value);
        break;
    case BOARD_Y + 1:
        report(board, BOARD_POSITION_HIGH_WRITE, access);
        set_y(board, (board->y & 0x00FFU) | (unsigned)access.value << 8);
        break;
    case BOARD_RED:
        board_note_use(board, BOARD_PRIMARY_WRITE);
        write_primary(board, 0, access);
        break;
    case BOARD_GREEN:
        board_note_use(board, BOARD_PRIMARY_WRITE);
        write_primary(board, 1, access);
        break;
    case BOARD_BLUE:
        board_note_use(board, BOARD_PRIMARY_WRITE);
        write_primary(board, 2, access);
        if (board->is_stepping) {
            step_x(board, access);
        }
        break;
    case BOARD_MODE:
        write_mode(board, access);
        break;
    default:
        report(board, BOARD_ODD_WRITE, access);
        break;
    }
}

static void write_word(struct board *board, unsigned offset, struct access access) {
    switch (offset) {
    case BOARD_X:
        board_note_use(board, BOARD_POSITION_WRITE);
        set_x(board, access.value);
        break;
    case BOARD_Y:
        board_note_use(board, BOARD_POSITION_WRITE);
        set_y(board, access.value);
        break;
    case BOARD_RED:
        fill(board, access);
        break;
    case BOARD_GREEN:
    case BOARD_BLUE:
        report(board, BOARD_PRIMARY_WORD_WRITE, access);
        write_primary(board, offset / 2 - BOARD_RED / 2, access);
        break;
    default: /* control 1, control 2, mode: bits 15-8 are "don't care" */
        write_byte(board, offset, access);
        break;
    }
}

/* Writes one half of a word at an odd port: CPU and bus make two byte accesses of such a word. */
static void write_half(struct board *board, uint16_t port, unsigned value) {
    unsigned offset = (uint16_t)(port - board->desc.base);
    struct access access = {port, (uint16_t)(value & 0xFF), BOARD_BYTE, false};
    if (offset < BOARD_PORTS) {
        write_byte(board, offset, access);
    } else {
        board_note_use(board, BOARD_FOREIGN_WRITE);
    }
}

static void write_split(struct board *board, uint16_t port, uint16_t value) {
    uint16_t next = (uint16_t)(port + 1);
    if (board_decodes(board, port) || board_decodes(board, next)) {
        board_note_use(board, BOARD_WORD_SPLIT);
        write_half(board, port, value);
        write_half(board, next, (unsigned)value >> 8);
    } else {
        board_note_use(board, BOARD_FOREIGN_WRITE);
    }
}

/* Tells whether a width is one that a 16-bit bus has. */
static bool is_of_the_bus(unsigned width) {
    return width == BOARD_BYTE || width == BOARD_WORD;
}

/* Does a write of one byte or one word. */
static void write_once(struct board *board, uint16_t port, uint16_t value, unsigned width) {
    unsigned offset = (uint16_t)(port - board->desc.base);
    bool is_decoded = offset < BOARD_PORTS;
    struct access access = {port, value, (uint8_t)width, false};
    board->accesses++;
    if (is_decoded) {
        board->writes[offset][width - 1]++;
    }
    if (is_decoded && width == BOARD_BYTE) {
        access.value &= 0xFF;
        write_byte(board, offset, access);
    } else if (is_decoded && (offset & 1) == 0) {
        write_word(board, offset, access);
    } else if (width == BOARD_WORD && (port & 1) != 0) {
        write_split(board, port, value);
    } else {
        board_note_use(board, BOARD_FOREIGN_WRITE);
    }
}

void board_write_any(struct board *board, uint16_t port, uint32_t value, unsigned width) {
    if (is_of_the_bus(width)) {
        write_once(board, port, (uint16_t)value, width);
    } else if (width == BOARD_TWO_WORDS) {
        write_once(board, port, (uint16_t)value, BOARD_WORD);
        write_once(board, (uint16_t)(port + 2), (uint16_t)(value >> 16), BOARD_WORD);
    }
}

/* ---- Reads ---------------------------------------------------------------------------------- */

static uint8_t read_byte(struct board *board, unsigned offset, struct access access) {
    switch (offset) {
    case BOARD_CONTROL_1:
        access.value = 0x00;
        report(board, BOARD_CONTROL1_BYTE_READ, access);
        return 0x00;
    case BOARD_CONTROL_1 + 1:
        access.value = 0x00;
        report(board, BOARD_ODD_READ, access);
        return 0x00;
    case BOARD_CONTROL_2:
        return read_data(board, access);
    case BOARD_RED:
    case BOARD_GREEN:
    case BOARD_BLUE:
        board_note_use(board, BOARD_PRIMARY_READ);
        return read_primary(board, offset / 2 - BOARD_RED / 2, access);
    case BOARD_X:
    case BOARD_Y:
    case BOARD_MODE:
        report(board, BOARD_WRITE_ONLY_READ, access);
        return 0xFF;
    default:
        report(board, BOARD_ODD_READ, access);
        return 0xFF;
    }
}

static uint16_t read_word(struct board *board, unsigned offset, struct access access) {
    switch (offset) {
    case BOARD_CONTROL_1:
        /* A board that reads back what was written would be taken for the other family. */
        access.value = 0x0000;
        report(board, BOARD_CONTROL1_READ, access);
        return 0x0000;
    case BOARD_CONTROL_2:
        return (uint16_t)(0xFF00U | read_data(board, access));
    case BOARD_RED:
    case BOARD_GREEN:
    case BOARD_BLUE:
        access.value =
            (uint16_t)(0xFF00U | read_primary(board, offset / 2 - BOARD_RED / 2, access));
        report(board, BOARD_PRIMARY_WORD_READ, access);
        return access.value;
    default:
        report(board, BOARD_WRITE_ONLY_READ, access);
        return 0xFFFF;
    }
}

static uint8_t read_half(struct board *board, uint16_t port) {
    unsigned offset = (uint16_t)(port - board->desc.base);
    struct access access = {port, 0x00FF, BOARD_BYTE, true};
    if (offset < BOARD_PORTS) {
        return read_byte(board, offset, access);
    }
    report(board, BOARD_FOREIGN_READ, access);
    return 0xFF;
}

/* Does a read of one byte or one word. */
static uint16_t read_once(struct board *board, uint16_t port, unsigned width) {
    unsigned offset = (uint16_t)(port - board->desc.base);
    struct access access = {port, (uint16_t)(width == BOARD_BYTE ? 0x00FF : 0xFFFF), (uint8_t)width,
                            true};
    board->accesses++;
    if (offset < BOARD_PORTS) {
        board->reads[offset][width - 1]++;
        if (width == BOARD_BYTE) {
            return read_byte(board, offset, access);
        }
        if ((offset & 1) == 0) {
            return read_word(board, offset, access);
        }
    }
    uint16_t next = (uint16_t)(port + 1);
    if (width == BOARD_WORD && (port & 1) != 0 &&
        (board_decodes(board, port) || board_decodes(board, next))) {
        board_note_use(board, BOARD_WORD_SPLIT);
        unsigned low = read_half(board, port);
        return (uint16_t)(low | (unsigned)read_half(board, next) << 8);
    }
    report(board, BOARD_FOREIGN_READ, access);
    return access.value;
}

uint32_t board_read(struct board *board, uint16_t port, unsigned width) {
    if (is_of_the_bus(width)) {
        return read_once(board, port, width);
    }
    if (width != BOARD_TWO_WORDS) {
        return UINT32_MAX;
    }
    uint32_t low = read_once(board, port, BOARD_WORD);
    return low | (uint32_t)read_once(board, (uint16_t)(port + 2), BOARD_WORD) << 16;
}
