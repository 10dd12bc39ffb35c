/* SPDX-License-Identifier: MIT */
/* The test kit: pictures, and what its assertions let pass, what they stop, and what they say then.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "picture.h"
#include "pixels.h"
#include "png_file.h"
#include "testing.h"

static struct superframe_kit *kit;
static char folder[] = "/tmp/superframe-testkit-XXXXXX";

static int enter(void **state) {
    kit = superframe_kit_new(BOARD_1987);
    *state = kit;
    return kit != NULL ? 0 : -1;
}

static int leave(void **state) {
    (void)state;
    superframe_kit_free(kit);
    return 0;
}

static int make_folder(void **state) {
    (void)state;
    return mkdtemp(folder) != NULL && setenv("SUPERFRAME_TEST_FOLDER", folder, 1) == 0 ? 0 : -1;
}

static int remove_folder(void **state) {
    char line[64];
    (void)state;
    (void)snprintf(line, sizeof line, "rm -rf %s", folder);
    return system(line);
}

/* ---- Pixels --------------------------------------------------------------------------------- */

static void pixels_are_compared_and_written(void **state) {
    uint8_t expected[4 * 2 * 3] = {0}, found[4 * 2 * 3] = {0};
    char report[PIXELS_REPORT_SIZE], path[128];
    struct pixels pixels = {{10, 20, 4, 2}, expected, found, 0};
    (void)state;
    assert_true(pixels_equal(&pixels, "same", report));
    found[5 * 3 + 1] = 9;
    expected[7 * 3] = 12;
    assert_false(pixels_equal(&pixels, "differ", report));
    assert_non_null(strstr(report, "2 of 4 x 2 pixels differ, by 12 at most (allowed: 0)\n"
                                   "the first is at (11, 21): expected 000000, found 000900\n"));
    pixels.within = 9;
    assert_false(pixels_equal(&pixels, "differ", report));
    assert_non_null(strstr(report, "1 of 4 x 2 pixels differ"));
    pixels.within = 12;
    assert_true(pixels_equal(&pixels, "same", report));
    for (int i = 0; i < 2; i++) {
        struct png_image image;
        struct png_error error;
        (void)snprintf(path, sizeof path, "%s/differ-%s.png", folder, i ? "found" : "expected");
        assert_non_null(strstr(report, path)); /* of the failure before */
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        assert_int_equal(read_png(file, &image, &error), PNG_OK);
        assert_memory_equal(image.rgb, i ? found : expected, sizeof found);
        free_png(&image);
        fclose(file);
    }
    (void)snprintf(path, sizeof path, "%s/same-found.png", folder);
    assert_int_equal(access(path, F_OK), -1);
}

static void a_picture_that_can_not_be_written_is_said(void **state) {
    uint8_t expected[3] = {0}, found[3] = {1};
    char report[PIXELS_REPORT_SIZE];
    const struct pixels pixels = {{0, 0, 1, 1}, expected, found, 0};
    (void)state;
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", "/nowhere", 1), 0);
    assert_false(pixels_equal(&pixels, "x", report));
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", folder, 1), 0);
    assert_non_null(strstr(report, "/nowhere/x-expected.png (can't be written: No such file"));
}

