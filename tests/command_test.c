/* SPDX-License-Identifier: MIT */
/* The program as its users call it: exit status, messages, results, and nothing half-written.
 *
 * SUPERFRAME names the program (build/sanitized/superframe). Each line runs in a shell, in a new
 * folder, with `superframe` on its path. */
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { TEXT_SIZE = 65536, PATH_SIZE = 4096 };

struct place {
    char before[PATH_SIZE];
    char folder[64];
};

/* A small scene that renders at once. */
#define TINY "fig3 --size 16x10 --depth 2 "

static int enter_group(void **state) {
    (void)state;
    char program[2 * PATH_SIZE], path[2 * PATH_SIZE], here[PATH_SIZE] = "";
    static char folder[] = "/tmp/superframe-bin-XXXXXX";
    const char *name = getenv("SUPERFRAME");
    name = name != NULL ? name : "build/sanitized/superframe";
    if (name[0] != '/' && getcwd(here, sizeof here) == NULL) {
        return -1;
    }
    (void)snprintf(program, sizeof program, "%s/%s", here, name);
    if (access(program, X_OK) != 0 || mkdtemp(folder) == NULL) {
        (void)fprintf(stderr, "SUPERFRAME does not name the program\n");
        return -1;
    }
    (void)snprintf(path, sizeof path, "%s/superframe", folder);
    if (symlink(program, path) != 0) {
        return -1;
    }
    (void)snprintf(path, sizeof path, "%s:%s", folder, getenv("PATH"));
    /* A sanitizer's report must not pass for one of the program's own statuses. */
    return setenv("PATH", path, 1) | setenv("ASAN_OPTIONS", "exitcode=99", 1) |
           setenv("UBSAN_OPTIONS", "exitcode=99:print_stacktrace=1", 1) |
           setenv("LSAN_OPTIONS", "exitcode=99", 1);
}

static int leave_group(void **state) {
    (void)state;
    char folder[64];
    const char *path = getenv("PATH");
    size_t length = strcspn(path, ":");
    if (length >= sizeof folder - sizeof "/superframe") {
        return -1;
    }
    memcpy(folder, path, length);
    folder[length] = '\0';
    char link[80];
    (void)snprintf(link, sizeof link, "%s/superframe", folder);
    return unlink(link) | rmdir(folder);
}

static int enter(void **state) {
    struct place *place = calloc(1, sizeof *place);
    if (place == NULL || getcwd(place->before, sizeof place->before) == NULL) {
        return -1;
    }
    strcpy(place->folder, "/tmp/superframe-command-XXXXXX");
    *state = place;
    return mkdtemp(place->folder) == NULL || chdir(place->folder) != 0 ? -1 : 0;
}

static int leave(void **state) {
    struct place *place = *state;
    char line[128];
    (void)snprintf(line, sizeof line, "rm -rf %s", place->folder);
    int failed = chdir(place->before) != 0 || system(line) != 0;
    free(place);
    return failed ? -1 : 0;
}

/* All of a file as text; "" if it is not there. */
static const char *text_of(const char *path) {
    static char text[TEXT_SIZE];
    FILE *file = fopen(path, "rb");
    size_t length = 0;
    if (file != NULL) {
        length = fread(text, 1, sizeof text - 1, file);
        (void)fclose(file);
    }
    text[length] = '\0';
    return text;
}

