/* SPDX-License-Identifier: MIT */
/* The scene reader: what bad files are refused for, with the line and the remedy. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <math.h>

#include "scene/description.h"
#include "scene_reader_example.h"

/* The example with the first `find` replaced is refused on a line with a message that holds both
 * fragments. */
struct refusal {
    const char *find;
    const char *replacement;
    unsigned line;
    const char *fragment;
    const char *remedy;
};

static const struct refusal text_refusals[] = {
    /* Numbers. */
    {"depth = 3", "depth = 99999999999", 4, "'depth' of the scene is 99999999999", "0 to 255"},
    {"depth = 3", "depth = -2147483649", 4, "-2147483649", "0 to 255"},
    {"depth = 3", "depth = 0xFFFFFFFF", 4, "4294967295", "0 to 255"},
    {"depth = 3", "depth = 99999999999999999999L", 4, "does not fit 64 bits", "decimal point"},
    {"depth = 3", "depth = 99999999999L", 4, "99999999999", "0 to 255"},
    {"= 0.25", "= 1e400", 5, "'1e400' is too large", "1.7e308"},
    {"= 0.25", "= -1.0E+999", 5, "too large", "1.7e308"},
    {"= 0.25", "= nan", 5, "'nan'", "finite"},
    {"= 0.25", "= -Inf", 5, "'-Inf'", "finite"},
    {"= 0.25", "= infinity", 5, "'infinity'", "finite"},
    {"= 0.25", "= 0,25", 5, "'0,25' is no number", "a dot, as in 0.25"},
    {"= 0.25", "= 0.2.5", 5, "'0.2.5' is no number", "numbers look like"},
    {"= 0.25", "= .", 5, "'.' is no number", "numbers look like"},
    {"= 0.25", "= 1e", 5, "'1e' is no number", "numbers look like"},
    {"= 0.25", "= --1", 5, "'--1' is no number", "numbers look like"},
    {"= 0.25", "= 0x", 5, "'0x' is no number", "numbers look like"},
    {"= 0.25", "= 5l", 5, "'5l' is no number", "5*l"},
    {"[1, 2, 3]", "[1, 2,5, 3]", 10, "has to be 3 numbers, and is 4", "a dot, not a comma"},
    {"[1, 2, 3]", "[1, (2, 3)]", 10, "plain values only", "list ( )"},
    {"depth = 3", "depth = 010", 4, "'010' may be meant as octal", "without the 0"},
    /* Arithmetic. */
    {"depth = 3", "depth = 2 +", 4, "';' stands where", "a number"},
    {"depth = 3", "depth = 2 * * 3", 4, "'*' stands where", "a number"},
    {"depth = 3", "depth = 2 * (1 + 2", 4, "';' stands where", "')'"},
    {"depth = 3", "depth = 1 / 0", 4, "what '/' gives", "no finite number"},
    {"= 0.25", "= 1e308 + 1e308", 5, "this sum", "no finite number"},
    {"depth = 3", "depth = - n", 4, "'n' is no value", "'let n = ...;'"},
    {"depth = 3", "let n = m; depth = n", 4, "'m' is no value", "'let m = ...;'"},
    {"depth = 3", "let n = 3; let n = 4; depth = n", 4, "'n' has its 'let' on line 4", ""},
    {"depth = 3", "let n = 4; depth = n-1", 4, "'n-1' is one name", "'n - 1'"},
    {"depth = 3", "let n = 4; depth = 2*n-wall", 4, "'n-wall' is one name", "'n - wall'"},
    {"depth = 3", "depth = 2n", 4, "'2n' is no number", "2*n"},
    {"depth = 3", "depth = sqrt(4)", 4, "'sqrt(' begins a function", "+ - * /"},
    {"depth = 3", "let n 3; depth = n", 4, "'3' stands where", "'='"},
    {"depth = 3", "depth = 3 -2", 4, "'-2' stands where", "';'"},
    {"[1, 2, 3]", "[1 -2, 3]", 10, "'-2' stands where", "','"},
    {"[1, 2, 3]", "[1, true, 3]", 10, "one type only", "'true'"},
    {"[1, 2, 3]", "[1, [2], 3]", 10, "plain values only", "list ( )"},
    {"[1, 2, 3]", "(1, \"2\", 3)", 10, "has to be 3 numbers", "one is a string"},
    {"[1, 2, 3]", "[1, 2, 3,]", 10, "',' too many", "the last element"},
    {"[1, 2, 3]", "[1 2, 3]", 10, "'2' stands where", "','"},
    {"[1, 2, 3]", "[1, 2", 10, "';' stands where", "',' or ']'"},
    {"[1, 2, 3]", "[1, 2, 3)", 10, "')' cannot close the '['", "']' is wanted"},
    {"[1, 2, 3]", "3", 10, "has to be 3 numbers", "is a number"},
    {"[1, 2, 3]", "[]", 10, "has to be 3 numbers", "is 0"},
    /* Strings, comments, bytes. */
    {"\"blinn\"", "\"blinn", 7, "no closing \"", "on its line"},
    {"\"blinn\"", "\"bl\\n\"", 7, "unknown escape", "only \\\" and \\\\"},
    {"\"blinn\"", "\"bl\tn\"", 7, "byte 09h", "not allowed"},
    {"\"blinn\"", "blinn", 7, "'blinn' is no value", "\"blinn\""},
    {"\"blinn\"", "\"bl\" \"inn\"", 7, "stands where", "';'"},
    {"*/", "", 53, "comment that begins here", "needs */"},
    {"[1, 2, 3]", "\x80", 10, "byte 80h", "outside of strings"},
    {"[1, 2, 3]", "$1", 10, "'$' is invalid", "NAME = VALUE"},
    {"depth = 3;", "@include \"/etc/passwd\";", 4, "include", "may not include other files"},
    /* Keys and brackets. */
    {"depth = 3", "dpeth = 3", 4, "unknown key 'dpeth' of the scene", "did you mean 'depth'"},
    {"depth = 3", "qqqqqqqq = 3", 4, "unknown key 'qqqqqqqq'", "allowed are version"},
    {"depth = 3", "depth 3", 4, "'=' is missing", "'depth'"},
    {"depth = 3", "depth = ;", 4, "';' stands where", "a value"},
    {"depth = 3", "depth = 3;;", 4, "';' stands where", "a key"},
    {"depth = 3", "= 3", 4, "'=' stands where", "a key"},
    {"depth = 3", "true = 3", 4, "'true' is a value", "no key"},
    {"depth = 3", "depth = yes", 4, "'yes'", "true or false"},
    {"depth = 3", "size = 3", 4, "duplicate key 'size'", "on line 3"},
    {"depth = 3", "depth = 3 }", 4, "'}' closes nothing", "no bracket is open"},
    {"30.5;\n}", "30.5;\n)", 19, "')' cannot close the '{' of line 14", "'}' is wanted"},
    {"direction = [0, 0, -2]; }", "direction = [0, 0, -2]; ", 23, "cannot close", "'}'"},
};

