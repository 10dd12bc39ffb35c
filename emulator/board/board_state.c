/* SPDX-License-Identifier: MIT */
/* The board's state as bytes, checked when they come back. */
#include "board_state.h"

#include "board_internal.h"

#include <string.h>

enum { MAGIC_BYTES = 8, NUMBER_BYTES = 4 }; /* a number: version, length or checksum */

/* As in PNG: a byte that no text has, the name, and line ends that a text transfer would change. */
static const uint8_t state_magic[MAGIC_BYTES] = {0x89, 'S', 'F', 'B', 0x0D, 0x0A, 0x1A, 0x0A};

/* ---- Members -------------------------------------------------------------------------------- */

/* A member of the board, or of each element of an array in it. */
struct member {
    size_t place; /* of the first, in struct board */
    size_t size;  /* of each, in struct board */
    size_t stride;
    unsigned count;
    unsigned bytes; /* of each, in a state */
    uint64_t most;  /* the largest value */
};

#define ONE(name, bytes, most)                                                                     \
    { offsetof(struct board, name), sizeof(((struct board *)0)->name), 0, 1, bytes, most }
#define EACH(array, count, name, bytes, most)                                                      \
    {                                                                                              \
        offsetof(struct board, array name), sizeof(((struct board *)0)->array name),               \
            sizeof(((struct board *)0)->array), count, bytes, most                                 \
    }

/* Lists what is saved besides the memory, in order. A member that is not here follows from others,
 * or is no state: place, is_stepping, is_wrapped, changes. Another list, or other numbers in one of
 * the enumerations, takes another version. */
static const struct member members[] = {
    ONE(desc.profile, 1, BOARD_PROFILES - 1),
    ONE(desc.outside, 1, BOARD_OUTSIDE_WRAPS),
    ONE(desc.base, 2, UINT16_MAX),
    ONE(desc.noise, 1, 1),
    ONE(desc.noise_seed, 8, UINT64_MAX),
    ONE(blanking, 1, BOARD_BLANKINGS - 1),
    ONE(index, 1, UINT8_MAX),
    ONE(mode, 1, UINT8_MAX),
    ONE(x, 2, BOARD_X_MASK),
    ONE(y, 2, BOARD_Y_MASK),
    EACH(controller[0], 256, , 1, UINT8_MAX),
    EACH(controller_written[0], 256, , 1, 1),
    ONE(accesses, 8, UINT64_MAX),
    EACH(writes[0][0], BOARD_PORTS * 2, , 8, UINT64_MAX),
    EACH(reads[0][0], BOARD_PORTS * 2, , 8, UINT64_MAX),
    EACH(notes[0], BOARD_BEHAVIOURS, .count, 8, UINT64_MAX),
    EACH(notes[0], BOARD_BEHAVIOURS, .first, 8, UINT64_MAX),
    ONE(log_count, 1, BOARD_LOG_SIZE),
    EACH(log[0], BOARD_LOG_SIZE, .access, 8, UINT64_MAX),
    EACH(log[0], BOARD_LOG_SIZE, .behaviour, 1, BOARD_BEHAVIOURS - 1),
    EACH(log[0], BOARD_LOG_SIZE, .port, 2, UINT16_MAX),
    EACH(log[0], BOARD_LOG_SIZE, .value, 2, UINT16_MAX),
    EACH(log[0], BOARD_LOG_SIZE, .width, 1, 2),
    EACH(log[0], BOARD_LOG_SIZE, .is_read, 1, 1),
};
#undef ONE
#undef EACH

enum { MEMBERS = sizeof members / sizeof members[0] };

/* Returns a member's value, whatever unsigned type or enumeration it has. */
static uint64_t member_value(const uint8_t *member, size_t size) {
    uint8_t byte;
    uint16_t word;
    uint32_t twice;
    uint64_t value;
    if (size == sizeof byte) {
        memcpy(&byte, member, sizeof byte);
        return byte;
    }
    if (size == sizeof word) {
        memcpy(&word, member, sizeof word);
        return word;
    }
    if (size == sizeof twice) {
        memcpy(&twice, member, sizeof twice);
        return twice;
    }
    memcpy(&value, member, sizeof value);
    return value;
}

