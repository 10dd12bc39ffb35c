/* SPDX-License-Identifier: MIT */
/* Experiments with control 1 and 2, their controller, and ports that should answer nothing. */
#include "experiments.h"
#include "outp.h"
#include "registers.h"

/* Indices whose data the initialisation has set, the status, and one that the initialisation leaves
 * alone. That one is a 6845's cursor address, which every chip of that family gives back. */
enum { INDEX_1B = 0x1B, INDEX_1E = 0x1E, INDEX_CURSOR_HIGH = 0x0E, DATA_1B = 0x01, DATA_1E = 0x8C };

uint32_t control_1_read(void) {
    return inpw(CONTROL_1);
}

uint32_t control_1_read_after_write(void) {
    outpw(CONTROL_1, inpw(CONTROL_1) | 0x0081);
    return inpw(CONTROL_1);
}

uint32_t control_1_read_bytes(void) {
    uint32_t low = inp(CONTROL_1);
    return low << 8 | inp(CONTROL_1 + 1);
}

uint32_t index_by_word(void) {
    outp(CONTROL_1, INDEX_1B);
    outpw(CONTROL_1, (uint16_t)(INDEX_1B << 8 | INDEX_1E));
    return inp(CONTROL_2);
}

/* Tells by a bit each which registers have kept the initialisation's data: all registers but
 * the status. */
uint32_t registers_kept(void) {
#define PAIR(index, data) {index, data},
    static const uint8_t set[][2] = {BOARD_INITIALISATION(PAIR)};
    uint32_t kept = 0;
    for (uint8_t i = 0; i < sizeof set / sizeof set[0]; i++) {
        if (set[i][0] != BOARD_STATUS_INDEX) {
            kept = kept << 1 | (controller_read(set[i][0]) == set[i][1] ? 1 : 0);
        }
    }
    return kept;
}

uint32_t data_by_word(void) {
    outp(CONTROL_1, INDEX_1E);
    return inpw(CONTROL_2);
}

/* Returns what the cursor's address keeps of FFh. A 6845 keeps six bits. */
uint32_t cursor_register(void) {
    controller_write(INDEX_CURSOR_HIGH, 0xFF);
    uint32_t kept = controller_read(INDEX_CURSOR_HIGH);
    controller_write(INDEX_CURSOR_HIGH, 0x00);
    return kept;
}

uint32_t index_width(void) {
    controller_write(INDEX_CURSOR_HIGH, 0x11);
    controller_write(0x20 | INDEX_CURSOR_HIGH, 0x22);
    uint32_t kept = controller_read(INDEX_CURSOR_HIGH);
    controller_write(0x20 | INDEX_CURSOR_HIGH, 0x00);
    controller_write(INDEX_CURSOR_HIGH, 0x00);
    return kept;
}

/* Returns the status bits that were ever 1, then those that always were. The reads take longer than
 * a frame of the screen: 26 ms at 0.4 us an access. */
uint32_t status_bits(void) {
    uint8_t any = 0x00;
    uint8_t all = 0xFF;
    outp(CONTROL_1, BOARD_STATUS_INDEX);
    for (uint32_t i = 0; i < 65536; i++) {
        uint8_t status = inp(CONTROL_2);
        any |= status;
        all &= status;
    }
    return (uint32_t)any << 8 | all;
}

/* Reads the status until its blanking bit is as wanted. Returns the number of reads, or 0 for
 * never. */
static uint32_t reads_until(uint8_t wanted) {
    enum { READS_MOST = 400000 };
    for (uint32_t reads = 1; reads <= READS_MOST; reads++) {
        if ((inp(CONTROL_2) & BOARD_STATUS_BLANK) == wanted) {
            return reads;
        }
    }
    return 0;
}

/* Counts the reads from the first one in a blanking to the first one in the next. Returns 0 if the
 * blanking never changes. */
uint32_t frame_accesses(void) {
    outp(CONTROL_1, BOARD_STATUS_INDEX);
    if (reads_until(0) == 0 || reads_until(BOARD_STATUS_BLANK) == 0) {
        return 0;
    }
    uint32_t blank = reads_until(0);
    uint32_t shown = reads_until(BOARD_STATUS_BLANK);
    return blank == 0 || shown == 0 ? 0 : blank + shown;
}

uint32_t control_1_odd_write(void) {
    outp(CONTROL_1, INDEX_1E);
    outp(CONTROL_1 + 1, INDEX_1B);
    return inp(CONTROL_2);
}

uint32_t control_2_odd_write(void) {
    controller_write(INDEX_CURSOR_HIGH, 0x15);
    outp(CONTROL_2 + 1, 0x2A);
    uint32_t kept = controller_read(INDEX_CURSOR_HIGH);
    controller_write(INDEX_CURSOR_HIGH, 0x00);
    return kept;
}

/* Reads four odd ports in a row. The first port's value is in the highest byte. */
static uint32_t odd_reads(uint16_t port) {
    uint32_t values = 0;
    for (uint8_t i = 0; i < 4; i++) {
        values = values << 8 | inp((uint16_t)(port + 2 * i));
    }
    return values;
}

uint32_t low_odd_reads(void) {
    return odd_reads(CONTROL_1 + 1);
}

uint32_t high_odd_reads(void) {
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    uint32_t values = odd_reads(RED + 1);
    dot_write(BENCH_X, BENCH_Y, 0);
    return values;
}

uint32_t write_only_bytes(void) {
    uint32_t x = inp(X_AXIS);
    uint32_t y = inp(Y_AXIS);
    return x << 16 | y << 8 | inp(MODE);
}

uint32_t write_only_words(void) {
    uint32_t x = inpw(X_AXIS);
    return x << 16 | inpw(MODE);
}

/* Reads red by ports that differ from red's own in one upper address bit. */
uint32_t aliases(void) {
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    uint32_t low = inp(RED | 0x0100);
    uint32_t middle = inp(RED | 0x1000);
    uint32_t values = low << 16 | middle << 8 | inp(RED | 0x8000);
    dot_write(BENCH_X, BENCH_Y, 0);
    return values;
}