static const struct refusal setting_refusals[] = {
    /* Words of other programs. */
    {"camera = {", "width = 64; camera = {", 14, "unknown key 'width' of the scene",
     "size = [WIDTH"},
    {"look_at = [0, 0, 0];", "target = [0, 0, 0];", 16, "'target' of the camera", "'look_at'"},
    {"colour = [0, 32, 64]", "transparency = 1; colour = [0, 32, 64]", 26, "'transparency'",
     "'ior'"},
    {"version = 1", "version = 2", 1, "'version' of the scene is 2", "1 to 1"},
    {"version = 1;", "", 1, "lacks 'version'", "required"},
    {"title = \"A \\\"test\\\"\"", "title = 5", 2, "'title' of the scene", "a string in quotes"},
    {"[64, 40]", "[641, 40]", 3, "'size' of the scene is 641", "1 to 640"},
    {"[64, 40]", "[64, 401]", 3, "64 x 401", "640 x 400"},
    {"[64, 40]", "[64.5, 40.0]", 3, "64.5 x 40", "whole numbers"},
    {"[64, 40]", "[0, 40]", 3, "is 0", "1 to 640"},
    {"depth = 3", "depth = 256", 4, "256", "0 to 255"},
    {"depth = 3", "depth = 3.5", 4, "3.5", "a whole number, 0 to 255"},
    {"depth = 3", "depth = \"3\"", 4, "has to be a number", "is a string"},
    {"= 0.25", "= 1.5", 5, "1.5", "0 to 1 is allowed"},
    {"\"wavelength\"", "\"wave\"", 6, "\"wave\"", "\"simple\", \"fresnel\", \"wavelength\""},
    {"\"blinn\"", "\"Phong\"", 7, "\"Phong\"", "\"phong\", \"blinn\""},
    {"\"filter\"", "true", 8, "a string in quotes", "true or false"},
    {"\"bits:4\"", "\"bits:9\"", 9, "\"bits:9\"", "\"bits:8\""},
    {"[1, 2, 3]", "[1, 2, 256]", 10, "256", "0 to 255"},
    {"(4, 5.5, 6L)", "(4, -5.5, 6L)", 11, "-5.5", "0 to 255"},
    {"constant = 2", "constant = -2", 12, "'constant' of the attenuation", "0 to"},
    {"constant = 2; ", "", 12, "lacks 'constant'", "required"},
    {"(650, 550, 450)", "(650, 550, 350)", 13, "350", "380 to 780"},
    {"camera = {", "camara = {", 14, "unknown key 'camara'", "did you mean 'camera'"},
    {"[0.0, -10.0, 3.0]", "[0, 0, 0]", 16, "where its 'eye' is", "differ"},
    {"[0.0, -10.0, 3.0]", "[0, 0, 2000000000]", 15, "2000000000", "-1000000000 to 1000000000"},
    {"look_at = [0, 0, 0];", "", 14, "the camera lacks 'look_at'", "required"},
    {"up = (0, 1, 1.0)", "up = (0, -10, 3)", 17, "looks along 'up'", "not parallel"},
    {"up = (0, 1, 1.0)", "up = (0, 0, 0)", 17, "'up' of the camera is zero", "direction"},
    {"= 30.5", "= 0", 18, "'field_of_view'", "1 to 170"},
    {"= 30.5", "= 180", 18, "180", "1 to 170"},
    {"position = [1, 2, 3]; ", "", 21, "'position'", "has none"},
    {"{ direction", "{ position = [1, 2, 3]; direction", 22, "'direction'", "has both"},
    {"[0, 0, -2]", "[0, 0, 0]", 22, "'direction' of the light is zero", "[0, 0, -1]"},
    {"{ direction = [0, 0, -2]; }", "5", 22, "the light has to be a group", "is a number"},
    {"[300, 200, 100]", "[300, 200, 40000]", 21, "40000", "0 to 32767"},
    /* Materials. */
    {"colour = [0, 32, 64]; ", "", 25, "material 'glass' lacks 'colour'", "required"},
    {"colour = [0, 32, 64]", "color = [0, 32, 64]", 26, "'color'", "did you mean 'colour'"},
    {"ambient = 0.5", "ambient = 1.5", 26, "1.5", "0 to 1"},
    {"ambient_is_own = true", "ambient_is_own = 1", 26, "has to be true or false", "a number"},
    {"gloss = 70", "gloss = 65536", 27, "65536", "0 to 65535"},
    {"(1.5, 1.51, 1.53)", "0", 28, "'ior' of the material 'glass' is 0", "0.7 to 4"},
    {"(1.5, 1.51, 1.53)", "(1.5, 4.1, 1.5)", 28, "4.1", "0.7 to 4"},
    {"(1.5, 1.51, 1.53)", "(1.5, 1.5)", 28, "has to be 3 numbers", "is 2"},
    {"(1.5, 1.51, 1.53)", "1.5; cauchy = (1.5, 0)", 28, "both 'ior' and 'cauchy'", "one of them"},
    {"absorption = 0.125", "absorption = -0.125", 30, "-0.125", "0 to"},
    {"(1.5, 0.0121)", "(1.5, 0.9)", 32, "'cauchy'", "0.7 to 4"},
    {"[200, 200, 200];", "[200, 200, 200]; absorption = 1;", 34, "is opaque", "give it 'ior'"},
    {"[200, 200, 200];", "[200, 200, 200]; casts_shadow = false;", 34, "is false", "always"},
    {"0, 1);", "0);", 35, "has to be 17 numbers", "is 16"},
    {"(0.5, 0, 2)", "(0, 0, 0)", 36, "0 along all three axes", "leave the pattern out"},
    {"(0.5, 0, 2)", "(0.5, 0, 1e-20)", 36, "1e-20", "0 (no change along that axis)"},
    {"(0.5, 0, 2)", "(0.5, 0, -2)", 36, "-2", "0 to"},
    {"flint = {", "flint = 5; f = {", 32, "the material has to be a group", "is a number"},
};

