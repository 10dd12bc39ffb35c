/* SPDX-License-Identifier: MIT */
/* A test kit for programs that write to the SuperFrame board. The kit has a board behind the ports
 * that remembers every access, and assertions over those accesses for cmocka.
 *
 *     struct superframe_kit *kit = superframe_kit_new(BOARD_1987);
 *     draw_something();                                   // calls outp() and outpw().
 *     superframe_assert_writes(kit, "out16 00D4 0000\n"   // X.
 *                                   "...\n"               // any number of writes.
 *                                   "out8  00DC ??\n");   // blue, any value.
 *     superframe_assert_pixel(kit, 10, 20, 0xFF8000);     // x, y, 0xRRGGBB.
 *     superframe_assert_no_violation(kit);
 *     superframe_kit_free(kit);
 *
 * An assertion that does not hold prints what was expected and what was found. The running cmocka
 * test then fails at the assertion's line. Pictures that differ are written as TEST-expected.png
 * and TEST-found.png, where TEST is the function's name. Their folder is the one in the
 * environment's SUPERFRAME_TEST_FOLDER, or the current one: beside the log, if the log is written
 * there. A kit is best made in the test's setup and freed in the test's teardown. The failing
 * assertion leaves the test at once.
 *
 * Link with `pkg-config --libs superframe-testing`, which brings cmocka. */
#ifndef SUPERFRAME_TESTKIT_TESTING_H
#define SUPERFRAME_TESTKIT_TESTING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "bus.h"
#include "outp.h"
#include "trace.h"

/* The board under test, and what was done to it. Fields are for reading. */
struct superframe_kit {
    struct bus bus; /* the first member: the one that outp() reaches */
    struct board board;
    struct trace_access *accesses; /* every one since the kit was made, in order */
    size_t count;                  /* of accesses */
    size_t mark;                   /* assertions over writes begin at this one, from 0 */
    size_t capacity;
};

/* Powers a board on, its memory black, at 00D0h, and makes it the one that outp() reaches. Returns
 * NULL if out of memory. */
struct superframe_kit *superframe_kit_new(enum board_profile profile);

/* Makes a kit as superframe_kit_new() does, but with any board: another base, noise in its memory.
 * Returns NULL also if board_init() refuses the desc. */
struct superframe_kit *superframe_kit_new_desc(const struct board_desc *desc);

/* Unbinds the board if it is still the one that outp() reaches, and frees the kit. Harmless on
 * NULL. */
void superframe_kit_free(struct superframe_kit *kit);

/* Sets the mark: assertions over writes look only at what follows. */
void superframe_kit_mark(struct superframe_kit *kit);

/* ---- Assertions ----------------------------------------------------------------------------- */

/* Asserts that the writes since the mark are these, in this order. Reads are passed over. One write
 * a line, in the text form of traces: "out8 00D8 FF", "out16 00D4 0123", # begins a comment. A ?
 * stands for any hex digit, a line "..." for any number of writes, none too. */
#define superframe_assert_writes(kit, expected)                                                    \
    superframe_check_writes(kit, expected, SUPERFRAME_HERE)

/* Asserts that the writes since the mark are these, in any order, each as often as it is listed. ?
 * and "..." are invalid here. */
#define superframe_assert_writes_any_order(kit, expected)                                          \
    superframe_check_writes_any_order(kit, expected, SUPERFRAME_HERE)

/* Asserts that the frame memory's pixel at x 0..639, y 0..399 (to 415 with the hidden blocks) is
 * 0xRRGGBB. */
#define superframe_assert_pixel(kit, x, y, colour)                                                 \
    superframe_check_pixel(kit, x, y, colour, SUPERFRAME_HERE)

/* Asserts that all pixels of a struct superframe_rectangle of the frame memory are 0xRRGGBB. (A
 * rectangle written in the assertion takes parentheses: ((struct superframe_rectangle){x, y, width,
 * height}).) */
#define superframe_assert_region_colour(kit, rectangle, colour)                                    \
    superframe_check_region_colour(kit, rectangle, colour, SUPERFRAME_HERE)

/* Asserts that a rectangle of the frame memory holds these width * height * 3 bytes. They are R, G,
 * B from the top left, each within so many steps of 0..255. */
#define superframe_assert_region(kit, rectangle, rgb, within)                                      \
    superframe_check_region(kit, rectangle, rgb, within, SUPERFRAME_HERE)

/* Asserts that the CRT shows the picture of a PNG file, 640 x 400. Each primary may be off by so
 * many steps of 0..255. Nothing is shown before the controller is initialised and the mode set. */
#define superframe_assert_screen(kit, path, within)                                                \
    superframe_check_screen(kit, path, within, SUPERFRAME_HERE)

/* Asserts that since the kit was made nothing was done that the board's profile counts as a
 * violation. */
#define superframe_assert_no_violation(kit) superframe_check_violations(kit, SUPERFRAME_HERE)

/* Asserts no violation, and that nothing relied on a behaviour no better known than the grade.
 * GRADE_ASSUMED refuses the assumed behaviours, GRADE_INFERRED the inferred ones too. `superframe
 * replay --strict=GRADE` does likewise. */
#define superframe_assert_strict(kit, grade) superframe_check_strict(kit, grade, SUPERFRAME_HERE)

/* ---- Behind the assertions ------------------------------------------------------------------ */

/* Where an assertion stands. */
struct superframe_place {
    const char *test, *file;
    int line;
};

#define SUPERFRAME_HERE (&(const struct superframe_place){__func__, __FILE__, __LINE__})

/* A part of the frame memory, in pixels. */
struct superframe_rectangle {
    unsigned x, y, width, height;
};

void superframe_check_writes(const struct superframe_kit *kit, const char *expected,
                             const struct superframe_place *place);
void superframe_check_writes_any_order(const struct superframe_kit *kit, const char *expected,
                                       const struct superframe_place *place);
void superframe_check_pixel(const struct superframe_kit *kit, unsigned x, unsigned y,
                            uint32_t colour, const struct superframe_place *place);
void superframe_check_region_colour(const struct superframe_kit *kit,
                                    struct superframe_rectangle rectangle, uint32_t colour,
                                    const struct superframe_place *place);
void superframe_check_region(const struct superframe_kit *kit,
                             struct superframe_rectangle rectangle, const uint8_t *rgb,
                             unsigned within, const struct superframe_place *place);
void superframe_check_screen(const struct superframe_kit *kit, const char *path, unsigned within,
                             const struct superframe_place *place);
void superframe_check_violations(const struct superframe_kit *kit,
                                 const struct superframe_place *place);
void superframe_check_strict(const struct superframe_kit *kit, enum board_grade grade,
                             const struct superframe_place *place);

#endif