static void only_a_named_folder_takes_the_pictures(void **state) {
    char report[PIXELS_REPORT_SIZE], here[256], name[PIXELS_PATH_SIZE];
    uint8_t expected[3] = {0}, found[3] = {1};
    const struct pixels pixels = {{0, 0, 1, 1}, expected, found, 0};
    (void)state;
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(chdir(folder), 0);
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", "", 1), 0);
    assert_false(pixels_equal(&pixels, "unnamed", report));
    assert_int_equal(chdir(here), 0);
    assert_non_null(strstr(report, "expected: ./unnamed-expected.png\n"));
    /* A folder of 360 letters is one; a name that no file can have is said to be none. */
    memset(name, 'a', sizeof name);
    int length = snprintf(name, sizeof name, "%s/", folder);
    for (unsigned i = 0; i < 6; i++) {
        length += snprintf(name + length, sizeof name - (size_t)length, "%s%059u", i ? "/" : "", i);
        assert_int_equal(mkdir(name, 0700), 0);
    }
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", name, 1), 0);
    assert_false(pixels_equal(&pixels, "deep", report));
    (void)snprintf(name + length, sizeof name - (size_t)length, "/deep-found.png");
    assert_non_null(strstr(report, name));
    assert_int_equal(access(name, F_OK), 0);
    memset(name, 'a', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", name, 1), 0);
    assert_false(pixels_equal(&pixels, "x", report));
    assert_int_equal(setenv("SUPERFRAME_TEST_FOLDER", folder, 1), 0);
    assert_non_null(
        strstr(report, "found:    (can't be written: the folder's name is too long)\n"));
}

static void rectangles_lie_in_the_frame_memory(void **state) {
    static const struct {
        struct superframe_rectangle rectangle;
        bool fits;
    } cases[] = {
        {{0, 0, 640, 416}, true}, {{639, 415, 1, 1}, true},        {{640, 0, 1, 1}, false},
        {{0, 416, 1, 1}, false},  {{1, 0, 640, 1}, false},         {{0, 1, 1, 416}, false},
        {{0, 0, 0, 1}, false},    {{0, 0, 1, 0}, false},           {{0, 0, 641, 1}, false},
        {{0, 0, 1, 417}, false},  {{4294967295u, 0, 2, 1}, false}, {{0, 4294967295u, 1, 2}, false}};
    char report[PIXELS_REPORT_SIZE];
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(pixels_rectangle_fits(&cases[i].rectangle, report), cases[i].fits);
    }
}

/* ---- The assertions ------------------------------------------------------------------------- */

