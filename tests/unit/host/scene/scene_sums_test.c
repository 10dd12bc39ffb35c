/* SPDX-License-Identifier: MIT */
/* The scene reader: numbers that are worked out, and numbers with names. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "scene/description.h"

/* Reads `threshold = TEXT` behind some definitions, and says what it is; -1 where it is refused. */
static double value_of(const char *definitions, const char *text) {
    char scene[4096];
    struct scene_error error = {""};
    (void)snprintf(scene, sizeof scene,
                   "version = 1; %s camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
                   "materials = { m = { colour = [9, 9, 9]; }; };\nthreshold = %s;\n"
                   "objects = ( { material = \"m\"; solid = { ball = { centre = [0, 0.5, -1]; "
                   "radius = 1; }; }; } );",
                   definitions, text);
    struct scene_description *read =
        scene_description_read("sum.scene", scene, strlen(scene), &error);
    double value = read != NULL ? read->threshold : -1;
    scene_description_free(read);
    return value;
}

static void numbers_are_worked_out(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double value;
    } sums[] = {{"1/4", 0.25},
                {"2*3 - 5.5", 0.5},
                {"1 - 0.25 - 0.25", 0.5},
                {"1-0.25-0.25", 0.5},
                {"1 / 2 / 2", 0.25},
                {"(1 + 2) / 4", 0.75},
                {"2 * (0.5 - (1 - 0.75))", 0.5},
                {"- (1 - 1.5)", 0.5},
                {"--0.5 * 1", -1}, /* no number */
                {"- -0.5", 0.5},
                {"-r + 1", 0.75},
                {"r", 0.25},
                {"(r)", 0.25},
                {"(r) * 2", 0.5},
                {"r*r * 4", 0.25},
                {"half + r", 0.75},
                {"half - r", 0.25},
                {"0x10 * 0.03125", 0.5},
                {"1e-1 * 5", 0.5}};
    for (size_t i = 0; i < sizeof sums / sizeof sums[0]; i++) {
        double value = value_of("let r = 0.25; let half = r + r;", sums[i].text);
        if (!(value >= sums[i].value && value <= sums[i].value)) {
            fail_msg("%s is %.17g, not %g", sums[i].text, value, sums[i].value);
        }
    }
}

/* Writes a random sum with its value, of numbers that halves and quarters keep exact. */
static double random_sum(uint32_t *seed, int level, char **text) {
    static const char *const marks[] = {" + ", " - ", "*", " / "};
    *seed = *seed * 1664525u + 1013904223u;
    const unsigned choice = *seed >> 24;
    if (level == 0 || choice < 60) {
        const double number = (double)(1 + choice % 8);
        *text += sprintf(*text, choice % 3 == 0 ? "-%g" : "%g", number);
        return choice % 3 == 0 ? -number : number;
    }
    *text += sprintf(*text, "(");
    double value = random_sum(seed, level - 1, text);
    const unsigned mark = choice % 4;
    *text += sprintf(*text, "%s", marks[mark]);
    *text += sprintf(*text, "(");
    double other = mark == 3 ? 4 : 0;
    if (mark == 3) {
        *text += sprintf(*text, "4");
    } else {
        other = random_sum(seed, level - 1, text);
    }
    *text += sprintf(*text, "))");
    return mark == 0   ? value + other
           : mark == 1 ? value - other
           : mark == 2 ? value * other
                       : value / other;
}

static void sums_of_any_shape_are_worked_out(void **state) {
    (void)state;
    uint32_t seed = 3;
    for (int i = 0; i < 300; i++) {
        char text[2048], *end = text;
        double value = random_sum(&seed, 4, &end);
        char whole[2200];
        /* Into 0..1, exactly: a power of two times the sum, and a half. */
        (void)snprintf(whole, sizeof whole, "0.5 + (%s) / 4294967296.0", text);
        double found = value_of("", whole), expected = 0.5 + value / 4294967296.0;
        if (!(found >= expected && found <= expected)) {
            fail_msg("%s: %.17g, not %.17g", text, found, expected);
        }
    }
}

/* Appends a random sum of numbers, names and parentheses, with blanks round its marks or without.
 * A sign has a blank on both sides or on none: "2 -1" lacks a mark, and is refused in a list. */
