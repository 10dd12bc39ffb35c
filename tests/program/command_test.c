/* SPDX-License-Identifier: MIT */
/* The program as its users call it: exit status, messages, results, and nothing half-written. */
#include "command_fixture.h"

/* A small scene that renders at once. */
#define TINY "fig3 --size 16x10 --depth 2 "

/* ---- Wrong input ---------------------------------------------------------------------------- */

/* A ball that fixed point can't hold. */
#define SMALL_BALL                                                                                 \
    "echo 'version = 1; size = [4, 4]; camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"     \
    "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\n"                               \
    "objects = ( { material = \"glass\"; solid = { box = { min = (-8, -8, -8);\n"                  \
    "max = (8, 8, 8); }; }; },\n"                                                                  \
    "{ material = \"glass\"; solid = { ball = { radius = 1e-9; }; }; } );' > s; "

/* Each line ends with its status and a message, and writes no x.png. */
static const struct {
    const char *line;
    int status;
    const char *fragment;
} wrong[] = {
    {"superframe", 2, "superframe: a command is missing"},
    {"superframe rendre fig3", 2, "superframe: no command \"rendre\""},
    {"superframe export fig3 -o x", 2, "superframe: export: --pov is missing"},
    {"superframe export fig3 --pov", 2, "superframe: export: -o FILE is missing"},
    {"superframe export fig3 --pov --model wavelength -o x.png", 2, "superframe: fig3: model wave"},
    {"superframe export fig3 --pov -o no/x.png", 1, "superframe: no/x.png: cannot be written"},
    {"superframe measure", 2, "superframe: measure: -o FOLDER is missing"},
    {"superframe paper", 2, "superframe: paper: -o FOLDER is missing"},
    {"superframe render fig4a --colour dither -o x.png", 2, "superframe: fig4a: colour \"dither\""},
    {"superframe render " TINY "--keep-exposures e -o x.png", 2, "superframe: --keep-exposures"},
    {"superframe render " TINY "--colour exposures --keep-exposures no/e -o x.png", 1,
     "superframe: no/e: cannot be made: No such"},
    {"echo > e; superframe render " TINY "--colour exposures --keep-exposures e -o x.png", 1,
     "superframe: e/exposure-0.png: cannot be written: Not a directory"},
    {"superframe adapter --listen nowhere", 2, "superframe: --listen nowhere"},
    {"superframe boot x", 2, "superframe: x: cannot be read: No such file"},
    {"echo > i; superframe boot i -o x.png", 2, "superframe: i: no 2HD image: less than 1261568"},
    {"superframe compare a", 2, "superframe: compare: B.png is missing"},
    {"superframe render nothing -o x.png", 2, "superframe: nothing: cannot be read: No such file"},
    {"superframe render . -o x.png", 2, "superframe: .: is a folder"},
    {"superframe render /dev/null -o x.png", 2, "superframe: /dev/null"},
    {"superframe render /dev/zero -o x.png", 2, "superframe: /dev/zero"},
    {"echo 'title = ' > s; superframe render s -o x.png", 2, "superframe: s:"},
    {"echo '@include \"/etc/passwd\"' > s; superframe render s -o x.png", 2, "superframe: s:1:"},
    {"superframe render fig3 --depth 256 -o x.png", 2, "superframe: --depth: \"256\""},
    {"superframe render fig3 --bus usb -o x.png", 2, "superframe: --output goes with --bus"},
    {"superframe render fig3 --rows 0:300 -o x.png", 2, "superframe: --rows 0:300"},
    {"superframe render fig3 -o - --stats -", 2, "superframe: two results"},
    {"superframe render fig3 -o - --stats /dev/stdout", 2, "superframe: two results"},
    {"superframe render fig3 --stats - > fig3.png", 2, "superframe: two results"},
    {"superframe render fig3 -o - --stats /dev/stdout | cat > x.png; test ! -s x.png && rm x.png",
     0, "superframe: two results"},
    {"echo > s; superframe render s -o s", 2, "superframe: s: -o would overwrite"},
    {"superframe compare a b --difference -", 2, "superframe: two results"},
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
     1, ""},
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
    {SMALL_BALL "superframe check s", 2, "superframe: s:5: a ball smaller than"},
    {SMALL_BALL "superframe check s", 2, "(--arith fx)\n"},
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
    assert_status("superframe render " TINY "-o x.png && cp x.png old.png; ulimit -f 1; "
                  "superframe render fig4a --size 16x10 -o x.png",
                  1);
    assert_status("cmp x.png old.png", 0);
    assert_int_equal(leftovers(), 0);
}

