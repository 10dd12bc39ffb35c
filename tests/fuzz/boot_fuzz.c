/* SPDX-License-Identifier: MIT */
/* Fuzzes floppies: the input is what the disk begins with, its boot sector first. Whatever the
 * program does, the run ends, says why, and keeps to its number of instructions. */
#include <sanitizer/lsan_interface.h>
#include <string.h>

#include "board.h"
#include "boot/cpu.h"
#include "fuzz.h"

enum {
    INSTRUCTIONS_MOST = 2000,
    BLOCK_MOST = 512, /* instructions that a block of code may have: QEMU's limit */
    BYTES_MOST = 8192,
    HALT = 0xF4 /* the instruction that ends a run which leaves the input */
};

static struct pc98_disk disk;
static struct board board;

/* Unicorn 2.0.1 loses 512 bytes where a program writes to its own code; that is not looked at. */
const char *__lsan_default_suppressions(void) {
    return "leak:libunicorn";
}

/* Checks that the text screen holds strings of printable letters. */
static void check_text(const struct pc98_text *text) {
    for (int row = 0; row < PC98_TEXT_ROWS; row++) {
        const char *letter = text->row[row];
        while (*letter >= 0x20 && *letter < 0x7F) {
            letter++;
        }
        assert(*letter == '\0' && letter - text->row[row] <= PC98_TEXT_COLUMNS);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    const struct board_desc desc = board_default_desc(BOARD_LATER);
    const size_t used = count < BYTES_MOST ? count : BYTES_MOST;
    struct board_bus board_bus;
    struct processor_report report;
    memset(&disk, 0, sizeof disk); /* the program before may have written to it */
    if (used > 0) {
        memcpy(disk.bytes, bytes, used);
    }
    memset(disk.bytes + used, HALT, BYTES_MOST - used);
    assert(board_init(&board, &desc));
    board_bus_init(&board_bus, &board);
    const struct processor_job job = {.disk = &disk,
                                      .bus = &board_bus.bus,
                                      .instructions_most = INSTRUCTIONS_MOST,
                                      .escape_after = 1 + count % 4};
    processor_run(&job, &report);
    assert(report.end == PROCESSOR_HALTED || report.end == PROCESSOR_LOST ||
           report.end == PROCESSOR_RESET || report.end == PROCESSOR_LIMIT);
    assert(report.reason[0] != '\0');
    assert(memchr(report.reason, '\0', sizeof report.reason) != NULL);
    assert(report.instructions <= INSTRUCTIONS_MOST + BLOCK_MOST);
    assert((report.end == PROCESSOR_LIMIT) == (report.instructions > INSTRUCTIONS_MOST));
    check_text(&report.text);
    return 0;
}
