/* SPDX-License-Identifier: MIT */
/* The assertions: checks that print a report and fail the running cmocka test. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "match.h"
#include "picture.h"
#include "pixels.h"
#include "png_file.h"

static void fail_at(const struct superframe_place *place, const char *report) {
    print_error("%s: %s", place->test, report);
    _fail(place->file, place->line);
}

/* ---- Writes --------------------------------------------------------------------------------- */

void superframe_check_writes(const struct superframe_kit *kit, const char *expected,
                             const struct superframe_place *place) {
    char report[MATCH_REPORT_SIZE];
    if (!match_writes(kit, expected, report)) {
        fail_at(place, report);
    }
}

void superframe_check_writes_any_order(const struct superframe_kit *kit, const char *expected,
                                       const struct superframe_place *place) {
    char report[MATCH_REPORT_SIZE];
    if (!match_writes_any_order(kit, expected, report)) {
        fail_at(place, report);
    }
}

/* ---- Pixels --------------------------------------------------------------------------------- */

/* Compares a rectangle of the frame memory with expected, and frees expected. NULL means out of
 * memory and fails. A kit that is not whole fails too. */
static void check_memory(const struct superframe_kit *kit,
                         const struct superframe_rectangle *rectangle, uint8_t *expected,
                         unsigned within, const struct superframe_place *place) {
    char report[PIXELS_REPORT_SIZE] = "out of memory\n";
    uint8_t *found = pixels_of_memory(&kit->board, rectangle);
    const struct pixels pixels = {*rectangle, expected, found, within};
    bool holds = kit_is_whole(kit, report) && expected != NULL && found != NULL &&
                 pixels_equal(&pixels, place->test, report);
    /* A failing assertion jumps: what is on the heap goes first. */
    free(expected);
    free(found);
    if (!holds) {
        fail_at(place, report);
    }
}

void superframe_check_pixel(const struct superframe_kit *kit, unsigned x, unsigned y,
                            uint32_t colour, const struct superframe_place *place) {
    const struct superframe_rectangle pixel = {x, y, 1, 1};
    superframe_check_region_colour(kit, pixel, colour, place);
}

void superframe_check_region_colour(const struct superframe_kit *kit,
                                    struct superframe_rectangle rectangle, uint32_t colour,
                                    const struct superframe_place *place) {
    char report[PIXELS_REPORT_SIZE];
    if (!pixels_rectangle_fits(&rectangle, report)) {
        fail_at(place, report);
        return;
    }
    size_t bytes = (size_t)rectangle.width * rectangle.height * 3;
    uint8_t *expected = malloc(bytes);
    for (size_t i = 0; expected != NULL && i < bytes; i++) {
        expected[i] = (uint8_t)(colour >> (16 - 8 * (i % 3)));
    }
    check_memory(kit, &rectangle, expected, 0, place);
}

void superframe_check_region(const struct superframe_kit *kit,
                             struct superframe_rectangle rectangle, const uint8_t *rgb,
                             unsigned within, const struct superframe_place *place) {
    char report[PIXELS_REPORT_SIZE];
    if (!pixels_rectangle_fits(&rectangle, report)) {
        fail_at(place, report);
        return;
    }
    size_t bytes = (size_t)rectangle.width * rectangle.height * 3;
    uint8_t *expected = malloc(bytes);
    if (expected != NULL) {
        memcpy(expected, rgb, bytes);
    }
    check_memory(kit, &rectangle, expected, within, place);
}

/* Reads the expected picture. Returns false, with the report filled, if the picture can't be
 * compared. */
static bool read_expected(const char *path, struct png_image *image, char *report) {
    struct png_error error;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        (void)snprintf(report, PIXELS_REPORT_SIZE, "%s: cannot be read: %s\n", path,
                       strerror(errno));
        return false;
    }
    enum png_status status = read_png(file, image, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        (void)snprintf(report, PIXELS_REPORT_SIZE, "%s: %s\n", path, error.message);
        return false;
    }
    if (image->width != PICTURE_WIDTH || image->height != PICTURE_HEIGHT) {
        (void)snprintf(report, PIXELS_REPORT_SIZE, "%s: %u x %u pixels; the screen has %d x %d\n",
                       path, image->width, image->height, PICTURE_WIDTH, PICTURE_HEIGHT);
        free_png(image);
        return false;
    }
    return true;
}

void superframe_check_screen(const struct superframe_kit *kit, const char *path, unsigned within,
                             const struct superframe_place *place) {
    char report[PIXELS_REPORT_SIZE] = "out of memory\n";
    struct png_image image = {0, 0, NULL};
    uint8_t *found = malloc(PICTURE_BYTES);
    bool holds = false;
    if (kit_is_whole(kit, report) && found != NULL && read_expected(path, &image, report)) {
        const struct pixels pixels = {
            {0, 0, PICTURE_WIDTH, PICTURE_HEIGHT}, image.rgb, found, within};
        enum picture_state state = picture_draw(&kit->board, NULL, found);
        holds = pixels_equal(&pixels, place->test, report);
        if (!holds && state != PICTURE_OK) {
            size_t used = strlen(report);
            (void)snprintf(report + used, PIXELS_REPORT_SIZE - used, "note: %s\n",
                           picture_state_text(state));
        }
    }
    free_png(&image);
    free(found);
    if (!holds) {
        fail_at(place, report);
    }
}

/* ---- Violations ----------------------------------------------------------------------------- */

static void report_behaviour(const struct superframe_kit *kit, enum board_behaviour behaviour,
                             bool is_violation, enum board_grade grade,
                             const struct superframe_place *place) {
    const struct board_note *note = &kit->board.notes[behaviour];
    char text[2 * TRACE_TEXT_SIZE] = "not through the ports";
    if (note->first <= kit->count) {
        (void)trace_text_format(text, &kit->accesses[note->first - 1]);
    }
    print_error("%s: %s: %s (grade %s): %" PRIu64 " times, first at access %" PRIu64 ": %s\n",
                place->test, is_violation ? "violation" : "relied on",
                board_behaviour_text(behaviour), board_grade_letter(grade), note->count,
                note->first, text);
}

static void check_behaviours(const struct superframe_kit *kit, bool has_grade,
                             enum board_grade grade, const struct superframe_place *place) {
    const struct board *board = &kit->board;
    enum board_profile profile = board->desc.profile;
    char report[KIT_REPORT_SIZE];
    bool holds = true;
    if (!kit_is_whole(kit, report)) {
        fail_at(place, report);
        return;
    }
    for (int i = 0; i < BOARD_BEHAVIOURS; i++) {
        enum board_behaviour behaviour = (enum board_behaviour)i;
        bool is_violation = board_behaviour_is_violation(behaviour, profile);
        enum board_grade own = board_behaviour_grade(behaviour, profile);
        if (board->notes[i].count > 0 && (is_violation || (has_grade && own >= grade))) {
            report_behaviour(kit, behaviour, is_violation, own, place);
            holds = false;
        }
    }
    if (!holds) {
        _fail(place->file, place->line);
    }
}

void superframe_check_violations(const struct superframe_kit *kit,
                                 const struct superframe_place *place) {
    check_behaviours(kit, false, GRADE_ASSUMED, place);
}

void superframe_check_strict(const struct superframe_kit *kit, enum board_grade grade,
                             const struct superframe_place *place) {
    check_behaviours(kit, true, grade, place);
}
