/* SPDX-License-Identifier: MIT */
/* --set: what it makes of a scene is what the changed file would be. */
#include "command_fixture.h"

/* A copy of a built-in scene stands as SCENE.scene in the test's folder. */
static void copy_scene(const struct place *place, const char *scene) {
    char line[2 * PATH_SIZE];
    (void)snprintf(line, sizeof line, "cp %s/firmware/scenes/%s.scene .", place->before, scene);
    assert_status(line, 0);
}

/* An assignment, and the same by sed in the file. */
static const struct {
    const char *scene, *set, *sed;
} changes[] = {
    {"fig4a", "--set materials.ball.ior=1.33", "/ball = {/,/};/s/ior = 1.5/ior = 1.33/"},
    {"fig4a", "--set materials.inner.ior='2 * 0.75'", ""},
    {"fig4a", "--set objects.4.solid.ball.radius=0.5", "s/radius = 0.7/radius = 0.5/"},
    {"fig4a", "--set objects.ball.solid.ball.radius=0.5", "s/radius = 0.7/radius = 0.5/"},
    {"fig4a", "--set lights.0.direction.2=-0.5", "s/(-0.4, 0.5, -1.0)/(-0.4, 0.5, -0.5)/"},
    {"fig4a", "--set lights.0.direction='[1, 0.5, -1]'", "s/(-0.4, 0.5, -1.0)/(1, 0.5, -1)/"},
    {"fig4a", "--set 'title=\"of mine\"'", "s/title = .*/title = \"of mine\";/"},
    {"fig4a", "--set depth=3", "s/^depth = .*/depth = 3;/"},
    {"fig4a", "--set ambient='[1, 2, 3]'", "s/^version = 1;/version = 1; ambient = [1, 2, 3];/"},
    {"fig4a", "--set objects.ball.solid.ball.radius=0.5 --set materials.ball.ior=1.33",
     "s/radius = 0.7/radius = 0.5/; /ball = {/,/};/s/ior = 1.5/ior = 1.33/"},
    {"fig5", "--set size='[64, 40]'", "s/^size = .*/size = [64, 40];/"},
};

static void an_assignment_is_the_changed_file(void **state) {
    const struct place *place = *state;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        char line[PATH_SIZE];
        copy_scene(place, changes[i].scene);
        (void)snprintf(line, sizeof line,
                       "superframe compile %s %s -o set.c && sed -i '%s' %s.scene && "
                       "superframe compile %s.scene -o sed.c && cmp set.c sed.c",
                       changes[i].scene, changes[i].set, changes[i].sed, changes[i].scene,
                       changes[i].scene);
        assert_status(line, 0);
    }
}

/* Whatever stands in the file, assigned to itself, changes nothing: the option wins over neither.
 */
static void options_come_after_assignments(void **state) {
    (void)state;
    assert_status("superframe compile fig3 --set depth=3 --depth 5 -o a.c && "
                  "superframe compile fig3 --depth 5 -o b.c && cmp a.c b.c",
                  0);
    assert_status("superframe compile fig3 --set depth=3 --set depth=4 -o a.c && "
                  "superframe compile fig3 --set depth=4 -o b.c && cmp a.c b.c",
                  0);
}

static const struct {
    const char *set, *fragment;
} wrong[] = {
    {"materials.bal.ior=2", "--set materials.bal.ior: there is no 'bal'; did you mean 'ball'?"},
    {"materials.ball.ior=9", "'ior' of the material 'ball' is 9: 0.7 to 4 is allowed"},
    {"materials.ball.iro=2", "unknown key 'iro' of the material 'ball'; did you mean 'ior'?"},
    {"objects.7.solid=1", "no element '7'; allowed is: 0 to 4, or an element's name"},
    {"objects.5.name=1", "no element '5'"},
    {"depth=three", "'three' is no value"},
    {"depth=", "'' is no value"},
    {"depth=1; size=2", "is no value"},
    {"=3", "allowed is PATH=VALUE"},
    {"a..b=3", "there is no 'a'"},
    {"materials..ior=3", "allowed is PATH=VALUE"},
    {"depth.x=3", "there is no 'x'"},
    {"depth", "--set: \"depth\" is invalid"},
};

static void what_leads_nowhere_is_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        char line[PATH_SIZE];
        (void)snprintf(line, sizeof line, "superframe render fig4a --set '%s' -o x.png",
                       wrong[i].set);
        assert_status(line, 2);
        if (strstr(text_of("err"), wrong[i].fragment) == NULL) {
            fail_msg("%s: \"%s\" lacks \"%s\"", wrong[i].set, text_of("err"), wrong[i].fragment);
        }
        assert_false(is_there("x.png"));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(an_assignment_is_the_changed_file, enter, leave),
        cmocka_unit_test_setup_teardown(options_come_after_assignments, enter, leave),
        cmocka_unit_test_setup_teardown(what_leads_nowhere_is_refused, enter, leave),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
