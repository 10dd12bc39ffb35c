/* SPDX-License-Identifier: MIT */
/* What --json and --stats print is JSON, and has what a script asks for. */
#include "command_fixture.h"
#include "json_check.h"

static const struct {
    const char *line;
    const char *fragment; /* of standard output */
} lines[] = {
    {"superframe scenes --json", "\"name\": \"fig3\""},
    {"superframe check fig3 --json", "\"csg_nodes\": "},
    {"superframe check fig4a --json --validate", "\"faults\": 0"},
    {"superframe tree fig3 150 100 --depth 3 --json", "\"kind\": \"eye\""},
    {"superframe render fig3 --size 20x10 --depth 2 --quiet -o a.png --stats -",
     "\"trace_hash\": "},
    {"superframe render fig3 --size 20x10 --depth 2 --bus trace:t && "
     "superframe trace t --statistics --json",
     "\"redundant_writes\": "},
    {"superframe compare a.png a.png --json", "\"holds\": true"},
    {"superframe measure figA --arith fx --depth 2 --size 20x10 --quiet --json -o m",
     "\"rays_per_pixel\": "},
};

static void what_is_printed_is_json(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_status(lines[i].line, 0);
        if (!is_json(text_of("out")) || strstr(text_of("out"), lines[i].fragment) == NULL) {
            fail_msg("\"%s\": %s", lines[i].line, text_of("out"));
        }
    }
}

/* Points that were measured, and points that points.csv had already, are printed alike. */
static void what_measure_prints_is_what_its_folder_holds(void **state) {
    static const char line[] = "superframe measure figA --arith fx --depth 2 --size 20x10 --quiet "
                               "--json -o m";
    static const char *const keys[] = {"rays",          "shadow_rays",   "nodes",   "solid_tests",
                                       "leaked_rays",   "port_writes",   "seconds", "percent_wrong",
                                       "percent_apart", "largest_error", "rmse"};
    (void)state;
    assert_status(line, 0);
    char *printed = strdup(text_of("out"));
    char *points = strdup(text_of("m/points.csv"));
    char *row = strchr(points, '\n') + 1;
    unsigned rows = 0;
    for (char *end; (end = strchr(row, '\n')) != NULL; row = end + 1, rows++) {
        char fragment[1024] = "";
        const char *value = row;
        for (int i = 0; i < 10; i++) {
            value = strchr(value, ',') + 1;
        }
        for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
            size_t used = strlen(fragment);
            int length = (int)strcspn(value, ",");
            (void)snprintf(fragment + used, sizeof fragment - used, "      \"%s\": %.*s,\n",
                           keys[i], length, value);
            value += length + 1;
        }
        if (strstr(printed, fragment) == NULL) {
            fail_msg("--json lacks %s", fragment);
        }
    }
    assert_true(rows > 10);
    assert_status(line, 0);
    assert_string_equal(text_of("out"), printed);
    free(points);
    free(printed);
}

/* Libraries are asked; on a machine without adapters the list is empty. */
static void a_list_of_no_devices_is_a_list(void **state) {
    (void)state;
    int status = run("superframe devices --json");
    assert_true(status == 0 || status == 1);
    assert_true(is_json(text_of("out")));
    assert_true(text_of("out")[0] == '[');
}

static void a_scene_comes_from_standard_input(void **state) {
    (void)state;
    assert_status("superframe export fig3 --pov -o - > direct", 0);
    char line[2 * PATH_SIZE + 256];
    const struct place *place = *state;
    (void)snprintf(line, sizeof line,
                   "superframe check - < %s/firmware/scenes/fig3.scene && "
                   "superframe render - --size 20x10 < %s/firmware/scenes/fig3.scene && "
                   "superframe render fig3 --size 20x10 && cmp scene.png fig3.png",
                   place->before, place->before);
    assert_status(line, 0);
    assert_status("echo 'version = ' | superframe check -", 2);
    assert_non_null(strstr(text_of("err"), "superframe: standard input:2:1: "));
}

static void a_built_in_scene_is_printed_as_it_is(void **state) {
    const struct place *place = *state;
    char line[PATH_SIZE + 128];
    (void)snprintf(line, sizeof line,
                   "superframe scenes --print fig4b | cmp - %s/firmware/scenes/fig4b.scene",
                   place->before);
    assert_status(line, 0);
    assert_status("superframe scenes --print fig9", 2);
    assert_non_null(strstr(text_of("err"), "no built-in scene \"fig9\""));
    assert_status("superframe scenes --print fig3 --json", 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_is_printed_is_json, enter, leave),
        cmocka_unit_test_setup_teardown(what_measure_prints_is_what_its_folder_holds, enter, leave),
        cmocka_unit_test_setup_teardown(a_list_of_no_devices_is_a_list, enter, leave),
        cmocka_unit_test_setup_teardown(a_scene_comes_from_standard_input, enter, leave),
        cmocka_unit_test_setup_teardown(a_built_in_scene_is_printed_as_it_is, enter, leave),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