static const struct refusal solid_refusals[] = {
    /* Parts, objects, materials by name. */
    {"{ part = \"shell\"; }", "{ part = \"pair\"; }", 48, "'pair'", "above it only, never itself"},
    {"part = \"pair\"", "part = \"pear\"", 56, "unknown part 'pear'", "did you mean 'pair'"},
    {"part = \"pair\"", "part = \"qqqq\"", 56, "unknown part 'qqqq'", "'name' of one of 'parts'"},
    {"name = \"pair\"", "name = \"shell\"", 46, "duplicate part 'shell'", "a name of its own"},
    {"name = \"pair\"", "name = \"\"", 46, "'name' of the part is empty", "needs a name"},
    {"name = \"shell\"; ", "", 40, "the part lacks 'name'", "required"},
    {"\"pairs\"; material = \"glass\"", "\"pairs\"; material = \"brass\"", 56,
     "unknown material 'brass'", "did you mean 'glass'"},
    {"\"pairs\"; material = \"glass\";", "\"pairs\";", 56, "lacks a 'material'", "on line 42"},
    {"solid = { part = \"pair\"; };", "", 56, "the object lacks 'solid'", "required"},
    {"solid = { part = \"pair\"; };", "solid = {};", 56, "this solid is empty", "it needs box"},
    {"solid = { part = \"pair\"; };", "solid = 1;", 56, "has to be a group", "is a number"},
    {"part = \"pair\"", "part = \"pair\"; ball = { radius = 1; }", 56, "both 'ball' and 'part'",
     "union"},
    {"part = \"pair\"", "sphere = \"pair\"", 56, "unknown key 'sphere' of the solid",
     "it is called 'ball' here"},
    {"part = \"pair\"", "cylindre = {}", 56, "'cylindre'", "did you mean 'cylinder'"},
    /* Degenerate leaves. */
    {"max = [1, 2, 3]", "max = [1, -2, 3]", 57, "the box is empty: along y", "less than"},
    {"max = [1, 2, 3]", "max = [1, -9, 3]", 57, "the box is empty: along y", "less than"},
    {"min = [-1, -2, -3]; ", "", 57, "the box lacks 'min'", "required"},
    {"scale = 2", "scale = 0", 58, "'scale' of the solid is 0", "1e-06 to"},
    {"scale = 2", "scale = (1, 2, 0)", 58, "'scale' of the solid is 0", "along an axis"},
    {"rotate = [0, 0, 90]", "rotate = 90", 58, "has to be 3 numbers", "is a number"},
    {"radius = 3.5", "radius = 0", 43, "'radius' of the ball is 0", "1e-09 to 1000000000"},
    {"radius = 3.5", "radius = -1", 43, "'radius' of the ball is -1", "1e-09 to"},
    {"radius = 3.5", "radius = true", 43, "has to be a number", "true or false"},
    {"to = [0, 0, 5]; radius = 2; }; },\n        { cone",
     "to = [0, 0, 0]; radius = 2; }; },\n        { cone", 60, "same point", "differ"},
    {"from_radius = 2; to_radius = 1", "from_radius = 2; to_radius = 2", 61, "both radii",
     "use a cylinder"},
    {"from_radius = 2; to_radius = 1", "from_radius = 0; to_radius = 0", 61, "are 0", "1e-09"},
    {"from_radius = 2; to_radius = 1", "from_radius = 2; to_radius = 1e-12", 61, "1e-12", "0 (its"},
    {"radii = [3, 4, 5]", "radii = [3, 0, 5]", 62, "'radii' of the ellipsoid is 0", "1e-09 to"},
    {"waist = 1; ", "", 64, "'waist'", "has none"},
    {"waist = 1; ", "waist = 1; gap = 1; ", 64, "'gap'", "has both"},
    {"waist = 1; ", "waist = 2; ", 64, "'waist' of the hyperboloid is 2", "less than 'radius'"},
    {"gap = 1; ", "gap = 5; ", 65, "'gap' of the hyperboloid is 5", "less than its length"},
    {"[1, 2, 3, 4, 5, 6, 7, 8, 9, -10]", "[0, 0, 0, 0, 0, 0, 0, 0, 0, -10]", 66, "no surface",
     "differ from 0"},
    {"[1, 2, 3, 4, 5, 6, 7, 8, 9, -10]", "[0, 0, 0, 0, 0, 0, 7, 8, 9, -10]", 66,
     "no quadratic term", "half_space"},
    {"[1, 2, 3, 4, 5, 6, 7, 8, 9, -10]", "[1, 2, 3]", 66, "has to be 10 numbers", "is 3"},
    {"normal = [0, 0, 2]", "normal = [0, 0, 0]", 67, "'normal' of the half_space is zero",
     "direction"},
    {"offset = 5;", "", 67, "a half_space needs either 'offset'", "has none"},
    {"{ normal = [-1, 0, 0]; offset = 0; },", "", 68, "has 3 elements", "4 to 64"},
    {"{ normal = [-1, 0, 0]; offset = 0; }", "7", 69, "the plane has to be a group", "a number"},
    {"through = [1, 5, 2]", "through = [1, 5, 2]; offset = 1", 72, "a plane needs", "has both"},
};