static void set_member(uint8_t *member, size_t size, uint64_t value) {
    uint8_t byte = (uint8_t)value;
    uint16_t word = (uint16_t)value;
    uint32_t twice = (uint32_t)value;
    const void *from = size == sizeof byte    ? (const void *)&byte
                       : size == sizeof word  ? (const void *)&word
                       : size == sizeof twice ? (const void *)&twice
                                              : (const void *)&value;
    memcpy(member, from, size);
}

/* ---- Bytes ---------------------------------------------------------------------------------- */

/* Writes a number, the lowest byte first. Returns where the next one goes. */
static uint8_t *put_number(uint8_t *bytes, uint64_t value, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        *bytes++ = (uint8_t)(value >> 8 * i);
    }
    return bytes;
}

static uint64_t number_at(const uint8_t *bytes, unsigned count) {
    uint64_t value = 0;
    for (unsigned i = 0; i < count; i++) {
        value |= (uint64_t)bytes[i] << 8 * i;
    }
    return value;
}

/* Returns the CRC-32 (IEEE 802.3, as in zlib and PNG). What a byte adds is what its two halves
 * add. */
static uint32_t checksum(const uint8_t *bytes, size_t count) {
    static const uint32_t low[16] = {0x00000000, 0x77073096, 0xEE0E612C, 0x990951BA,
                                     0x076DC419, 0x706AF48F, 0xE963A535, 0x9E6495A3,
                                     0x0EDB8832, 0x79DCB8A4, 0xE0D5E91E, 0x97D2D988,
                                     0x09B64C2B, 0x7EB17CBD, 0xE7B82D07, 0x90BF1D91};
    static const uint32_t high[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC,
                                      0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
                                      0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                      0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    uint32_t crc = 0xFFFFFFFF;
    for (size_t i = 0; i < count; i++) {
        uint32_t byte = (crc ^ bytes[i]) & 0xFF;
        crc = crc >> 8 ^ low[byte & 15] ^ high[byte >> 4];
    }
    return ~crc;
}

void board_save(const struct board *board, uint8_t bytes[BOARD_STATE_BYTES]) {
    uint8_t *next = bytes;
    memcpy(next, state_magic, MAGIC_BYTES);
    next = put_number(next + MAGIC_BYTES, BOARD_STATE_VERSION, NUMBER_BYTES);
    next = put_number(next, BOARD_STATE_BYTES, NUMBER_BYTES);
    for (unsigned i = 0; i < MEMBERS; i++) {
        const struct member *member = &members[i];
        const uint8_t *at = (const uint8_t *)board + member->place;
        for (unsigned k = 0; k < member->count; k++, at += member->stride) {
            next = put_number(next, member_value(at, member->size), member->bytes);
        }
    }
    memcpy(next, board->memory, sizeof board->memory);
    next += sizeof board->memory;
    put_number(next, checksum(bytes, (size_t)(next - bytes)), NUMBER_BYTES);
}

/* ---- Restoring ------------------------------------------------------------------------------ */

static enum board_state_status check_form(const uint8_t *bytes, size_t count) {
    if (count < MAGIC_BYTES + NUMBER_BYTES || memcmp(bytes, state_magic, MAGIC_BYTES) != 0) {
        return BOARD_STATE_FOREIGN;
    }
    const uint8_t *version = bytes + MAGIC_BYTES;
    if (number_at(version, NUMBER_BYTES) != BOARD_STATE_VERSION) {
        return BOARD_STATE_WRONG_VERSION;
    }
    if (count != BOARD_STATE_BYTES ||
        number_at(version + NUMBER_BYTES, NUMBER_BYTES) != BOARD_STATE_BYTES) {
        return BOARD_STATE_WRONG_LENGTH;
    }
    size_t checked = BOARD_STATE_BYTES - NUMBER_BYTES;
    bool is_whole = number_at(bytes + checked, NUMBER_BYTES) == checksum(bytes, checked);
    return is_whole ? BOARD_STATE_OK : BOARD_STATE_DAMAGED;
}

/* Sets the members from a state, up to the first value that is too large. Returns where the memory
 * begins in the state, NULL after such a value. */
static const uint8_t *take_members(struct board *board, const uint8_t *next) {
    for (unsigned i = 0; i < MEMBERS; i++) {
        const struct member *member = &members[i];
        uint8_t *at = (uint8_t *)board + member->place;
        for (unsigned k = 0; k < member->count; k++, at += member->stride) {
            uint64_t value = number_at(next, member->bytes);
            if (value > member->most) {
                return NULL;
            }
            set_member(at, member->size, value);
            next += member->bytes;
        }
    }
    return next;
}

/* Tells whether an entry of the log is one that an access can make; an unused one is all zeros. */
static bool is_possible_entry(const struct board *board, unsigned i) {
    const struct board_violation *entry = &board->log[i];
    if (i >= board->log_count) {
        return entry->access == 0 && entry->behaviour == 0 && entry->port == 0 &&
               entry->value == 0 && entry->width == 0 && !entry->is_read;
    }
    return entry->access >= 1 && entry->access <= board->accesses && entry->width >= 1 &&
           board_behaviour_is_violation(entry->behaviour, board->desc.profile);
}

/* Tells whether the members can stand beside each other. */
static bool is_possible(const struct board *board) {
    uint64_t violations = board_violations(board);
    bool is_log_full = violations >= BOARD_LOG_SIZE && board->log_count == BOARD_LOG_SIZE;
    bool is_good =
        board_base_is_offered(board->desc.base) && (is_log_full || board->log_count == violations);
    for (unsigned i = 0; i < 256; i++) {
        is_good = is_good && (board->controller_written[i] != 0 || board->controller[i] == 0);
    }
    for (unsigned i = 0; i < BOARD_BEHAVIOURS; i++) {
        const struct board_note *note = &board->notes[i];
        is_good =
            is_good && (note->count == 0) == (note->first == 0) && note->first <= board->accesses;
    }
    for (unsigned i = 0; i < BOARD_LOG_SIZE; i++) {
        is_good = is_good && is_possible_entry(board, i);
    }
    return is_good;
}

enum board_state_status board_restore(struct board *board, const uint8_t *bytes, size_t count) {
    enum board_state_status status = check_form(bytes, count);
    if (status != BOARD_STATE_OK) {
        return status;
    }
    uint8_t kept[offsetof(struct board, memory)];
    memcpy(kept, board, sizeof kept);
    const uint8_t *memory = take_members(board, bytes + MAGIC_BYTES + NUMBER_BYTES * 2);
    if (memory == NULL || !is_possible(board)) {
        memcpy(board, kept, sizeof kept);
        return BOARD_STATE_IMPOSSIBLE;
    }
    memcpy(board->memory, memory, sizeof board->memory);
    board->is_stepping = board_steps(board);
    board_forget_changes(board);
    board->changes.is_all = true;
    return BOARD_STATE_OK;
}

const char *board_state_text(enum board_state_status status) {
    switch (status) {
    case BOARD_STATE_OK:
        return "a state of the board";
    case BOARD_STATE_FOREIGN:
        return "no state of a SuperFrame board";
    case BOARD_STATE_WRONG_VERSION:
        return "a state of another version of the board";
    case BOARD_STATE_WRONG_LENGTH:
        return "a state of the wrong length, cut off or with more behind it";
    case BOARD_STATE_DAMAGED:
        return "a damaged state: the checksum is wrong";
    case BOARD_STATE_IMPOSSIBLE:
        return "a state that no board can be in";
    }
    return "unknown status";
}