static void append_spaced_sum(uint32_t *seed, int level, char *plain, char *spaced) {
    static const char *const factors[] = {"2", "0.5", "r", "-3", "1e-1", "half"};
    static const char marks[] = "+-*/";
    *seed = *seed * 1664525u + 1013904223u;
    const uint32_t choice = *seed >> 16;
    const unsigned terms = 1 + choice % 3;
    for (unsigned i = 0; i < terms; i++) {
        *seed = *seed * 1664525u + 1013904223u;
        const uint32_t next = *seed >> 16;
        const bool is_bracket = level > 0 && next % 3 == 0;
        if (i > 0) {
            /* A name may have '-' in it, so a name has a blank behind it. */
            const char mark = marks[next / 3 % 4], *last = plain + strlen(plain) - 1;
            const bool is_name = *last == 'r' || *last == 'f';
            const bool has_blanks = is_name || next / 12 % 2 == 0;
            (void)sprintf(plain + strlen(plain), " %c ", mark);
            (void)sprintf(spaced + strlen(spaced), has_blanks ? " %c " : "%c", mark);
        }
        if (is_bracket) {
            strcat(plain, "(");
            strcat(spaced, next / 24 % 2 == 0 ? "(" : "( ");
            append_spaced_sum(seed, level - 1, plain, spaced);
            strcat(plain, ")");
            strcat(spaced, next / 48 % 2 == 0 ? ")" : " )");
        } else {
            const char *factor = factors[next / 24 % 6];
            const bool is_double = i > 0 && *factor == '-'; /* "1--3" is no number */
            strcat(plain, is_double ? factor + 1 : factor);
            strcat(spaced, is_double ? factor + 1 : factor);
        }
    }
}

static void blanks_round_marks_change_nothing(void **state) {
    (void)state;
    uint32_t seed = 11;
    int finite = 0;
    for (int i = 0; i < 500; i++) {
        char sums[2][2048] = {"", ""}, texts[2][4096];
        double values[2];
        append_spaced_sum(&seed, 3, sums[0], sums[1]);
        for (int j = 0; j < 2; j++) {
            /* A value that begins with parentheses is read by another way than one within. */
            (void)snprintf(texts[j], sizeof texts[j],
                           i % 2 == 0 ? "0.5 + (%s) / 4294967296.0" : "(%s)/4294967296.0 + 0.5",
                           sums[j]);
            values[j] = value_of("let r = 0.25; let half = r + r;", texts[j]);
        }
        if (!(values[0] >= values[1] && values[0] <= values[1])) {
            fail_msg("%s: %.17g; %s: %.17g", texts[0], values[0], texts[1], values[1]);
        }
        finite += values[0] >= 0; /* others divide by 0 */
    }
    assert_true(finite > 450);
    assert_true(value_of("", "(1 + 2)-2.5") >= 0.5 && value_of("", "(1 + 2) -2.5") < 0);
}

static void whole_and_other_numbers_stand_in_one_array(void **state) {
    (void)state;
    struct scene_error error = {""};
    static const char text[] =
        "version = 1; camera = { eye = [0, -8, 0.5]; look_at = [0, 0.0, 1e-1]; };\n"
        "materials = { m = { colour = [9, 9.5, 0]; }; };\n"
        "objects = ( { material = \"m\"; solid = { ball = { centre = [0, 0x1, -0.5]; "
        "radius = 1; }; }; } );";
    struct scene_description *read = scene_description_read("a", text, strlen(text), &error);
    assert_non_null(read);
    assert_true(read->camera.eye[2] >= 0.5 && read->camera.eye[2] <= 0.5);
    assert_true(read->nodes[0].a[1] >= 1 && read->nodes[0].a[2] <= -0.5);
    scene_description_free(read);
}

/* A number may stand in parentheses where numbers may stand as well. */
static void a_number_in_parentheses_is_a_number(void **state) {
    (void)state;
    static const char *const forms[] = {"0.25", "(0.25)", "((0.25))", "(0.125 + 0.125)", "(1/2)/2"};
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
        char text[600];
        struct scene_error error = {""};
        (void)snprintf(text, sizeof text,
                       "version = 1; threshold = %s; camera = { eye = (0, -8, 0); look_at = (0, 0, "
                       "0); };\nmaterials = { m = { colour = [9, 9, 9]; specular = %s; ior = 1; "
                       "absorption = %s; }; };\nobjects = ( { material = \"m\"; solid = { ball = { "
                       "radius = %s; }; }; } );",
                       forms[i], forms[i], forms[i], forms[i]);
        struct scene_description *read = scene_description_read("a", text, strlen(text), &error);
        assert_string_equal(error.text, "");
        assert_non_null(read);
        const double found[] = {read->threshold, read->materials[0].specular,
                                read->materials[0].absorption[2], read->nodes[0].radius};
        for (size_t j = 0; j < sizeof found / sizeof *found; j++) {
            assert_true(found[j] >= 0.25 && found[j] <= 0.25);
        }
        assert_false(read->materials[0].has_specular_table);
        scene_description_free(read);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_in_parentheses_is_a_number),
        cmocka_unit_test(numbers_are_worked_out),
        cmocka_unit_test(sums_of_any_shape_are_worked_out),
        cmocka_unit_test(blanks_round_marks_change_nothing),
        cmocka_unit_test(whole_and_other_numbers_stand_in_one_array),
    };
    return cmocka_run_group_tests_name("scene_sums", tests, NULL, NULL);
}