static char *join(const char *first, size_t length, const char *second, const char *third) {
    size_t size = length + strlen(second) + strlen(third) + 1;
    char *text = malloc(size);
    assert_non_null(text);
    snprintf(text, size, "%.*s%s%s", (int)length, first, second, third);
    return text;
}

/* Counts the refusals of a text; the lines that show places begin with a blank. */
static unsigned count_refusals(const struct scene_error *error) {
    unsigned count = error->text[0] != '\0';
    for (const char *line = strchr(error->text, '\n'); line; line = strchr(line + 1, '\n')) {
        count += line[1] != ' ';
    }
    return count;
}

/* Tells whether one of the refusals is of that line and holds both fragments. */
static bool is_refused(const struct scene_error *error, unsigned line, const char *fragment,
                       const char *remedy) {
    char start[32];
    (void)snprintf(start, sizeof start, "a.scene:%u:", line);
    for (const char *at = error->text; at != NULL; at = strchr(at, '\n')) {
        char refusal[2 * SCENE_REFUSAL_MOST];
        at += *at == '\n';
        (void)snprintf(refusal, sizeof refusal, "%.*s", (int)strcspn(at, "\n"), at);
        if (strncmp(refusal, start, strlen(start)) == 0 && strstr(refusal, fragment) != NULL &&
            strstr(refusal, remedy) != NULL) {
            return true;
        }
    }
    return false;
}