static void set_up_and_draw(void) {
    static const uint8_t pairs[15][2] = {{0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E},
                                         {0x04, 0x1A}, {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19},
                                         {0x08, 0x80}, {0x09, 0x0F}, {0x0C, 0xFF}, {0x0D, 0xFF},
                                         {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};
    for (unsigned i = 0; i < 15; i++) {
        outp(0x00D0, pairs[i][0]);
        outp(0x00D2, pairs[i][1]);
    }
    outp(0x00DE, 0x01);
    outpw(0x00D4, 10);
    outp(0x00DA, 0x22);
}

/* Writes the screen as it is now to a file of the folder. */
static const char *write_screen(const char *name) {
    static char path[128];
    static uint8_t rgb[PICTURE_BYTES];
    struct png_error error;
    (void)snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    (void)picture_draw(&kit->board, NULL, rgb);
    assert_int_equal(write_png(file, rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error), PNG_OK);
    fclose(file);
    return path;
}

static void what_holds_passes(void **state) {
    const struct superframe_rectangle line = {10, 0, 2, 1}, black = {0, 1, 640, 415};
    static const uint8_t two[6] = {0, 0x22, 0, 0, 0, 0}, nearly[6] = {1, 0x21, 0, 1, 0, 0};
    (void)state;
    set_up_and_draw();
    superframe_assert_writes(kit, "...\nout16 00D4 000A\nout8 00DA 22");
    superframe_assert_pixel(kit, 10, 0, 0x002200);
    superframe_assert_region(kit, line, two, 0);
    superframe_assert_region(kit, line, nearly, 1);
    superframe_assert_region_colour(kit, black, 0x000000);
    superframe_assert_region_colour(kit, ((struct superframe_rectangle){10, 0, 1, 1}), 0x002200);
    superframe_assert_screen(kit, write_screen("good.png"), 0);
    superframe_assert_no_violation(kit);
    superframe_assert_strict(kit, GRADE_INFERRED);
    superframe_kit_mark(kit);
    outp(0x00D8, 1);
    superframe_assert_writes_any_order(kit, "out8 00D8 01");
}

/* Assertions that must fail, each in a process of its own; and what is said. */
static void wrong_writes(void **state) {
    (void)state;
    superframe_assert_writes(kit, "out8 00D8 00");
}

static void wrong_any_order(void **state) {
    (void)state;
    superframe_assert_writes_any_order(kit, "out8 00D8 00");
}

static void wrong_pixel(void **state) {
    (void)state;
    superframe_assert_pixel(kit, 10, 0, 0x112200);
}

static void pixel_elsewhere(void **state) {
    (void)state;
    superframe_assert_pixel(kit, 640, 0, 0);
}

static void wrong_region(void **state) {
    const struct superframe_rectangle pixel = {10, 0, 1, 1};
    static const uint8_t far_off[3] = {0, 0x25, 0};
    (void)state;
    superframe_assert_region(kit, pixel, far_off, 2);
}

static void region_elsewhere(void **state) {
    const struct superframe_rectangle outside = {600, 0, 41, 1};
    (void)state;
    superframe_assert_region(kit, outside, NULL, 0);
}

static void wrong_screen(void **state) {
    (void)state;
    outp(0x00DA, 0x23);
    superframe_assert_screen(kit, getenv("GOOD"), 0);
}

static void screen_not_set_up(void **state) {
    (void)state;
    board_reset(&kit->board);
    superframe_assert_screen(kit, getenv("GOOD"), 0);
}

static void screen_without_file(void **state) {
    (void)state;
    superframe_assert_screen(kit, "/nowhere/a.png", 0);
}

static void screen_of_no_png(void **state) {
    (void)state;
    superframe_assert_screen(kit, "/dev/null", 0);
}

static void screen_of_wrong_size(void **state) {
    (void)state;
    superframe_assert_screen(kit, getenv("SMALL"), 0);
}

static void violation(void **state) {
    (void)state;
    outp(0x00D9, 1);
    superframe_assert_no_violation(kit);
}

static void too_strict(void **state) {
    (void)state;
    superframe_assert_strict(kit, GRADE_DRIVER);
}

static void violation_beside_the_ports(void **state) {
    (void)state;
    board_write(&kit->board, 0x00D9, 1, BUS_BYTE);
    superframe_assert_no_violation(kit);
}

/* A kit that could not remember an access: all that these ask for holds of the board as it is. */
static void cut_off_writes(void **state) {
    (void)state;
    bus_fail(&kit->bus, BUS_IO_ERROR);
    superframe_assert_writes(kit, "...");
}

static void cut_off_pixel(void **state) {
    (void)state;
    bus_fail(&kit->bus, BUS_IO_ERROR);
    superframe_assert_pixel(kit, 10, 0, 0x002200);
}

static void cut_off_screen(void **state) {
    (void)state;
    bus_fail(&kit->bus, BUS_LOST);
    superframe_assert_screen(kit, getenv("GOOD"), 0);
}

static void cut_off_violations(void **state) {
    (void)state;
    bus_fail(&kit->bus, BUS_IO_ERROR);
    superframe_assert_no_violation(kit);
}

static const struct {
    void (*test)(void **state);
    const char *report;
} failures[] = {
    {wrong_writes, "wrong_writes: the writes differ from what is expected, first at write 1"},
    {wrong_any_order, "wrong_any_order: found, not expected: "},
    {wrong_pixel, "the first is at (10, 0): expected 112200, found 002200"},
    {pixel_elsewhere, "1 x 1 pixels at (640, 0) don't lie in the frame memory"},
    {wrong_region, "1 of 1 x 1 pixels differ, by 3 at most (allowed: 2)"},
    {region_elsewhere, "41 x 1 pixels at (600, 0) don't lie"},
    {wrong_screen, "1 of 640 x 400 pixels differ, by 1 at most"},
    {screen_not_set_up, "note: the controller has not been initialised"},
    {screen_without_file, "/nowhere/a.png: cannot be read: No such file"},
    {screen_of_no_png, "/dev/null: "},
    {screen_of_wrong_size, "1 x 1 pixels; the screen has 640 x 400"},
    {violation, "violation: violation: a byte written at an odd port (grade A): 1 times, first at "
                "access 34: out8 00D9 01"},
    {too_strict,
     "too_strict: relied on: control 1 written: the index (grade D): 15 times, first at "
     "access 1: out8 00D0 00"},
    {violation_beside_the_ports,
     "at an odd port (grade A): 1 times, first at access 34: not through"},
    {cut_off_writes, "nothing has reached the board since access 33: out of memory"},
    {cut_off_pixel, "nothing has reached the board since access 33: out of memory"},
    {cut_off_screen, "nothing has reached the board since access 33: the device went away"},
    {cut_off_violations, "nothing has reached the board since access 33: out of memory"},
};

/* Runs one failing test as a cmocka group in a child; its exit status is the number of failures. */
static int run_in_a_child(void (*test)(void **state), const char *log) {
    fflush(NULL);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const struct CMUnitTest tests[] = {{"failing", test, NULL, NULL, NULL}};
        if (freopen(log, "w", stdout) == NULL || dup2(fileno(stdout), STDERR_FILENO) < 0) {
            _exit(99);
        }
        int failed = cmocka_run_group_tests(tests, NULL, NULL);
        fflush(NULL);
        _exit(failed);
    }
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void what_does_not_hold_fails_and_says_why(void **state) {
    char log[64], text[4096];
    static const uint8_t pixel[3] = {0, 0, 0};
    struct png_error error;
    (void)state;
    set_up_and_draw();
    (void)setenv("GOOD", write_screen("good.png"), 1);
    (void)snprintf(log, sizeof log, "%s/small.png", folder);
    FILE *file = fopen(log, "wb");
    assert_non_null(file);
    assert_int_equal(write_png(file, pixel, 1, 1, &error), PNG_OK);
    fclose(file);
    (void)setenv("SMALL", log, 1);
    (void)snprintf(log, sizeof log, "%s/log", folder);
    for (size_t i = 0; i < sizeof failures / sizeof failures[0]; i++) {
        assert_int_equal(run_in_a_child(failures[i].test, log), 1);
        file = fopen(log, "rb");
        assert_non_null(file);
        text[fread(text, 1, sizeof text - 1, file)] = '\0';
        fclose(file);
        if (strstr(text, failures[i].report) == NULL || strstr(text, "testkit_test.c:") == NULL) {
            fail_msg("\"%s\" is not in: %s", failures[i].report, text);
        }
    }
}

/* ---- The kit itself ------------------------------------------------------------------------- */

static void a_kit_is_the_bound_bus_until_it_is_freed(void **state) {
    struct board_desc desc = board_default_desc(BOARD_LATER);
    (void)state;
    desc.base = 0x02D0;
    struct superframe_kit *other = superframe_kit_new_desc(&desc);
    assert_non_null(other);
    outpw(0x02D4, 3);
    assert_int_equal(other->board.x, 3);
    superframe_kit_free(kit); /* not the bound one: the other one stays bound */
    kit = NULL;
    outpw(0x02D4, 4);
    assert_int_equal(other->board.x, 4);
    superframe_kit_free(other);
    assert_int_equal(bus_bound_status(), BUS_UNBOUND);
    superframe_kit_free(NULL);
    desc.base = 0x01D0;
    assert_null(superframe_kit_new_desc(&desc));
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(pixels_are_compared_and_written),
        TEST(a_picture_that_can_not_be_written_is_said),
        TEST(only_a_named_folder_takes_the_pictures),
        TEST(rectangles_lie_in_the_frame_memory),
        TEST(what_holds_passes),
        TEST(what_does_not_hold_fails_and_says_why),
        TEST(a_kit_is_the_bound_bus_until_it_is_freed),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
