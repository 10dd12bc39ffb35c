/* SPDX-License-Identifier: MIT */
/* Where results go: no two to one place, however it is spelled, and none over what is read. */
#include "options_fixture.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/path.h"

/* In a folder with the files a.scene, t, in.png, link -> a.scene, ahead -> new.png, sub/, the empty
 * file empty, real.png, which begins as a PNG, short.png, which ends too early, and fig4a.png. */
static const struct {
    const char *line;
    const char *fragment; /* of the message; NULL: taken */
} lines[] = {
    /* The picture that is named after the scene. */
    {"render fig3 --stats fig3.png", "the same place, fig3.png: -o and --stats"},
    {"render fig3 --signatures fig3.png", "-o and --signatures"},
    {"render fig3 --trace ./fig3.png", "-o and --trace"},
    {"render fig3 --bus trace:x --stats fig3.png", NULL},
    {"render fig3 --stats fig3", NULL},
    {"render fig3 -o fig3", NULL},
    /* Every pair. */
    {"render fig3 --bus trace:x --signatures x", "--signatures and --bus trace"},
    {"render fig3 --bus trace:- --signatures -", "standard output"},
    {"render fig3 -o a --stats b --trace c --signatures d", NULL},
    {"boot a --trace x --stats ./x", "--stats and --trace"},
    /* Other spellings. */
    {"render fig3 -o x.png --stats ./x.png", "the same place"},
    {"render fig3 -o x.png --stats sub/../x.png", "the same place"},
    {"render fig3 -o real.png --stats .//real.png", "the same place"},
    {"render fig3 -o ahead --stats new.png", "the same place"},
    {"render fig3 -o sub/x --stats x", NULL},
    {"render fig3 -o x --stats sub", NULL},
    {"render fig3 -o - --stats -", "standard output: -o and --stats"},
    /* Devices. */
    {"render fig3 -o /dev/null --stats /dev/null", NULL},
    {"compare in.png in.png --difference /dev/null", NULL},
    /* The pictures of a multiple exposure, in a folder that is not there yet. */
    {"render fig3 --keep-exposures ke -o ke/exposure-0.png", "--keep-exposures"},
    {"render fig3 --keep-exposures ke/ -o ./ke/./exposure-7.png", "the same place"},
    {"render fig3 --keep-exposures ke -o ke/exposure-8.png", NULL},
    {"render fig3 --keep-exposures ke -o exposure-0.png", NULL},
    /* What a command prints. */
    {"compare in.png t --difference -", "--difference and the report"},
    {"compare in.png t --difference d.png", NULL},
    {"trace t -o - --list", "-o and what is told"},
    {"trace t -o -", NULL},
    {"adapter -o -", "where the adapter listens"},
    /* What is read. */
    {"render a.scene -o ./a.scene", "a.scene: -o would overwrite what is read"},
    {"render a.scene --stats link", "--stats would overwrite"},
    {"render sub/../in.png", "-o would overwrite"}, /* in.png is the default */
    {"render fig3 --native in.png -o in.png", "in.png: -o would overwrite"},
    {"replay a.scene t -o t", "t: -o would overwrite"},
    {"replay t t -o x", NULL},
    {"replay - -o -", NULL},
    {"trace t --to text -o t", "would overwrite"},
    {"compile a.scene -o a.scene", "would overwrite"},
    {"export a.scene --pov -o link", "would overwrite"},
    {"tree a.scene 1 2 -o a.scene", "would overwrite"},
    {"tree fig3 1 2 -o 1", NULL},
    {"boot t --trace t", "would overwrite"},
    {"compare in.png t --difference in.png", "would overwrite"},
    {"compare a b --signatures t --difference t", "would overwrite"},
    {"compare in.png in.png --signatures in.png", NULL},
    /* A picture replaces pictures and empty files only, and has no other picture's name. */
    {"render fig3 -o a.scene", "is no PNG; --force replaces it"},
    {"render fig3 -o link", "is no PNG"},
    {"render fig3 -o short.png", "is no PNG"},
    {"render fig3 -o real.png", NULL},
    {"render fig3 -o empty", NULL},
    {"render fig3 -o sub", NULL}, /* a folder: the command says so */
    {"render fig3 -o a.scene --force", NULL},
    {"render fig3 -o x.jpg", "what is written is a PNG"},
    {"render fig3 -o x.TIFF --force", "what is written is a PNG"},
    {"render fig3 -o x.pngs", NULL},
    {"render fig3 -o jpg", NULL},
    {"render fig4a", "fig4a.png: the file that is there is no PNG"},
    {"render fig4a --bus trace:x", NULL},
    {"replay t -o a.scene", "is no PNG"},
    {"boot t -o a.scene", "is no PNG"},
    {"adapter -o a.scene", "is no PNG"},
    {"trace t -o a.scene", "is no PNG"},
    {"trace t --to text -o a.scene", NULL},
    {"compare in.png real.png --difference a.scene", "is no PNG"},
    {"compile fig3 -o a.scene", NULL},
    {"render fig3 -o real.png --stats a.scene", NULL},
};

static char before[4096], folder[] = "/tmp/superframe-places-XXXXXX";

static int enter(void **state) {
    (void)state;
    if (getcwd(before, sizeof before) == NULL || mkdtemp(folder) == NULL || chdir(folder) != 0) {
        return -1;
    }
    return system(
        "echo > a.scene; echo > t; echo > in.png; mkdir sub; ln -s a.scene link; "
        "ln -s new.png ahead; : > empty; printf '\\211PNG' > short.png; echo > fig4a.png; "
        "printf '\\211PNG\\r\\n\\032\\n and more' > real.png");
}

static int leave(void **state) {
    (void)state;
    char line[128];
    (void)snprintf(line, sizeof line, "rm -r %s", folder);
    return chdir(before) != 0 || system(line) != 0 ? -1 : 0;
}

static void results_that_clash_are_refused(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        struct options options;
        struct options_error error;
        bool is_taken = parse(lines[i].line, &options, &error);
        bool is_right = lines[i].fragment == NULL
                            ? is_taken
                            : !is_taken && strstr(error.text, lines[i].fragment) != NULL;
        if (!is_right) {
            fail_msg("\"%s\": \"%s\"", lines[i].line, error.text);
        }
    }
}

static void a_path_is_resolved_whether_it_is_there_or_not(void **state) {
    (void)state;
    static const struct {
        const char *path, *resolved; /* in the folder */
    } paths[] = {{".", ""},
                 {"t", "/t"},
                 {"./sub/.././t", "/t"},
                 {"link", "/a.scene"},
                 {"ahead", "/new.png"},
                 {"not", "/not"},
                 {"sub/../not", "/not"},
                 {"not/./there//yet/", "/not/there/yet"}};
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        char wanted[256];
        (void)snprintf(wanted, sizeof wanted, "%s%s", folder, paths[i].resolved);
        char *resolved = path_resolve(paths[i].path);
        assert_string_equal(resolved, wanted);
        free(resolved);
    }
    char *root = path_resolve("/not-there/at-all");
    assert_string_equal(root, "/not-there/at-all");
    free(root);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_that_clash_are_refused),
        cmocka_unit_test(a_path_is_resolved_whether_it_is_there_or_not),
    };
    return cmocka_run_group_tests(tests, enter, leave);
}