static void assert_refused(const char *text, size_t length, unsigned line, const char *fragment,
                           const char *remedy) {
    struct scene_error error = {""};
    struct scene_description *scene = scene_description_read("a.scene", text, length, &error);
    if (scene != NULL || !is_refused(&error, line, fragment, remedy)) {
        print_error("wanted: line %u...%s...%s\n   got: %s\n", line, fragment, remedy, error.text);
        scene_description_free(scene);
        fail();
    }
}

/* Puts the replacement of a refusal into a text that is the example or was made of it. Returns the
 * new text; NULL: what is to be replaced is not there any more. */
static char *put_in(const char *text, const struct refusal *refusal) {
    const char *place = strstr(text, refusal->find);
    return place == NULL ? NULL
                         : join(text, (size_t)(place - text), refusal->replacement,
                                place + strlen(refusal->find));
}

/* Each refusal is told, and nothing else: what is wrong once is said once. */
static void assert_all_refused(const struct refusal *refusals, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const struct refusal *refusal = &refusals[i];
        struct scene_error error = {""};
        char *text = put_in(SCENE_EXAMPLE, refusal);
        if (text == NULL) {
            fail_msg("not in the example: %s", refusal->find);
            return;
        }
        assert_refused(text, strlen(text), refusal->line, refusal->fragment, refusal->remedy);
        assert_null(scene_description_read("a.scene", text, strlen(text), &error));
        if (count_refusals(&error) != 1) {
            fail_msg("%s: %s", refusal->replacement, error.text);
        }
        free(text);
    }
}

static void refuses_bad_text(void **state) {
    (void)state;
    assert_all_refused(text_refusals, sizeof text_refusals / sizeof *text_refusals);
}

static void refuses_bad_settings(void **state) {
    (void)state;
    assert_all_refused(setting_refusals, sizeof setting_refusals / sizeof *setting_refusals);
}

