/* SPDX-License-Identifier: MIT */
/* `superframe check` and `superframe compile` say what became of a scene's solids. */
#include "command_fixture.h"

static void write_scene(const char *objects) {
    FILE *file = fopen("some.scene", "w");
    assert_non_null(file);
    (void)fprintf(file,
                  "version = 1; size = [32, 20];\n"
                  "camera = { eye = (3, -7, 5); look_at = (0, 0, 0); field_of_view = 34; };\n"
                  "materials = { clay = { colour = [200, 90, 40]; diffuse = 0.7; }; };\n"
                  "objects = ( %s );\n",
                  objects);
    (void)fclose(file);
}

/* A rod less a plate that reaches out of it, and twice the same ball. */
static const char solids[] =
    "{ material = \"clay\"; solid = { difference = ( { cylinder = { from = (0, 0, 0); "
    "to = (0, 0, 2); radius = 0.5; }; }, { box = { min = (0, -4, 0.5); max = (4, 4, 1.5); }; "
    "rotate = (0, 20, 0); } ); }; }, "
    "{ material = \"clay\"; solid = { union = ( { ball = { centre = (3, 0, 0); radius = 1; }; }, "
    "{ ball = { centre = (3, 0, 0); radius = 1; }; } ); }; }";

static void assert_says(const char *path, const char *line) {
    if (strstr(text_of(path), line) == NULL) {
        fail_msg("no \"%s\" in: %s", line, text_of(path));
    }
}

static void check_says_what_became_of_the_solids(void **state) {
    (void)state;
    write_scene(solids);
    assert_status("superframe check some.scene", 0);
    assert_says("out", "\nshared      1 solid is the same as another one\n");
    assert_says("out", "\nsimplified  1 operation of CSG says nothing\n");
    assert_says("out", "\nfused       1 solid is taken in by its neighbour\n");
    assert_says("out", "\nbounded     1 solid ends where nothing more of it is seen\n");
    assert_says("out",
                "\nhidden      4 pairs of primitives cannot be met one from within the other\n");
}

static void check_tells_of_refraction_where_something_is_transparent(void **state) {
    (void)state;
    write_scene(solids);
    assert_status("superframe check some.scene", 0);
    assert_null(strstr(text_of("out"), "refraction"));
    assert_null(strstr(text_of("out"), " inf"));
    assert_status("superframe check fig3", 0);
    assert_says("out", "\nrefraction  indices 1.5 to 1.5\n");
    /* Of a glass that disperses, the index of green counts. */
    write_scene(
        "{ material = \"prism\"; solid = { ball = { centre = (0, 0, 0); radius = 1; }; }; }");
    assert_status("sed -i 's/materials = {/& prism = { colour = [9, 9, 9]; ior = (1.4, 1.5, 1.7); "
                  "};/' some.scene; superframe check some.scene",
                  0);
    assert_says("out", "\nrefraction  indices 1.5 to 1.5\n");
}