/* Runs a line of shell with a limit of time; its output goes to the files out and err. */
static int run(const char *line) {
    char whole[2048];
    FILE *script = fopen("line", "w");
    assert_non_null(script);
    (void)fprintf(script, "%s\n", line);
    (void)fclose(script);
    (void)snprintf(whole, sizeof whole, "timeout -k 5 100 sh ./line > out 2> err < /dev/null");
    int status = system(whole);
    (void)unlink("line");
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void assert_status(const char *line, int expected) {
    int status = run(line);
    if (status != expected) {
        fail_msg("\"%s\": status %d instead of %d: %s", line, status, expected, text_of("err"));
    }
}

/* How many temporary files lie about. */
static int leftovers(void) {
    int count = 0;
    DIR *folder = opendir(".");
    struct dirent *entry;
    while ((entry = readdir(folder)) != NULL) {
        count += strncmp(entry->d_name, ".superframe", 11) == 0;
    }
    (void)closedir(folder);
    return count;
}

static bool is_there(const char *path) {
    return access(path, F_OK) == 0;
}

/* ---- Wrong input ---------------------------------------------------------------------------- */

/* Each line ends with its status and a message, and writes no x.png. */
static const struct {
    const char *line;
    int status;
    const char *fragment;
} wrong[] = {
    {"superframe", 2, "superframe: a command is lacking"},
    {"superframe rendre fig3", 2, "superframe: no command \"rendre\""},
    {"superframe tree fig3 1 1", 2, "superframe: tree: not built into this version"},
    {"superframe export fig3 --pov -o x", 2, "superframe: export: not built"},
    {"superframe measure", 2, "superframe: measure: not built"},
    {"superframe paper -o x", 2, "superframe: paper: not built"},
    {"superframe devices", 2, "superframe: devices: not built"},
    {"superframe adapter", 2, "superframe: adapter: not built"},
    {"superframe trace x", 2, "superframe: trace: not built"},
    {"superframe boot x", 2, "superframe: boot: not built"},
    {"superframe render nothing -o x.png", 2, "superframe: nothing: cannot be read: No such file"},
    {"superframe render . -o x.png", 2, "superframe: .: is a folder"},
    {"superframe render /dev/null -o x.png", 2, "superframe: /dev/null"},
    {"superframe render /dev/zero -o x.png", 2, "superframe: /dev/zero"},
    {"echo 'title = ' > s; superframe render s -o x.png", 2, "superframe: s:"},
    {"echo '@include \"/etc/passwd\"' > s; superframe render s -o x.png", 2, "superframe: s:1:"},
    {"superframe render fig3 --depth 256 -o x.png", 2, "superframe: --depth: \"256\""},
    {"superframe render fig3 --bus usb -o x.png", 2, "superframe: --bus usb: not built"},
    {"superframe render fig3 --rows 0:300 -o x.png", 2, "superframe: --rows 0:300"},
    {"superframe render fig3 -o - --stats -", 2, "superframe: two results"},
    {"superframe render " TINY "-o no/x.png", 1,
     "superframe: no/x.png: cannot be written: No such"},
    {"superframe render " TINY "-o .", 1, "superframe: .: cannot be written: Is a directory"},
    {"superframe render " TINY "-o /dev/full", 1, "/dev/full: cannot be written: No space left"},
    {"superframe render " TINY "-o x.png --stats no/s", 1, "superframe: no/s: cannot be written"},
    {"superframe render " TINY "-o x.png --trace /dev/full", 1, "No space left"},
    {"superframe render " TINY "--bus trace:/dev/full", 1, "No space left"},
    {"superframe render " TINY "-o - > /dev/full", 1, "No space left"},
    {"superframe render " TINY "-o - >&-", 1, "superframe: "},
    {"superframe render " TINY "--stats - -o /dev/null > /dev/full", 1, "standard output"},
    {"superframe scenes > /dev/full", 1,
     "superframe: standard output: cannot be written: No space"},
    {"superframe check fig3 > /dev/full", 1, "superframe: standard output"},
    {"superframe compile fig3 -o /dev/full", 1, "superframe: /dev/full"},
    {"ulimit -f 1; superframe render " TINY "-o x.png", 1, "x.png: cannot be written: File too"},
    {"(superframe render " TINY "-o -; echo $? > status) | exec 0<&-; sleep 2; exit $(cat status)",
     1, "superframe: standard output: cannot be written: Broken pipe"},
    {"superframe replay nothing -o x.png", 2, "superframe: nothing: cannot be read"},
    {"superframe replay /dev/null -o x.png", 2, "superframe: /dev/null"},
    {"echo out9 00D0 00 > t; superframe replay t -o x.png", 2, "superframe: t:1: "},
    {"superframe render " TINY "--bus trace:t && head -c 100 t > u; superframe replay u -o x.png",
     2, "superframe: u: byte"},
    {"superframe render " TINY "--bus trace:t --base 02D0 && superframe replay t -o x.png", 2,
     "superframe: t: byte"},
    {"superframe compare nothing nothing", 2, "superframe: nothing: cannot be read: No such file"},
    {"echo text > p; superframe compare p p", 2, "superframe: p: "},
    {"superframe check nothing", 2, "superframe: nothing"},
    {"superframe compile nothing -o x.png", 2, "superframe: nothing"},
};

static void wrong_input(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        assert_status(wrong[i].line, wrong[i].status);
        const char *message = text_of("err");
        if (strstr(message, wrong[i].fragment) == NULL) {
            fail_msg("\"%s\": \"%s\" lacks \"%s\"", wrong[i].line, message, wrong[i].fragment);
        }
        if (leftovers() > 0 || is_there("x.png")) {
            fail_msg("\"%s\" left a file", wrong[i].line);
        }
    }
}

