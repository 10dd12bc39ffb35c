/* SPDX-License-Identifier: MIT */
/* What a run says of itself: the progress line, and strings and numbers in its statistics. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/json.h"
#include "render/progress.h"
#include "scene/load.h"

static void assert_line(unsigned columns, const char *unit, unsigned done, uint64_t rays,
                        double seconds, const char *expected) {
    struct progress progress;
    struct render_totals totals;
    char line[PROGRESS_LINE_SIZE];
    memset(&totals, 0, sizeof totals);
    memset(&progress, 0, sizeof progress);
    progress.rows = 400;
    progress.columns = columns;
    progress.unit = unit;
    progress.units = 90;
    progress.units_done = 7;
    totals.rows = done;
    totals.rays = rays;
    totals.seconds = seconds;
    progress_line(line, &progress, &totals);
    assert_string_equal(line, expected);
    assert_true(strlen(line) < columns);
}

static void progress_lines(void **state) {
    (void)state;
    assert_line(80, NULL, 100, 5000, 10,
                "[######..................] row 100 of 400, 500 rays/s, 0:30 left");
    assert_line(80, NULL, 400, 2500000, 100,
                "[########################] row 400 of 400, 25.0 k rays/s, 0:00 left");
    assert_line(80, NULL, 1, 4000000, 0.5,
                "[........................] row 1 of 400, 8.00 M rays/s, 3:20 left");
    assert_line(80, NULL, 0, 0, 0,
                "[........................] row 0 of 400, 0 rays/s, 5999:59 left");
    assert_line(80, "setting", 100, 5000, 10,
                "[######..................] setting 7 of 90, 500 rays/s, 0:30 left");
}

static void a_narrow_terminal_gets_a_shorter_line(void **state) {
    (void)state;
    assert_line(67, NULL, 100, 5000, 10,
                "[######..................] row 100 of 400, 500 rays/s, 0:30 left");
    assert_line(64, NULL, 100, 5000, 10, "row 100 of 400, 500 rays/s, 0:30 left");
    assert_line(40, NULL, 100, 5000, 10, "row 100 of 400, 500 rays/s, 0:30 left");
    assert_line(37, NULL, 100, 5000, 10, "row 100 of 400, 0:30 left");
    assert_line(20, NULL, 100, 5000, 10, "row 100 of 400");
    assert_line(8, NULL, 100, 5000, 10, "row 100");
}

static void no_bar_without_a_terminal(void **state) {
    (void)state;
    struct progress progress;
    memset(&progress, 0xA5, sizeof progress);
    progress_begin(&progress, 10, true);
    assert_false(progress.is_shown);
    assert_null(progress.unit);
    assert_true(progress.last_drawn <= 0 && progress.units_done == 0 && progress.rows == 10);
}

static void assert_quoted(const char *text, const char *expected) {
    char quoted[128] = "";
    FILE *file = tmpfile();
    assert_non_null(file);
    struct json json = {.out = file};
    json_text(&json, NULL, text);
    rewind(file);
    quoted[fread(quoted, 1, sizeof quoted - 1, file)] = '\0';
    (void)fclose(file);
    assert_string_equal(quoted, expected);
}

static void strings_in_json(void **state) {
    (void)state;
    assert_quoted("fig3", "\"fig3\"");
    assert_quoted("", "\"\"");
    assert_quoted("a\"b\\c\nd", "\"a\\u0022b\\u005cc\\u000ad\"");
    assert_quoted("\xC3\xA9", "\"\xC3\xA9\"");
    assert_quoted("\xE3\x81\x82\xF0\x9F\x98\x80\x7F", "\"\xE3\x81\x82\xF0\x9F\x98\x80\x7F\"");
    /* Bytes of another character set, a character that is cut off, a surrogate, and what is longer
     * than it need be or beyond the last character. */
    assert_quoted("caf\xE9.scene", "\"caf\\ufffd.scene\"");
    assert_quoted("\xE3\x81", "\"\\ufffd\\ufffd\"");
    assert_quoted("\xED\xA0\x80", "\"\\ufffd\\ufffd\\ufffd\"");
    assert_quoted("\xC0\xAF", "\"\\ufffd\\ufffd\"");
    assert_quoted("\xF4\x90\x80\x80", "\"\\ufffd\\ufffd\\ufffd\\ufffd\"");
}

static void names_after_scenes(void **state) {
    (void)state;
    char name[16];
    scene_short_name("fig3", name, sizeof name);
    assert_string_equal(name, "fig3");
    scene_short_name("a.b/glass.two.scene", name, sizeof name);
    assert_string_equal(name, "glass.two");
    scene_short_name("/x/.scene", name, sizeof name);
    assert_string_equal(name, ".scene");
    scene_short_name("a-name-that-is-too-long", name, sizeof name);
    assert_string_equal(name, "a-name-that-is-");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(progress_lines),
        cmocka_unit_test(a_narrow_terminal_gets_a_shorter_line),
        cmocka_unit_test(no_bar_without_a_terminal),
        cmocka_unit_test(strings_in_json),
        cmocka_unit_test(names_after_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