static void refuses_bad_solids(void **state) {
    (void)state;
    assert_all_refused(solid_refusals, sizeof solid_refusals / sizeof *solid_refusals);
}

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

static void refuses_what_is_no_scene_at_all(void **state) {
    (void)state;
    assert_refused("", 0, 1, "lacks 'version'", "required");
    assert_refused("version = 1;\n\0", 14, 2, "NUL byte", "plain text");
    assert_refused("\n\nobjects = (\n", 14, 3, "'(' is never closed", "')' is missing");
    assert_refused("\n\na = {\n", 8, 3, "'{' is never closed", "'}' is missing");
    assert_refused("a = \"\\", 6, 1, "unknown escape", "only");
    assert_refused("a = /*/", 7, 1, "comment that begins here", "needs */");
    assert_refused("\na\n\n", 4, 4, "'=' is missing", "'a'");
    assert_refused("\na =\n\n", 6, 4, "the file ends where", "a value");
    assert_refused("a = {b = 1}; a = 2", 18, 1, "duplicate key 'a'", "line 1");
    /* Only what stands in a comment or a string may look like an include. */
    static const char harmless[] = "/*\n@include \"x\"\n*/ title = \"@include\";";
    assert_refused(harmless, strlen(harmless), 1, "lacks 'version'", "");
}

/* Text of a piece many times, between a start and an end. */
static char *repeat(const char *start, const char *piece, size_t times, const char *end) {
    size_t size = strlen(piece);
    char *middle = malloc(times * size + 1);
    assert_non_null(middle);
    for (size_t i = 0; i < times; i++) {
        memcpy(middle + i * size, piece, size);
    }
    middle[times * size] = '\0';
    char *text = join(start, strlen(start), middle, end);
    free(middle);
    return text;
}

static void assert_repeat_refused(const char *start, const char *piece, size_t times,
                                  const char *end, unsigned line, const char *fragment,
                                  const char *remedy) {
    char *text = repeat(start, piece, times, end);
    assert_refused(text, strlen(text), line, fragment, remedy);
    free(text);
}

#define HEAD                                                                                       \
    "version = 1; camera = { eye = [0, -5, 0]; look_at = [0, 0, 0]; };\n"                          \
    "materials = { m = { colour = [0, 0, 0]; }; };\n"
#define BALL "{ ball = { radius = 1; }; }"

static void refuses_what_is_too_much(void **state) {
    (void)state;
    assert_repeat_refused("", " ", 64 * 1024 * 1024 + 1, "", 1, "67108865 bytes is too large",
                          "67108864");
    assert_repeat_refused("a =", "(", 1000000, "", 1, "nest too deep", "at most 64");
    assert_repeat_refused("a = [", "(", 1000000, "", 1, "nest too deep", "at most 64");
    assert_repeat_refused("title = \"", "x", 1000000, "\";", 1, "1000000 bytes", "at most 200");
    assert_repeat_refused("", "x", 1000000, " = 1;", 1, "1000000 bytes", "at most 200");
    assert_repeat_refused("a = ", "1", 1000000, ";", 1, "1000000 characters", "at most 100");
    assert_repeat_refused(HEAD "objects = (", "", 0, ");", 3, "0 elements", "at least 1");
}

/* Nothing but memory limits how much a file holds. */
static void reads_many_things(void **state) {
    (void)state;
    enum { MANY = 5000 };
    static const struct {
        const char *start, *piece, *end;
    } texts[] = {
        {HEAD "objects = ( { material = \"m\"; solid = { union = (" BALL, ",\n" BALL, "); }; } );"},
        {HEAD "objects = ( { material = \"m\"; solid = " BALL "; }",
         ",\n{ material = \"m\"; solid = " BALL "; }", ");"},
        {HEAD "objects = ( { material = \"m\"; solid = " BALL "; } );\n"
              "lights = ( { position = [0, 0, 9]; }",
         ",\n{ position = [0, 0, 9]; }", ");"}};
    for (size_t i = 0; i < 3; i++) {
        struct scene_error error = {""};
        char *text = repeat(texts[i].start, texts[i].piece, MANY - 1, texts[i].end);
        struct scene_description *scene =
            scene_description_read("a.scene", text, strlen(text), &error);
        assert_string_equal(error.text, "");
        assert_non_null(scene);
        assert_int_equal(scene->node_count, i == 0 ? MANY + 1 : i == 1 ? MANY : 1);
        assert_int_equal(scene->object_count, i == 1 ? MANY : 1);
        assert_int_equal(scene->light_count, i == 2 ? MANY : 0);
        assert_int_equal(scene->instances, scene->node_count);
        scene_description_free(scene);
        free(text);
    }
}

