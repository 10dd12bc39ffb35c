/* SPDX-License-Identifier: MIT */
/* superframe trace, and what replay and render do with the board: pictures, faults, cost. */
#include "command_fixture.h"
#include "unreadable_file.h"

#include <xxhash.h>

/* A small scene that renders at once. */
#define TINY "fig3 --size 16x10 --depth 2 "

/* Twelve accesses with three violations in 1987 (numbers 2, 8, 10) and a read that the board
 * answers otherwise (9), as the file d. */
#define DRIVER                                                                                     \
    "printf '%s\\n' 'out8 00EE C0' 'in16 00D0 0000' 'out8 00D0 0C' 'out8 00D2 FF' "                \
    "'out16 00D4 0123' 'out16 00D6 0005' 'out8 00D8 FF' 'out8 00D9 FF' 'in8 00D8 AA' "             \
    "'out16 00D8 0000' 'out8 00DE 01' 'in8 00DC 00' > d; "

/* The fifteen registers, then red at (0, 0) and mode 01, as the file i. */
#define INITIALISED                                                                                \
    "set -- 00=6B 01=50 02=5B 03=0E 04=1A 05=02 06=19 07=19 08=80 09=0F 0C=FF 0D=FF 1B=01 1E=8C "  \
    "1F=00; for p; do echo out8 D0 ${p%=*}; echo out8 D2 ${p#*=}; done > i; "                      \
    "echo 'out8 D8 FF' >> i; echo 'out8 DE 01' >> i; "

/* What the screen shows of it, as the file p.png. */
#define PNG_OF_SCREEN "superframe replay i -o p.png; "

static void assert_out(const char *fragment) {
    if (strstr(text_of("out"), fragment) == NULL) {
        fail_msg("\"%s\" is not in: %s", fragment, text_of("out"));
    }
}

static void assert_err(const char *fragment) {
    if (strstr(text_of("err"), fragment) == NULL) {
        fail_msg("\"%s\" is not in: %s", fragment, text_of("err"));
    }
}

/* ---- Telling -------------------------------------------------------------------------------- */

static void every_access_is_told_with_its_number(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d", 0);
    assert_out("        1  out8 00EE C0     not the board's\n");
    assert_out("        3  out8 00D0 0C     control 1: index 0C\n"
               "        4  out8 00D2 FF     control 2: register 0C = FF\n"
               "        5  out16 00D4 0123  X = 291\n"
               "        6  out16 00D6 0005  Y = 5\n"
               "        7  out8 00D8 FF     red of (291, 5) = FF\n"
               "        8  out8 00D9 FF     red, upper half: FF written\n"
               "           ! violation: a byte written at an odd port (grade A)\n");
    assert_out("           ? access 9: the board answers FF\n");
    assert_out("       11  out8 00DE 01     mode 01: both, superimposed\n");
    assert_err("superframe: d: 1 reads were answered otherwise than recorded");
    assert_status("superframe trace d --stop 2 --profile later", 0);
    assert_string_equal(text_of("out"), "        1  out8 00EE C0     not the board's\n"
                                        "        2  in16 00D0 0000   control 1 is 0000\n");
}

static void words_for_what_is_rare(void **state) {
    (void)state;
    assert_status("printf '%s\\n' 'out8 D4 5' 'out16 D5 1' 'in8 D5 FF' 'out16 D8 0' 'out8 DE 00' "
                  "'out8 DE 03' 'out8 DE 80' 'in16 DE FFFF' 'in16 D8 FF00' > t; "
                  "superframe trace t --profile later",
                  0);
    assert_out("X, low = 5\n");
    assert_out("X, across two registers: 0001 written\n");
    assert_out("X, upper half: FF read\n");
    assert_out("four pixels from (260, 0) = 00\n");
    assert_out("mode 00: the PC's screen only\n");
    assert_out("mode 03: the board's picture only\n");
    assert_out("mode 80: of unknown effect\n");
    assert_out("mode is FFFF\n");
    assert_out("red of (261, 0) is FF00\n");
}

static void violations_have_the_number_of_their_access(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d --violations", 0);
    assert_string_equal(
        text_of("out"),
        "access 2: in16 00D0 0000: violation: control 1 read, which is for writing (grade A)\n"
        "access 8: out8 00D9 FF: violation: a byte written at an odd port (grade A)\n"
        "access 9: the board answers FF\n"
        "access 10: out16 00D8 0000: violation: red written as a word: the fill of four pixels on "
        "later boards (grade A)\n"
        "3 violations in 12 accesses, profile 1987\n");
    assert_status("superframe trace d --violations --profile later --strict=D", 3);
    assert_out("access 4: out8 00D2 FF: relied on: control 2 written: the indexed register (grade "
               "D)\n");
    assert_err("superframe: violation: a byte written at an odd port (grade A): 1 times, first at "
               "access 8");
    assert_status("echo out16 D4 1 > t; superframe trace t --strict=D", 0);
    assert_status("superframe trace t --strict=P", 3);
}