/* A floor that ends too early is remarked upon; the `world` that is named there mends it. */
static void check_and_render_tell_where_a_floor_ends_too_early(void **state) {
    (void)state;
    static const char *const normals[] = {"0, 0, 1", "0, 0.02, 1", "0, 0, -1"};
    for (int i = 0; i < 3; i++) {
        char objects[300], command[300];
        (void)snprintf(
            objects, sizeof objects,
            "{ material = \"clay\"; solid = { ball = { radius = 1; }; }; }, { material = "
            "\"clay\"; solid = { half_space = { normal = [%s]; offset = %s; }; }; }",
            normals[i], i == 2 ? "-9" : "-1");
        write_scene(objects);
        assert_status(i == 2 ? "superframe check some.scene --set camera.look_at=[0,0,6]"
                             : "superframe check some.scene --set camera.look_at=[0,0,2]",
                      0);
        assert_says("out", "\nhorizon     the endless object of line 4 is seen to end ");
        const char *world = strstr(text_of("out"), "world = ");
        (void)snprintf(command, sizeof command,
                       "superframe check some.scene --set camera.look_at=[0,0,%d] --set world=%d",
                       i == 2 ? 6 : 2, atoi(world + strlen("world = ")) + 1);
        assert_status(command, 0);
        assert_null(strstr(text_of("out"), "horizon"));
        (void)snprintf(command, sizeof command,
                       "superframe render some.scene -o p.png --set camera.look_at=[0,0,%d]",
                       i == 2 ? 6 : 2);
        assert_status(command, 0);
        assert_says("err", "superframe: some.scene:4: this endless object is seen to end, ");
        strcat(command, " --set world=9"); /* who says where the world ends means it */
        assert_status(command, 0);
        assert_null(strstr(text_of("err"), "endless"));
    }
    /* Not where the picture ends before it, nor of what has an end. */
    assert_status("superframe check some.scene --set camera.look_at=[3,-6,0]", 0);
    assert_null(strstr(text_of("out"), "horizon"));
    write_scene(solids);
    assert_status("superframe check some.scene --set camera.look_at=[0,0,3]", 0);
    assert_null(strstr(text_of("out"), "horizon"));
}

static void a_scene_of_which_nothing_is_seen_says_so(void **state) {
    (void)state;
    write_scene(solids);
    assert_status("superframe check some.scene", 0);
    assert_null(strstr(text_of("out"), "nothing is in view"));
    assert_status("superframe check some.scene --set camera.look_at=[6,-14,10]", 0);
    assert_says("out", "\nview        nothing is in view");
    assert_status("superframe render some.scene -o p.png --set camera.look_at=[6,-14,10]", 0);
    assert_says("err", "superframe: some.scene: nothing is in view, ");
}

/* What has no size is told by what there is to mend. */
static void a_scene_without_a_size_is_told_why(void **state) {
    (void)state;
    write_scene("{ material = \"clay\"; solid = { half_space = { normal = [0, 0, 1]; offset = 0; "
                "}; }; }");
    assert_status("superframe check some.scene", 2);
    assert_says("err", "superframe: some.scene: nothing here has a size");
    write_scene("{ material = \"clay\"; solid = { polyhedron = { planes = ( { normal = [1, 0, 0]; "
                "offset = 1; }, { normal = [-1, 0, 0]; offset = 1; }, { normal = [0, 1, 0]; "
                "offset = 1; }, { normal = [0, 0, 1]; offset = 1; } ); }; }; }");
    assert_status("superframe check some.scene", 2);
    assert_says("err", "superframe: some.scene:4: a polyhedron without an end");
}

static unsigned count_of(const char *text, const char *word) {
    unsigned count = 0;
    for (const char *found = text; (found = strstr(found, word)) != NULL; found++) {
        count++;
    }
    return count;
}

static void check_validates_each_step_on_demand(void **state) {
    (void)state;
    write_scene(solids);
    assert_status("superframe check some.scene", 0);
    assert_int_equal(count_of(text_of("out"), "\nvalidated "), 0);
    assert_status("superframe check --validate some.scene", 0);
    assert_int_equal(count_of(text_of("out"), "\nvalidated "), 9);
    assert_int_equal(count_of(text_of("out"), " points agree\n"), 9);
    assert_status("superframe render --validate some.scene", 2);
}

static void a_compiled_scene_says_the_same(void **state) {
    (void)state;
    write_scene(solids);
    assert_status("superframe compile some.scene -o some.c", 0);
    assert_says("some.c",
                "/* solids shared 1, simplified 1, fused 1, bounded 1, pairs hidden 4 */\n");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(check_says_what_became_of_the_solids),
        TEST(check_tells_of_refraction_where_something_is_transparent),
        TEST(check_and_render_tell_where_a_floor_ends_too_early),
        TEST(a_scene_of_which_nothing_is_seen_says_so),
        TEST(a_scene_without_a_size_is_told_why),
        TEST(check_validates_each_step_on_demand),
        TEST(a_compiled_scene_says_the_same),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