/* Reads the example with another threshold; *error says why it is refused. */
static struct scene_description *read_threshold(const char *number, struct scene_error *error) {
    static const char before[] = "threshold = 0.25";
    const char *place = strstr(SCENE_EXAMPLE, before);
    assert_non_null(place);
    size_t start = (size_t)(place - SCENE_EXAMPLE) + strlen("threshold = ");
    char *text = join(SCENE_EXAMPLE, start, number, place + strlen(before));
    struct scene_description *scene = scene_description_read("a.scene", text, strlen(text), error);
    free(text);
    return scene;
}

/* Numbers of one value, whatever the number of their zeros: 100 characters are read to the last
 * one, and one more is too many. */
static void numbers_of_up_to_100_characters_are_read_whole(void **state) {
    (void)state;
    static const struct {
        const char *start, *end;
        double value;
    } forms[] = {{"0.5", "", 0.5}, {"0.", "1e9", 0}, {"+0.", "5", 0},    {"0.25e-", "1", 0.025},
                 {"0x", "1", 1},   {"-0.", "e0", 0}, {"5e-", "2", 0.05}, {"0.75E+", "", 0.75}};
    for (size_t i = 0; i < 4 * sizeof forms / sizeof forms[0]; i++) {
        size_t length = 99 + i % 4, start = strlen(forms[i / 4].start);
        const char *end = forms[i / 4].end;
        char number[128], reason[128];
        struct scene_error error = {""};
        memset(number, '0', length);
        memcpy(number, forms[i / 4].start, start);
        memcpy(number + length - strlen(end), end, strlen(end) + 1);
        struct scene_description *scene = read_threshold(number, &error);
        if (length <= 100) {
            assert_string_equal(error.text, "");
            assert_non_null(scene);
            assert_true(fabs(scene->threshold - forms[i / 4].value) < 1e-12);
        } else {
            snprintf(
                reason, sizeof reason,
                "a.scene:5:13: a number of %zu characters is too long: at most 100 are allowed",
                length);
            assert_null(scene);
            assert_memory_equal(error.text, reason, strlen(reason));
        }
        scene_description_free(scene);
    }
}

/* The camera of a scene that looks along a direction turned a little away from `up`, by an angle in
 * radians, with both of any length. Returns why that is refused; "" if it is not. */
static const char *refusal_of_up(const double view[3], const double across[3], double angle,
                                 double view_length, double up_length) {
    static struct scene_error error;
    char text[1024];
    double up[3];
    for (int i = 0; i < 3; i++) {
        up[i] = up_length * (cos(angle) * view[i] + sin(angle) * across[i]);
    }
    snprintf(text, sizeof text,
             "version = 1;\ncamera = { eye = [0.0, 0.0, 0.0];\n"
             "look_at = (%.17g, %.17g, %.17g);\nup = (%.17g, %.17g, %.17g); };\n"
             "materials = { m = { colour = [0, 0, 0]; }; };\n"
             "objects = ( { material = \"m\"; solid = { ball = { radius = 1; }; }; } );\n",
             view_length * view[0], view_length * view[1], view_length * view[2], up[0], up[1],
             up[2]);
    error.text[0] = '\0';
    scene_description_free(scene_description_read("a.scene", text, strlen(text), &error));
    return error.text;
}