static void statistics_count_and_say_what_it_costs(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d --statistics --frame-seconds 0.00002", 0);
    assert_out("00D8 red                    1            1            1            0\n"
               "00D9 red, odd               1            0            0            0\n"
               "00DA green                  0            0            0            0\n");
    assert_out("elsewhere                   1 of 12 accesses\n");
    assert_out("writes                                  9\n");
    assert_out("reads                                   3\n");
    assert_out("pixels touched twice or more            1\n"
               "pixels never touched               255999\n");
    /* Nine OUT and three IN: 96 clocks of a V30 at 10 MHz, 42 at 8, 138 at 16. */
    assert_out("VM2      V30     10.0     0.000010  48.0000 %\n");
    assert_out("VX2      80286    8.0     0.000005  26.2500 %\n");
    assert_out("RA2      80386   16.0     0.000009  43.1250 %\n");
    assert_status("superframe trace d --statistics --bus-wait 100000", 0);
    assert_out("VM2      V30     10.0     0.001210  not known");
    assert_status("superframe trace - --statistics < d", 0);
    assert_out("violations                              3\n");
}

static void the_board_is_stopped_and_its_picture_dumped(void **state) {
    (void)state;
    assert_status(INITIALISED "superframe trace i -o all.png && superframe trace i --stop 31 -o "
                              "early.png; superframe compare all.png early.png --within 0 --share "
                              "100",
                  3);
    assert_err("the pixels are within");
    /* The mode was still 00: the frame memory has the pixel, the screen not. */
    assert_status("superframe trace i --stop 31 -o m.png --picture memory && "
                  "superframe compare all.png m.png --within 0 --share 100",
                  0);
    assert_status("superframe trace i -o w.png --picture whole && superframe compare w.png m.png",
                  2);
    assert_err("640 x 416");
    assert_status("superframe replay i --stop 31 -o r.png --picture memory && cmp m.png r.png", 0);
    assert_status("superframe trace i --stop 999 -o x.png --quiet", 2);
    assert_status("superframe trace i --stop 999 -o x.png && cmp x.png all.png", 0);
    assert_err("the trace ends after access 32, before --stop 999");
    assert_status("superframe replay i i --stop 33 -o y.png && cmp y.png all.png", 0);
    assert_status("superframe replay i --stop 33 -o y.png", 0);
    assert_err("the traces end after access 32, before --stop 33");
    assert_status("superframe replay i i --stop 32 --stats - | grep 'port_writes\": 32'", 0);
}

/* ---- Two traces, and the other form --------------------------------------------------------- */

static void the_first_difference_is_shown_with_its_surroundings(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d --to binary -o b && superframe trace b --compare d",
                  0);
    assert_string_equal(text_of("out"), "the traces are equal: 12 accesses\n");
    assert_status("sed 7s/FF/FE/ d > e; superframe trace b --compare e", 3);
    assert_out("the traces differ first at access 7\n--- b\n+++ e\n"
               "         2  in16 00D0 0000\n");
    assert_out("-        7  out8 00D8 FF\n-        8  out8 00D9 FF\n");
    assert_out("+        7  out8 00D8 FE\n+        8  out8 00D9 FF\n");
    assert_status("head -n 7 d > e; superframe trace d --compare e", 3);
    assert_out("+           (the trace ends here)\n");
    assert_status("superframe trace - --compare d < b", 0);
    assert_status("superframe trace - --compare -", 2);
    assert_status("superframe trace d --compare nothing", 2);
    assert_status("echo nonsense >> e; superframe trace e --compare d", 2);
    assert_err("superframe: e:8: unknown operation");
}

static void a_trace_survives_both_forms(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d --to binary -o b --profile later --base 02D0 && "
                         "superframe trace b --to text -o c.txt && grep -v '^#' c.txt | cmp - d",
                  0);
    assert_status("head -n 1 c.txt | grep 'profile later, base 02D0'", 0);
    assert_status("superframe trace d --to binary -o - --profile later --base 02D0 | cmp - b", 0);
    assert_status("superframe trace b --to text | grep -v '^#' | cmp - d", 0);
    assert_status("superframe trace b --to text --stop 4 | grep -c out", 0);
    assert_string_equal(text_of("out"), "3\n");
    assert_status("superframe render " TINY "--trace a.trace -o a.png && "
                  "superframe trace a.trace --to text -o a.txt && "
                  "superframe trace a.txt --to binary -o b.trace && cmp a.trace b.trace",
                  0);
}