static void a_failed_render_leaves_the_old_picture(void **state) {
    (void)state;
    assert_status("echo old > x.png; ulimit -f 1; superframe render " TINY "-o x.png", 1);
    assert_string_equal(text_of("x.png"), "old\n");
    assert_int_equal(leftovers(), 0);
}

/* ---- Right input ---------------------------------------------------------------------------- */

static void help_and_version(void **state) {
    (void)state;
    assert_status("superframe --version", 0);
    assert_memory_equal(text_of("out"), "superframe ", 11);
    assert_status("superframe --help", 0);
    assert_non_null(strstr(text_of("out"), "\n  render "));
    assert_status("for c in render scenes check compile replay compare; do "
                  "superframe $c --help | grep -q '^usage: superframe '$c || exit 9; done",
                  0);
    assert_string_equal(text_of("err"), "");
}

static void scenes_are_a_name_a_tab_and_a_sentence(void **state) {
    (void)state;
    assert_status("superframe scenes", 0);
    assert_non_null(strstr(text_of("out"), "fig3\t"));
    assert_status("superframe scenes | grep -v '^[a-zA-Z0-9-]*\t[^\t]*$'", 1);
    assert_status("superframe scenes | cut -f 1 | while read s; do "
                  "superframe check $s || exit 9; done",
                  0);
}

static void the_picture_is_named_after_the_scene(void **state) {
    (void)state;
    assert_status("superframe render " TINY, 0);
    assert_string_equal(text_of("err"), ""); /* no bar: not a terminal */
    assert_true(is_there("fig3.png"));
    assert_status("superframe render " TINY "-o - | cmp - fig3.png", 0);
    assert_status("superframe render " TINY "--bus trace:fig3.trace && rm fig3.png && "
                  "superframe replay fig3.trace -o again.png && ls fig3.png",
                  2);
}

static void stats_have_every_key(void **state) {
    (void)state;
    static const char *const keys[] = {
        "scene",       "arith",       "depth",          "threshold",    "width",
        "height",      "pixels",      "nodes",          "rays",         "shadow_rays",
        "solid_tests", "leaked_rays", "port_writes",    "port_reads",   "trace_hash",
        "frame_crc",   "violations",  "render_seconds", "total_seconds"};
    assert_status("superframe render " TINY "--stats -", 0);
    const char *stats = text_of("out");
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        char key[64];
        (void)snprintf(key, sizeof key, "\n  \"%s\": ", keys[i]);
        if (strstr(stats, key) == NULL) {
            fail_msg("no %s in %s", keys[i], stats);
        }
    }
    assert_non_null(strstr(stats, "\"scene\": \"fig3\","));
    assert_non_null(strstr(stats, "\"arith\": \"fx\","));
    assert_non_null(strstr(stats, "\"depth\": 2,"));
    assert_non_null(strstr(stats, "\"pixels\": 160,"));
    assert_non_null(strstr(stats, "\"leaked_rays\": 0,"));
    assert_non_null(strstr(stats, "\"violations\": 0,"));
}

/* Lines of the statistics that must be the same however the picture came to be. */
#define SAME "| grep -e trace_hash -e frame_crc -e '\"rays' -e port_writes"