/* ---- Right input ---------------------------------------------------------------------------- */

static void help_and_version(void **state) {
    (void)state;
    assert_status("superframe --version", 0);
    assert_memory_equal(text_of("out"), "superframe ", 11);
    assert_status("superframe --help", 0);
    assert_non_null(strstr(text_of("out"), "\n  render "));
    assert_status("for c in render scenes check compile replay compare trace; do "
                  "superframe $c --help | grep '^usage: superframe '$c > usage || exit 9; done",
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

/* The number of a key of the statistics. */
static double number_of(const char *stats, const char *key) {
    char start[64];
    (void)snprintf(start, sizeof start, "\n  \"%s\": ", key);
    const char *found = strstr(stats, start);
    assert_non_null(found);
    return strtod(found + strlen(start), NULL);
}

static void the_first_port_is_written_between_start_and_end(void **state) {
    (void)state;
    assert_status("superframe render " TINY "--stats -", 0);
    const char *stats = text_of("out");
    assert_true(number_of(stats, "first_write_seconds") > 0);
    assert_true(number_of(stats, "first_write_seconds") < number_of(stats, "total_seconds"));
    assert_true(number_of(stats, "first_write_cpu_seconds") > 0);
    assert_true(number_of(stats, "first_write_cpu_seconds") < 60);
    /* A replay has no start that would count. */
    assert_status("superframe render " TINY "--bus trace:a.trace && superframe replay a.trace "
                  "-o a.png --stats -",
                  0);
    assert_null(strstr(text_of("out"), "first_write"));
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

static void signatures_go_with_an_accuracy(void **state) {
    (void)state;
    assert_status("for i in 1 2 3; do superframe render " TINY
                  "--error 2 --jobs $i --signatures s$i -o $i.png || exit; done;"
                  " cmp s1 s2 && cmp s1 s3 && test -s s1 && cmp 1.png 3.png",
                  0);
    assert_int_equal(leftovers(), 0);
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

/* Writes a scene of plates, between which light goes to and fro for longer than the budget of one
 * pixel lasts. */
static void write_plates(void) {
    FILE *file = fopen("plates", "w");
    assert_non_null(file);
    fprintf(file,
            "version = 1; size = [2, 1]; background = [255, 200, 90];\n"
            "camera = { eye = (0.3, -1, 0.2); look_at = (0.35, 0, 0.22); field_of_view = 20; };\n"
            "materials = { glass = { colour = [0, 0, 0]; ambient = 1.0; ambient_is_own = true;\n"
            "  ior = 2.4; pattern = { size = (0.3, 0, 0.3); colour = [9, 6, 3]; }; }; };\n"
            "objects = (");
    for (int i = 0; i < 8; i++) {
        fprintf(file,
                "%s { material = \"glass\"; solid = { box = { min = (-9, %d, -9);"
                " max = (9, %d.1, 9); }; }; }",
                i > 0 ? ",\n" : "", i, i);
    }
    fprintf(file, " );\n");
    assert_int_equal(fclose(file), 0);
}

/* The line is one, names how many there are, and where the worst is. */
static void an_accuracy_that_is_not_reached_is_told_of(void **state) {
    (void)state;
    write_plates();
    assert_status("superframe render plates --error 0.1 --depth 255 -o a.png --stats s", 0);
    const char *told = strstr(text_of("err"), "superframe: plates: ");
    assert_non_null(told);
    assert_non_null(strstr(told, " of 2 pixels did not reach --error 0.1; the worst is "));
    assert_ptr_equal(strchr(told, '\n'), told + strlen(told) - 1);
    assert_null(strstr(text_of("s"), "\"unreached_pixels\": 0,"));
    assert_true(is_there("a.png"));
    assert_status("superframe render plates --error 0.1 --depth 255 -o b.png --strict --arith f32",
                  3);
    assert_non_null(strstr(text_of("err"), "did not reach"));
    assert_true(is_there("b.png"));
}

static void an_accuracy_that_is_reached_is_not_told_of(void **state) {
    (void)state;
    static const char *const options[] = {"--error 0.1 --depth 0", "--error 0.1 --depth 1",
                                          "--error 0.01 --depth 3", "--error 255 --depth 255",
                                          "--threshold 0.01 --depth 255"};
    write_plates();
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        char line[200];
        (void)snprintf(line, sizeof line, "superframe render plates %s -o a.png --strict --stats s",
                       options[i]);
        assert_status(line, 0);
        assert_string_equal(text_of("err"), "");
        assert_true(strstr(options[i], "threshold") != NULL ||
                    strstr(text_of("s"), "\"unreached_pixels\": 0,") != NULL);
    }
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

static void names_are_quoted_in_a_graph(void **state) {
    (void)state;
    assert_status(
        "cat > s << 'END'\n"
        "version = 1; size = [16, 10]; camera = { eye = (0, -6, 1); look_at = (0, 0, 0); };\n"
        "materials = { glass = { colour = [90, 40, 20]; ior = 1.5; }; };\n"
        "objects = ( { name = \"a\\\"b\\\\c\"; material = \"glass\";\n"
        "              solid = { ball = { radius = 1; }; }; } );\n"
        "END\n"
        "superframe tree s 8 5 --dot",
        0);
    assert_non_null(strstr(text_of("out"), "tooltip=\"air -> a\\\"b\\\\c\"];"));
}

/* The program with closed standard streams does not write its messages into its results. */
static void closed_streams(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png && "
                  "superframe render " TINY "-o b.png <&- >&- 2>&- && cmp a.png b.png",
                  0);
}

static void an_interrupt_ends_cleanly_and_leaves_the_finished_picture(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o whole.png && cp whole.png a.png", 0);
    assert_status(
        "timeout --foreground --preserve-status -s INT 3 superframe render fig3 --arith f128 "
        "--size 640x400 --jobs 2 -o a.png --trace a.trace --stats s",
        130);
    assert_non_null(strstr(text_of("err"), "superframe: interrupted after "));
    assert_non_null(strstr(text_of("err"), "what was drawn is in a.partial.png"));
    assert_status("superframe replay a.trace -o b.png && cmp a.partial.png b.png", 0);
    assert_status("cmp a.png whole.png", 0);
    assert_non_null(strstr(text_of("s"), "\"frame_crc\": "));
    assert_int_equal(leftovers(), 0);
}

/* Whatever ends the program: it is at work on a trace that goes on, or on a long picture. */
static void nothing_half_written_is_left_by_a_signal(void **state) {
    (void)state;
    static const struct {
        const char *line;
        int status;
    } lines[] = {
        {"mkfifo f; sleep 3 > f & timeout --foreground --preserve-status -s INT 1 "
         "superframe replay f -o a.png",
         130},
        {"sleep 3 > f & timeout --foreground --preserve-status -s TERM 1 "
         "superframe trace f --to text -o a.txt",
         143},
        {"timeout --foreground --preserve-status -s HUP 2 superframe render fig3 --arith f128 "
         "--size 640x400 -o b.png",
         129},
        {"timeout --foreground --preserve-status -s QUIT 2 superframe render fig3 --arith f128 "
         "--size 640x400 -o b.png",
         131},
    };
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_status(lines[i].line, lines[i].status);
        assert_int_equal(leftovers(), 0);
    }
    assert_false(is_there("a.png") || is_there("a.txt"));
    assert_true(is_there("b.partial.png") && !is_there("b.png"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(wrong_input),
        TEST(a_failed_render_leaves_the_old_picture),
        TEST(help_and_version),
        TEST(scenes_are_a_name_a_tab_and_a_sentence),
        TEST(the_picture_is_named_after_the_scene),
        TEST(the_first_port_is_written_between_start_and_end),
        TEST(stats_have_every_key),
        TEST(jobs_do_not_show),
        TEST(signatures_go_with_an_accuracy),
        TEST(traces_replay_to_the_same_picture),
        TEST(a_fifo_gets_the_picture),
        TEST(strict_checks),
        TEST(an_accuracy_that_is_not_reached_is_told_of),
        TEST(an_accuracy_that_is_reached_is_not_told_of),
        TEST(comparisons),
        TEST(compiling),
        TEST(names_are_quoted_in_a_graph),
        TEST(closed_streams),
        TEST(an_interrupt_ends_cleanly_and_leaves_the_finished_picture),
        TEST(nothing_half_written_is_left_by_a_signal),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
