/* SPDX-License-Identifier: MIT */
/* The scene reader: what bad files are refused for, with the line and the remedy. */
#include <math.h>

#include "scene_refusals.h"

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
    /* Whatever the first value of the file is, nothing has been read before it. */
    static const char *const firsts[] = {"[1, 2]", "[]", "(1, 2)", "()", "{}",
                                         "[",      "(",  "{",      "-",  "\""};
    for (size_t i = 0; i < sizeof firsts / sizeof *firsts; i++) {
        char text[40];
        (void)snprintf(text, sizeof text, "size = %s", firsts[i]);
        assert_refused(text, strlen(text), 1, "", "");
    }
    /* Only what stands in a comment or a string may look like an include. */
    static const char harmless[] = "/*\n@include \"x\"\n*/ title = \"@include\";";
    assert_refused(harmless, strlen(harmless), 1, "lacks 'version'", "");
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
        cmocka_unit_test(refuses_what_is_no_scene_at_all),
        cmocka_unit_test(refuses_what_is_too_much),
        cmocka_unit_test(reads_many_things),
        cmocka_unit_test(numbers_of_up_to_100_characters_are_read_whole),
        cmocka_unit_test(up_may_be_a_millionth_away_from_the_view_and_no_nearer),
        cmocka_unit_test(refuses_what_nests_too_deep),
        cmocka_unit_test(refuses_parts_that_unfold_too_far),
        cmocka_unit_test(refuses_without_room_for_the_reason),
    };
    return cmocka_run_group_tests_name("scene_reader_refusals", tests, NULL, NULL);
}