static void jobs_do_not_show(void **state) {
    (void)state;
    assert_status("superframe render fig3 --size 60x37 --stats - -o 1.png --trace 1.trace " SAME
                  "> one && for j in 2 3 7 64; do "
                  "superframe render fig3 --size 60x37 --stats - -o $j.png --trace $j.trace "
                  "--jobs $j " SAME " | cmp - one && cmp 1.png $j.png && cmp 1.trace $j.trace "
                  "|| exit 9; done",
                  0);
}

static void traces_replay_to_the_same_picture(void **state) {
    (void)state;
    assert_status("superframe render fig3 --size 60x37 -o a.png --trace a.trace", 0);
    assert_status("superframe replay a.trace -o b.png --strict && cmp a.png b.png", 0);
    assert_status("superframe render fig3 --size 60x37 --bus trace:a.txt && "
                  "superframe replay - -o - < a.txt | cmp - a.png",
                  0);
    assert_status("superframe render fig3 --size 60x37 --bus trace:1 --rows 0:20 && "
                  "superframe render fig3 --size 60x37 --bus trace:2 --rows 20:37 --jobs 2 && "
                  "superframe replay 1 2 -o c.png && cmp a.png c.png",
                  0);
    assert_status("superframe replay a.trace --stats - | grep -c frame_crc", 0);
}

static void a_fifo_gets_the_picture(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png; mkfifo f; cat f > b.png & "
                  "superframe render " TINY "-o f && wait && cmp a.png b.png && test -p f",
                  0);
}

static void strict_checks(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png --strict", 0);
    assert_status("superframe render " TINY "-o a.png --strict=P", 3);
    assert_true(is_there("a.png"));
    assert_status("echo out8 00D9 00 > t; superframe replay t --strict", 3);
    assert_non_null(strstr(text_of("err"), "superframe: violation: "));
}

static void comparisons(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png; superframe compare a.png a.png --share 100 "
                  "--within 0",
                  0);
    assert_non_null(strstr(text_of("out"), "largest error       0 LSB"));
    assert_status("superframe render fig3 --size 20x10 --depth 2 -o b.png; "
                  "superframe compare a.png b.png",
                  3);
    assert_non_null(strstr(text_of("err"), "asked for are 99.9 %"));
    assert_status("superframe compare a.png b.png --within 255 --share 100", 0);
    assert_status("superframe compare a.png b.png --json", 3);
    assert_non_null(strstr(text_of("out"), "\"holds\": false"));
    assert_status("printf '\\211PNG\\r\\n\\032\\n' > c.png; superframe compare a.png c.png", 2);
}

static void compiling(void **state) {
    (void)state;
    assert_status(
        "superframe compile fig3 -o fig3.c && superframe compile fig3 -o - | cmp - fig3.c", 0);
    assert_non_null(strstr(text_of("fig3.c"), "scene_fig3"));
}

/* The program with closed standard streams does not write its messages into its results. */
static void closed_streams(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png && "
                  "superframe render " TINY "-o b.png <&- >&- 2>&- && cmp a.png b.png",
                  0);
}

static void an_interrupt_ends_cleanly(void **state) {
    (void)state;
    assert_status(
        "timeout --foreground --preserve-status -s INT 3 superframe render fig3 --arith f128 "
        "--size 640x400 --jobs 2 -o a.png --trace a.trace --stats s",
        130);
    assert_non_null(strstr(text_of("err"), "superframe: interrupted after "));
    assert_status("superframe replay a.trace -o b.png && cmp a.png b.png", 0);
    assert_non_null(strstr(text_of("s"), "\"frame_crc\": "));
    assert_int_equal(leftovers(), 0);
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(wrong_input),
        TEST(a_failed_render_leaves_the_old_picture),
        TEST(help_and_version),
        TEST(scenes_are_a_name_a_tab_and_a_sentence),
        TEST(the_picture_is_named_after_the_scene),
        TEST(stats_have_every_key),
        TEST(jobs_do_not_show),
        TEST(traces_replay_to_the_same_picture),
        TEST(a_fifo_gets_the_picture),
        TEST(strict_checks),
        TEST(comparisons),
        TEST(compiling),
        TEST(closed_streams),
        TEST(an_interrupt_ends_cleanly),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