static void the_trace_of_a_frame_is_small(void **state) {
    (void)state;
    assert_status("superframe render fig3 --bus trace:t --quiet && "
                  "test $(wc -c < t) -le 1000000 && test $(gzip < t | wc -c) -le 100000",
                  0);
    assert_status("superframe trace t --statistics", 0);
    assert_out("pixels touched twice or more            0\n"
               "pixels never touched                    0\n"
               "violations                              0\n");
}

/* ---- The board of render and replay --------------------------------------------------------- */

static void the_pcs_own_screen_lies_over_the_boards(void **state) {
    (void)state;
    /* A native screen of the board's own making: red at (0, 0), the rest black. */
    assert_status(INITIALISED PNG_OF_SCREEN
                  "grep -v D8 i > black; superframe replay black -o b.png; "
                  "superframe replay black --native p.png -o over.png && cmp over.png p.png",
                  0);
    assert_status(
        "sed 's/DE 01/DE 03/' black > off; superframe replay off --native p.png -o x.png && "
        "cmp x.png b.png",
        0);
    assert_status("superframe trace black --native p.png -o y.png && cmp y.png p.png", 0);
    assert_status("superframe render " TINY "-o with.png --native p.png && "
                  "superframe render " TINY "-o without.png && cmp with.png without.png",
                  1);
    assert_status(
        "superframe replay black --native p.png --stats s1 && superframe replay i --stats "
        "s2 && grep frame_crc s1 > c1 && grep frame_crc s2 | cmp - c1",
        0);
}

static void faults_are_reproducible(void **state) {
    (void)state;
    assert_status("superframe render " TINY "--picture memory -o good.png --trace good.trace && "
                  "superframe render " TINY
                  "--picture memory -o 1.png --faults seed=1,lose=5 --trace 1.trace && "
                  "superframe render " TINY
                  "--picture memory -o 2.png --faults seed=1,lose=5 && cmp 1.png 2.png",
                  0);
    /* The trace has what the program wrote; played again with the faults it gives their picture. */
    assert_status(
        "cmp 1.trace good.trace && superframe replay 1.trace --picture memory -o 3.png --faults "
        "lose=5,seed=1 && cmp 3.png 1.png",
        0);
    assert_status("superframe replay 1.trace --picture memory -o 4.png --faults seed=2,lose=5 && "
                  "cmp 4.png 1.png",
                  1);
    assert_status("superframe replay good.trace --picture memory -o 5.png --faults flip=3 && cmp "
                  "5.png good.png",
                  1);
    assert_status("superframe replay good.trace --picture memory -o 6.png --faults dead=00D8 && "
                  "cmp 6.png good.png",
                  1);
    assert_status("superframe replay good.trace -o x.png --faults absent", 0);
    assert_err("the picture is black: the controller has not been initialised");
    assert_status("echo in8 D8 0 > t; superframe replay t --stats s --faults absent", 0);
    assert_err("1 reads were answered otherwise than recorded");
}

static void a_board_that_vanishes(void **state) {
    (void)state;
    assert_status("superframe render " TINY "-o a.png --faults vanish=100", 0);
    assert_status("superframe render " TINY "-o x.png --faults vanish=100,lost", 1);
    assert_err("superframe: the ports: the device went away");
    assert_false(is_there("x.png"));
    assert_status("superframe render " TINY "--bus trace:t; "
                  "superframe replay t -o x.png --faults vanish=100,lost",
                  1);
    assert_err("at access 101: the device went away");
    assert_false(is_there("x.png"));
    assert_int_equal(leftovers(), 0);
}

static void stats_tell_the_cost(void **state) {
    (void)state;
    assert_status(DRIVER "superframe replay d --stats - --frame-seconds 0.00002", 0);
    assert_out("\"port_reads\": 3,");
    assert_out("  \"port_cost\": {\n"
               "    \"VM2\": {\n"
               "      \"seconds\": 9.6e-06,\n"
               "      \"frame_seconds\": 2e-05,\n"
               "      \"frame_share\": 0.48\n"
               "    },\n"
               "    \"VX2\": {\n"
               "      \"seconds\": 5.25e-06,\n"
               "      \"frame_seconds\": 2e-05,\n"
               "      \"frame_share\": 0.2625\n"
               "    },\n"
               "    \"RA2\": {\n"
               "      \"seconds\": 8.625e-06,\n"
               "      \"frame_seconds\": 2e-05,\n"
               "      \"frame_share\": 0.43125\n"
               "    }\n"
               "  },\n");
    assert_status("superframe replay d --stats - --bus-wait 400", 0);
    assert_out("\"bus_wait_ns\": 400,");
    assert_out("\"seconds\": 1.44e-05,\n"
               "      \"frame_seconds\": null,\n"
               "      \"frame_share\": null\n");
}

