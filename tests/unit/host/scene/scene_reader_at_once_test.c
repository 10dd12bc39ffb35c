/* SPDX-License-Identifier: MIT */
/* The scene reader: all that is wrong with a file is told at once, each thing with its place. */
#include "scene_refusals.h"

/* Returns the first line of the section of the example that a line belongs to: what is wrong in one
 * section does not hide what is wrong in another. */
static unsigned section_of(unsigned line) {
    static const unsigned long_ones[] = {14, 20, 25, 33, 39, 55};
    unsigned section = line <= 13 || line == 32 || line == 53 ? line : 0;
    for (size_t i = 0; section == 0 && i < 6; i++) {
        if (i == 5 || long_ones[i + 1] > line) {
            section = long_ones[i];
        }
    }
    return section;
}

/* Two things that are wrong in two sections are both told. Only a comment without an end hides
 * others, and a key that is missing is not told where another key was refused. */
static void two_wrong_things_are_both_told(void **state) {
    (void)state;
    static const struct {
        const struct refusal *refusals;
        size_t count;
    } tables[] = {{text_refusals, sizeof text_refusals / sizeof *text_refusals},
                  {setting_refusals, sizeof setting_refusals / sizeof *setting_refusals},
                  {solid_refusals, sizeof solid_refusals / sizeof *solid_refusals}};
    const struct refusal *all[400];
    size_t count = 0, told = 0;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        for (size_t j = 0; j < tables[i].count; j++) {
            const struct refusal *refusal = &tables[i].refusals[j];
            if (refusal->line != 53 && strstr(refusal->fragment, "lacks") == NULL) {
                all[count++] = refusal;
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        char *once = put_in(SCENE_EXAMPLE, all[i]);
        for (size_t j = i % 5; j < i; j += 5) {
            char *twice =
                section_of(all[i]->line) != section_of(all[j]->line) ? put_in(once, all[j]) : NULL;
            struct scene_error error = {""};
            if (twice != NULL) {
                assert_null(scene_description_read("a.scene", twice, strlen(twice), &error));
                if (!is_refused(&error, all[i]->line, all[i]->fragment, all[i]->remedy) ||
                    !is_refused(&error, all[j]->line, all[j]->fragment, all[j]->remedy)) {
                    fail_msg("of \"%s\" on line %u and \"%s\" on line %u is told: %s",
                             all[i]->replacement, all[i]->line, all[j]->replacement, all[j]->line,
                             error.text);
                }
                told++;
            }
            free(twice);
        }
        free(once);
    }
    assert_true(told > 1500);
}

/* The mark stands under what is wrong, whatever stands before it on its line. */
static void a_mark_stands_under_what_is_wrong(void **state) {
    (void)state;
    static const struct {
        const char *before, *shown;
        unsigned column, mark; /* in the file, and in what is shown */
    } lines[] = {{"", "", 1, 0},
                 {"  ", "  ", 3, 2},
                 {"\t", " ", 2, 1},
                 {"/* \xC3\xA9\xE2\x82\xAC */ ", "/* \xC3\xA9\xE2\x82\xAC */ ", 13, 9}};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[200], expected[400];
        struct scene_error error = {""};
        (void)snprintf(text, sizeof text, "version = 1;\n%sversoin = 2; # x\n", lines[i].before);
        assert_null(scene_description_read("a.scene", text, strlen(text), &error));
        (void)snprintf(expected, sizeof expected, "a.scene:2:%u: unknown key", lines[i].column);
        assert_memory_equal(error.text, expected, strlen(expected));
        (void)snprintf(expected, sizeof expected, "\n    %sversoin = 2; # x\n    %*s^",
                       lines[i].shown, (int)lines[i].mark, "");
        assert_string_equal(strchr(error.text, '\n'), expected);
    }
}

/* Of a long line the part round the mark is shown. */
static void a_long_line_is_shown_in_part(void **state) {
    (void)state;
    for (size_t blanks = 0; blanks < 400; blanks += 7) {
        char *text = repeat("version = 1;", " ", blanks, "versoin = 2;                        ");
        struct scene_error error = {""};
        assert_null(scene_description_read("a.scene", text, strlen(text), &error));
        const char *shown = strchr(error.text, '\n') + 1, *mark = strchr(shown, '\n') + 1;
        assert_true(mark - shown <= 97 && strlen(mark) <= 97);
        assert_memory_equal(shown + strlen(mark) - 1, "versoin", 7);
        free(text);
    }
}

/* Twenty are told, those that stand first among what was found, and in the file's order. */
static void at_most_twenty_are_told_in_the_order_of_the_file(void **state) {
    (void)state;
    for (unsigned wrong = 1; wrong < 50; wrong++) {
        char text[4096] = "version = 1;\n";
        unsigned line = 0, told = 0;
        struct scene_error error = {""};
        for (unsigned i = 0; i < wrong; i++) { /* found while parsing, or after it, in turn */
            size_t used = strlen(text);
            (void)snprintf(text + used, sizeof text - used,
                           i % 2 == 0 ? "k%u = 010;\n" : "k%u = 1;\n", i);
        }
        assert_null(scene_description_read("a.scene", text, strlen(text), &error));
        const unsigned found = wrong + (wrong + 1) / 2; /* every key is unknown, too */
        assert_int_equal(count_refusals(&error), found < 20 ? found : 20);
        for (const char *at = error.text; at != NULL; at = strstr(at, "\na.scene:")) {
            unsigned next = 0;
            at += *at == '\n';
            assert_int_equal(sscanf(at, "a.scene:%u:", &next), 1);
            assert_true(next >= line);
            line = next;
            told++;
        }
        assert_int_equal(told, found < 20 ? found : 20);
    }
}

/* However many brackets are open where a file ends, the innermost one alone is told. */
static void of_open_brackets_the_innermost_is_told(void **state) {
    (void)state;
    for (size_t open = 1; open < 60; open++) {
        char *text = repeat("version = 1;\nobjects = ", "( ", open, "\n");
        struct scene_error error = {""};
        char expected[60];
        assert_null(scene_description_read("a.scene", text, strlen(text), &error));
        (void)snprintf(expected, sizeof expected, "a.scene:2:%zu: this '(' is never closed",
                       2 * open + 9);
        assert_non_null(strstr(error.text, expected));
        assert_null(strstr(strstr(error.text, "never closed") + 1, "never closed"));
        free(text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_wrong_things_are_both_told),
        cmocka_unit_test(a_mark_stands_under_what_is_wrong),
        cmocka_unit_test(a_long_line_is_shown_in_part),
        cmocka_unit_test(at_most_twenty_are_told_in_the_order_of_the_file),
        cmocka_unit_test(of_open_brackets_the_innermost_is_told),
    };
    return cmocka_run_group_tests_name("scene_reader_at_once", tests, NULL, NULL);
}