static void up_may_be_a_millionth_away_from_the_view_and_no_nearer(void **state) {
    (void)state;
    static const double axes[][2][3] = {
        {{1, 0, 0}, {0, 1, 0}},     {{0, 1, 0}, {0, 0, 1}},      {{0, 0, 1}, {1, 0, 0}},
        {{1, 0, 0}, {0, 0, -1}},    {{0, 0.6, -0.8}, {1, 0, 0}}, {{0.6, 0, 0.8}, {0.8, 0, -0.6}},
        {{0.6, -0.8, 0}, {0, 0, 1}}};
    static const double lengths[] = {1e-3, 1, 70};
    const double straight = 3.14159265358979323846;
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; i++) {
        for (int j = 0; j < 9; j++) {
            const double *view = axes[i][0], *across = axes[i][1];
            double view_length = lengths[j / 3], up_length = lengths[j % 3];
            static const double angles[] = {0, 0.97e-6, 1.03e-6, 0.5};
            for (int k = 0; k < 8; k++) {
                double angle = k < 4 ? angles[k] : straight - angles[k - 4];
                const char *refusal = refusal_of_up(view, across, angle, view_length, up_length);
                if (k % 4 >= 2) {
                    assert_string_equal(refusal, "");
                } else if (strncmp(refusal, "a.scene:4:1: the camera looks along 'up' ([", 43) !=
                           0) {
                    fail_msg("axes %zu, lengths %g and %g, angle %g: \"%s\"", i, view_length,
                             up_length, angle, refusal);
                }
            }
        }
    }
}

/* 24 levels are allowed, and 25 are not. */
static void refuses_what_nests_too_deep(void **state) {
    (void)state;
    for (size_t levels = 24; levels <= 25; levels++) {
        char *inner = repeat(HEAD "objects = ( { material = \"m\"; solid = ", "{ union = ( ",
                             levels - 1, BALL);
        char *text = repeat(inner, " ); }", levels - 1, "; } );");
        struct scene_error error = {""};
        struct scene_description *scene =
            scene_description_read("deep", text, strlen(text), &error);
        if (levels == 24) {
            assert_string_equal(error.text, "");
            assert_non_null(scene);
        } else {
            assert_refused(text, strlen(text), 3, "nest too deep", "at most 24 levels");
        }
        scene_description_free(scene);
        free(inner);
        free(text);
    }
}

/* Parts of parts: the number of solids that they unfold to grows fourfold with each. */
static void refuses_parts_that_unfold_too_far(void **state) {
    (void)state;
    char text[8192] = HEAD "parts = ( { name = \"p0\"; solid = " BALL "; }";
    for (int i = 1; i < 11; i++) {
        size_t used = strlen(text);
        snprintf(
            text + used, sizeof text - used,
            ",\n{ name = \"p%d\"; solid = { union = ( { part = \"p%d\"; }, { part = \"p%d\"; }, "
            "{ part = \"p%d\"; }, { part = \"p%d\"; } ); }; }",
            i, i - 1, i - 1, i - 1, i - 1);
    }
    /* (8 times 4^i less 5) / 3 solids: 699,049 for p9, 2,796,201 for p10 */
    assert_refused(text, strlen(text), 3, "is never closed", "')'");
    strcat(text, ");");
    assert_refused(text, strlen(text), 13, "too many solids", "at most 1048576");
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

static void refuses_without_room_for_the_reason(void **state) {
    (void)state;
    char path[1000];
    memset(path, 'p', sizeof path - 1);
    path[sizeof path - 1] = '\0';
    struct scene_error error;
    assert_null(scene_description_read(path, "nonsense = 1;", 13, &error));
    assert_true(strlen(error.text) < sizeof error.text);
    assert_non_null(strstr(error.text, "unknown key"));
    assert_null(scene_description_read("a", "x", 1, NULL));
    assert_null(scene_description_read("a\nb", "\"\n", 2, &error));
    assert_null(strstr(error.text, "a\nb"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_bad_text),
        cmocka_unit_test(refuses_bad_settings),
        cmocka_unit_test(refuses_bad_solids),
        cmocka_unit_test(two_wrong_things_are_both_told),
        cmocka_unit_test(refuses_what_is_no_scene_at_all),
        cmocka_unit_test(refuses_what_is_too_much),
        cmocka_unit_test(reads_many_things),
        cmocka_unit_test(numbers_of_up_to_100_characters_are_read_whole),
        cmocka_unit_test(up_may_be_a_millionth_away_from_the_view_and_no_nearer),
        cmocka_unit_test(refuses_what_nests_too_deep),
        cmocka_unit_test(refuses_parts_that_unfold_too_far),
        cmocka_unit_test(a_mark_stands_under_what_is_wrong),
        cmocka_unit_test(a_long_line_is_shown_in_part),
        cmocka_unit_test(at_most_twenty_are_told_in_the_order_of_the_file),
        cmocka_unit_test(refuses_without_room_for_the_reason),
    };
    return cmocka_run_group_tests_name("scene_reader_refusals", tests, NULL, NULL);
}