/* A render's frame is predicted where the cost model has figures: for fixed point. */
static void a_render_knows_the_share_of_its_ports(void **state) {
    (void)state;
    assert_status("superframe render " TINY "--bus trace:t --stats -", 0);
    const char *vm2 = strstr(text_of("out"), "\"VM2\": {");
    double seconds = 0, frame = 0, share = 0;
    assert_non_null(vm2);
    assert_int_equal(sscanf(vm2,
                            "\"VM2\": { \"seconds\": %lf, \"frame_seconds\": %lf, "
                            "\"frame_share\": %lf}",
                            &seconds, &frame, &share),
                     3);
    assert_true(seconds > 0 && frame > seconds && share > 0 && share < 1);
    assert_true(share * frame > seconds * 0.999 && share * frame < seconds * 1.001);
    assert_status("superframe render " TINY "--bus trace:t --stats - --arith f64", 0);
    assert_out("\"frame_share\": null");
}

/* ---- Wrong input ---------------------------------------------------------------------------- */

/* Each line ends with its status and a message, and writes no x.png. */
static const struct {
    const char *line;
    int status;
    const char *fragment;
} wrong[] = {
    {"superframe trace nothing", 2, "superframe: nothing: cannot be read: No such file"},
    {"superframe trace .", 2, "superframe: .: byte 0: Is a directory"},
    {"superframe trace /dev/null", 2, "superframe: /dev/null: byte 0: the file is empty"},
    {"superframe trace d -o no/x.png", 1, "superframe: no/x.png: cannot be written: No such file"},
    {"superframe trace d -o /dev/full", 1, "superframe: /dev/full: cannot be written: No space"},
    {"superframe trace d --to text -o /dev/full", 1, "/dev/full: cannot be written: No space"},
    {"superframe trace d --to binary > /dev/full", 1,
     "standard output: cannot be written: No space"},
    {"superframe trace d > /dev/full", 1, "superframe: standard output: cannot be written"},
    {"echo out8 D8 100 > t; superframe trace t", 2,
     "superframe: t:1: bad value; allowed are 1 or 2"},
    {"printf 'out8 D8 1\\n\\nin8 D8\\n' > t; superframe trace t --statistics -o x.png", 2,
     "superframe: t:3: bad value"},
    {"echo out8 D8 1 2 > t; superframe trace t --to binary -o x.png", 2,
     "superframe: t:1: more than"},
    {"head -c 20 b > t; superframe trace t -o x.png", 2,
     "superframe: t: byte 20: the trace is truncated: the file ends in the header"},
    {"head -c 60 b > t; superframe trace t -o x.png", 2,
     "superframe: t: byte 60: the trace is trunc"},
    {"head -c -1 b > t; superframe trace t --to text -o x.png", 2, "the file ends in the trailer"},
    {"cp b t; printf X >> t; superframe trace t --statistics", 2, "bytes follow the end"},
    {"(head -c 40 b; printf '\\377'; tail -c +42 b) > t; superframe trace t", 2,
     "superframe: t: byte 24: the block is corrupt: its checksum is wrong"},
    {"(head -c 12 b; printf '\\320\\001'; tail -c +15 b) > t; superframe trace t", 2,
     "superframe: t: byte 0: the header is corrupt"},
    {"superframe trace b --profile later", 2,
     "superframe: b: byte 10: the trace was recorded for profile 1987, not later"},
    {"superframe trace b --base 02D0 --to text -o x.png", 2,
     "superframe: b: byte 12: the trace was recorded at base 00D0, not 02D0"},
    {"superframe replay b -o x.png --profile later", 2, "superframe: b: byte 10: "},
    {"superframe trace d --base 01D0", 2, "superframe: --base: \"01D0\" is invalid; allowed is:"},
    {"superframe replay d -o x.png --base 0ED0", 2, "superframe: --base: \"0ED0\" is invalid"},
    {"superframe trace d --native nothing -o x.png", 2, "superframe: nothing: cannot be read: No"},
    {"superframe trace d --native d -o x.png", 2, "superframe: d: "},
    {"superframe replay d --native w.png -o x.png", 2,
     "superframe: w.png: the picture has 640 x 416 pixels; allowed is: 640 x 400"},
    {"superframe render " TINY "--native colours.png -o x.png", 2,
     "superframe: colours.png: the pixel at x="},
    {"superframe render " TINY "--bus ports", 2, "say --yes-these-ports-are-mine"},
};

static void wrong_input(void **state) {
    (void)state;
    assert_status(DRIVER "superframe trace d --to binary -o b && "
                         "superframe trace d --picture whole -o w.png && "
                         "superframe render " TINY "-o colours.png",
                  0);
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

static void a_later_version_and_a_strange_base_are_named(void **state) {
    (void)state;
    /* Headers with right checksums, made by hand from docs/trace-format.md. */
    static const unsigned char later[24] = {0x89, 'S', 'F', 'T', 13,   10, 26, 10,
                                            2,    0,   0,   0,   0xD0, 0,  0,  0};
    unsigned char bytes[24];
    for (int i = 0; i < 2; i++) {
        memcpy(bytes, later, sizeof bytes);
        if (i == 1) {
            bytes[8] = 1;
            bytes[13] = 1; /* base 01D0 */
        }
        XXH64_hash_t checksum = XXH3_64bits(bytes, 16);
        for (int j = 0; j < 8; j++) {
            bytes[16 + j] = (unsigned char)(checksum >> (8 * j));
        }
        FILE *file = fopen(i == 0 ? "later" : "strange", "wb");
        assert_non_null(file);
        assert_int_equal(fwrite(bytes, 1, sizeof bytes, file), sizeof bytes);
        assert_int_equal(fclose(file), 0);
    }
    assert_status("superframe trace later", 2);
    assert_err(
        "superframe: later: byte 8: the trace has version 2 of the format; this program reads "
        "version 1");
    assert_status("superframe replay later -o x.png", 2);
    assert_status("superframe trace strange", 2);
    assert_err(
        "superframe: strange: byte 12: the trace's base is 01D0; the jumper offers 00D0, 02D0");
}

/* Nothing is opened where the kernel's list has another owner; as anyone but root nothing can be.
 */
static void own_ports_are_refused_on_a_pc(void **state) {
    (void)state;
    if (run("[ $(id -u) != 0 ] || grep -q dma2 /proc/ioports") != 0) {
        return; /* root on a machine without the controller: the ports would be opened in earnest */
    }
    int status = run("superframe render " TINY "--bus ports --yes-these-ports-are-mine --stats -");
    assert_true(status == 1 || status == 2);
    assert_err("superframe: --bus ports: ");
    assert_string_equal(text_of("out"), "");
}

/* A trace from a pipe that fails in the middle of its second line: no malformed line, but a failure
 * while working. */
static void a_read_that_fails_half_way_is_a_failure(void **state) {
    static const char *const lines[] = {"superframe trace - <&9", "superframe replay - -o x <&9",
                                        "superframe trace - --to binary -o x <&9",
                                        "echo out8 D8 FF > e; superframe trace - --compare e <&9"};
    static const char text[] = "out8 00D8 FF\nout8 00D8 F";
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        struct unreadable_file unreadable;
        assert_true(unreadable_file_open(&unreadable, text, sizeof text - 1));
        assert_int_equal(dup2(unreadable.reader, 9), 9);
        assert_status(lines[i], 1);
        assert_err("superframe: -: byte 24: Resource temporarily unavailable");
        assert_false(is_there("x"));
        close(9);
        close(unreadable.reader);
        close(unreadable.writer);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(every_access_is_told_with_its_number),
        TEST(words_for_what_is_rare),
        TEST(violations_have_the_number_of_their_access),
        TEST(statistics_count_and_say_what_it_costs),
        TEST(the_board_is_stopped_and_its_picture_dumped),
        TEST(the_first_difference_is_shown_with_its_surroundings),
        TEST(a_trace_survives_both_forms),
        TEST(the_trace_of_a_frame_is_small),
        TEST(the_pcs_own_screen_lies_over_the_boards),
        TEST(faults_are_reproducible),
        TEST(a_board_that_vanishes),
        TEST(stats_tell_the_cost),
        TEST(a_render_knows_the_share_of_its_ports),
        TEST(wrong_input),
        TEST(a_later_version_and_a_strange_base_are_named),
        TEST(own_ports_are_refused_on_a_pc),
        TEST(a_read_that_fails_half_way_is_a_failure),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
