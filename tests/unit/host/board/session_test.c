/* SPDX-License-Identifier: MIT */
/* Sessions with a board: results that appear when they are committed, devices in the board's place,
 * the verdict. */
#include <fcntl.h>
#include <sys/stat.h>

#include "base/complain.h"
#include "base/stopwatch.h"
#include "board/session.h"
#include "fault_bus.h"
#include "folder_fixture.h"
#include "null_bus.h"
#include "outp.h"
#include "png_file.h"

static const struct session_files all_files = {"p.png", "t.trace", "s.json"};

/* Begins a session with a board, as the command line without options would have it. */
static void begin(struct session *session, struct board_options *options) {
    memset(session, 0, sizeof *session);
    options->base = BOARD_FACTORY_BASE;
    session->began = stopwatch_start();
    assert_int_equal(session_begin(session, options, NULL), STATUS_DONE);
}

/* Writes one pixel of the frame memory, 7 to the right and 3 down. */
static void put_pixel(uint8_t red, uint8_t green, uint8_t blue) {
    outpw(0x00D4, 7);
    outpw(0x00D6, 3);
    outp(0x00D8, red);
    outp(0x00DA, green);
    outp(0x00DC, blue);
}

/* Reads a PNG's pixel, 7 to the right and 3 down, and checks the height. */
static void assert_pixel(const char *path, unsigned height, uint8_t red, uint8_t green,
                         uint8_t blue) {
    const uint8_t expected[3] = {red, green, blue};
    struct png_image image;
    struct png_error error;
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(read_png(file, &image, &error), PNG_OK);
    (void)fclose(file);
    assert_int_equal(image.width, 640);
    assert_int_equal(image.height, height);
    assert_memory_equal(image.rgb + (3 * 640 + 7) * 3, expected, 3);
    free_png(&image);
}

/* ---- Results -------------------------------------------------------------------------------- */

static void results_appear_when_they_are_committed(void **state) {
    (void)state;
    struct board_options options = {.picture = PICTURE_KIND_MEMORY};
    struct session session;
    begin(&session, &options);
    assert_int_equal(session_open(&session, &all_files), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    for (int i = 0; i < 3; i++) {
        static const char *const names[] = {"p.png", "t.trace", "s.json"};
        assert_int_equal(access(names[i], F_OK), -1);
    }
    assert_int_equal(session_end_accesses(&session), STATUS_DONE);
    assert_int_equal(access("t.trace", F_OK), 0);
    assert_int_equal(access("p.png", F_OK), -1);
    assert_true(session_commit_picture(&session));
    session_free(&session);
    assert_pixel("p.png", 400, 1, 2, 3);
    assert_int_equal(access("s.json", F_OK), -1); /* never committed */
    assert_int_equal(count_files(false), 2);
}

static void what_is_given_up_leaves_what_was_there(void **state) {
    (void)state;
    struct board_options options = {.strict = false};
    struct session session;
    put("p.png", "old picture");
    put("t.trace", "old trace");
    put("s.json", "old statistics");
    begin(&session, &options);
    assert_int_equal(session_open(&session, &all_files), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    session_free(&session);
    assert_holds("p.png", "old picture");
    assert_holds("t.trace", "old trace");
    assert_holds("s.json", "old statistics");
    assert_int_equal(count_files(false), 3);
}

static void a_name_that_cannot_be_written_is_known_before_any_access(void **state) {
    (void)state;
    static const struct session_files bad[] = {{"no/p.png", "t.trace", "s.json"},
                                               {"p.png", "no/t.trace", "s.json"},
                                               {"p.png", "t.trace", "no/s.json"}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct board_options options = {.strict = false};
        struct session session;
        begin(&session, &options);
        assert_int_equal(session_open(&session, &bad[i]), STATUS_FAILED);
        session_free(&session);
        assert_int_equal(count_files(false), 0);
    }
}

static void nothing_is_written_that_was_not_asked_for(void **state) {
    (void)state;
    const struct session_files none = {NULL, NULL, NULL};
    struct board_options options = {.strict = false};
    struct session session;
    begin(&session, &options);
    assert_int_equal(session_open(&session, &none), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    assert_int_equal(session_end_accesses(&session), STATUS_DONE);
    assert_true(session_commit_picture(&session));
    assert_int_equal(port_chain_writes(session.chain), 0); /* unobserved: nobody counted */
    session_free(&session);
    assert_int_equal(count_files(false), 0);
}

static void writes_are_counted_and_timed_where_statistics_are_asked_for(void **state) {
    (void)state;
    const struct session_files files = {.stats = "s.json"};
    struct board_options options = {.strict = false};
    struct session session;
    begin(&session, &options);
    assert_int_equal(session_open(&session, &files), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    assert_int_equal(inp(0x00D8), 1);
    assert_int_equal(port_chain_writes(session.chain), 5);
    assert_int_equal(port_chain_reads(session.chain), 1);
    assert_true(session.chain->first.has_happened);
    assert_true(stopwatch_between(&session.began, &session.chain->first.at) >= 0);
    session_free(&session);
}

static void each_kind_of_picture_is_what_it_says(void **state) {
    (void)state;
    static const struct {
        enum picture_kind kind;
        unsigned height;
        uint8_t blue;
    } kinds[] = {{PICTURE_KIND_SCREEN, 400, 0}, /* not set up: black */
                 {PICTURE_KIND_MEMORY, 400, 30},
                 {PICTURE_KIND_WHOLE, 416, 30}};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const struct session_files files = {.picture = "p.png"};
        struct board_options options = {.picture = kinds[i].kind};
        struct session session;
        begin(&session, &options);
        assert_int_equal(session_open(&session, &files), STATUS_DONE);
        (void)bus_bind(session_bus(&session));
        put_pixel(0, 0, 30);
        assert_true(session_commit_picture(&session));
        session_free(&session);
        assert_pixel("p.png", kinds[i].height, 0, 0, kinds[i].blue);
    }
}

/* ---- What goes in --------------------------------------------------------------------------- */

static void a_screen_of_the_pc_that_cannot_be_read_is_bad_input(void **state) {
    (void)state;
    struct board_options options = {.native = "native.png"};
    struct session session;
    put("native.png", "no PNG");
    begin(&session, &options);
    assert_int_equal(session_open(&session, &all_files), STATUS_BAD_INPUT);
    session_free(&session);
    assert_int_equal(count_files(false), 1);
}

static void faults_come_between_the_recorder_and_the_board(void **state) {
    (void)state;
    const struct session_files files = {.trace = "t.txt"};
    struct board_options options = {.has_faults = true, .faults = {.lose_one_in = 1}};
    struct session session;
    begin(&session, &options);
    assert_int_equal(session_open(&session, &files), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    outp(0x00D8, 0x5A);
    assert_int_equal(session.chain->board.accesses, 0); /* lost on the way */
    assert_int_equal(session_end_accesses(&session), STATUS_DONE);
    session_free(&session);
    assert_holds("t.txt", "# profile 1987, base 00D0\nout8 00D8 5A\n"); /* recorded before */
}

/* The trace has as many accesses as it may, and the board gets all of them. */
static void a_limited_trace_ends_and_the_session_goes_on(void **state) {
    (void)state;
    static const struct {
        uint64_t most;
        const char *trace;
    } cases[] = {
        {1, "# profile 1987, base 00D0\nout8 00D8 5A\n"},
        {2, "# profile 1987, base 00D0\nout8 00D8 5A\nin8 00D8 5A\n"},
        {3, "# profile 1987, base 00D0\nout8 00D8 5A\nin8 00D8 5A\n"},
    };
    const struct session_files files = {.trace = "t.txt"};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct board_options options = {.picture = PICTURE_KIND_MEMORY};
        struct session session;
        begin(&session, &options);
        assert_int_equal(session_open(&session, &files), STATUS_DONE);
        session_limit_trace(&session, cases[i].most);
        (void)bus_bind(session_bus(&session));
        outp(0x00D8, 0x5A);
        assert_int_equal(inp(0x00D8), 0x5A);
        if (cases[i].most < 3) {
            outp(0x00D8, 0xA5);
            assert_int_equal(inp(0x00D8), 0xA5);
        }
        assert_int_equal(session.chain->board.accesses, cases[i].most < 3 ? 4 : 2);
        assert_int_equal(session_end_accesses(&session), STATUS_DONE);
        session_free(&session);
        assert_holds("t.txt", cases[i].trace);
    }
}

/* ---- Devices -------------------------------------------------------------------------------- */

static void count_explanation(const void *context) {
    ++**(int *const *)context;
}

static void a_device_stands_in_the_boards_place_and_explains_its_failure(void **state) {
    (void)state;
    const struct session_files none = {NULL, NULL, NULL};
    const struct fault_plan gone = {.vanish_after = 1, .vanish_status = BUS_LOST};
    struct board_options options = {.base = BOARD_FACTORY_BASE};
    struct bus slot;
    struct fault_bus device;
    struct session session;
    int explained = 0;
    int *counter = &explained;
    null_bus_init(&slot);
    fault_bus_init(&device, &slot, &gone);
    const struct session_device end = {&device.bus, count_explanation, &counter};
    memset(&session, 0, sizeof session);
    assert_int_equal(session_begin(&session, &options, &end), STATUS_DONE);
    assert_int_equal(session_open(&session, &none), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    assert_int_equal(session.chain->board.accesses, 0);
    assert_int_equal(session_end_accesses(&session), STATUS_FAILED);
    assert_int_equal(explained, 1);
    session_free(&session);
}

static void a_full_disk_is_the_traces_failure_and_not_the_devices(void **state) {
    (void)state;
    const struct session_files files = {.trace = "/dev/full"};
    struct board_options options = {.base = BOARD_FACTORY_BASE};
    struct bus slot;
    struct session session;
    int explained = 0;
    int *counter = &explained;
    null_bus_init(&slot);
    const struct session_device end = {&slot, count_explanation, &counter};
    memset(&session, 0, sizeof session);
    assert_int_equal(session_begin(&session, &options, &end), STATUS_DONE);
    assert_int_equal(session_open(&session, &files), STATUS_DONE);
    (void)bus_bind(session_bus(&session));
    put_pixel(1, 2, 3);
    assert_int_equal(session_end_accesses(&session), STATUS_FAILED);
    assert_int_equal(explained, 0);
    session_free(&session);
}

/* ---- The verdict ---------------------------------------------------------------------------- */

static void only_a_strict_session_minds_a_violation(void **state) {
    (void)state;
    static const struct {
        bool strict, has_grade, violates;
        enum board_grade grade;
        int status;
    } cases[] = {{false, false, true, GRADE_PAPER, STATUS_DONE},
                 {true, false, false, GRADE_PAPER, STATUS_DONE},
                 {true, false, true, GRADE_PAPER, STATUS_NOT_HELD},
                 {true, true, false, GRADE_ASSUMED, STATUS_DONE},
                 {true, true, false, GRADE_PAPER, STATUS_NOT_HELD}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct session_files none = {NULL, NULL, NULL};
        struct board_options options = {.strict = cases[i].strict,
                                        .has_strict_grade = cases[i].has_grade,
                                        .strict_grade = cases[i].grade};
        struct session session;
        begin(&session, &options);
        assert_int_equal(session_open(&session, &none), STATUS_DONE);
        (void)bus_bind(session_bus(&session));
        put_pixel(1, 2, 3);
        if (cases[i].violates) {
            (void)inpw(0x00D8);
        }
        assert_int_equal(session_judge(&session), cases[i].status);
        session_free(&session);
    }
}

static void a_session_that_was_not_begun_can_be_freed(void **state) {
    (void)state;
    struct session session;
    memset(&session, 0, sizeof session);
    session_free(&session);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(results_appear_when_they_are_committed, enter, leave),
        cmocka_unit_test_setup_teardown(what_is_given_up_leaves_what_was_there, enter, leave),
        cmocka_unit_test_setup_teardown(a_name_that_cannot_be_written_is_known_before_any_access,
                                        enter, leave),
        cmocka_unit_test_setup_teardown(nothing_is_written_that_was_not_asked_for, enter, leave),
        cmocka_unit_test_setup_teardown(writes_are_counted_and_timed_where_statistics_are_asked_for,
                                        enter, leave),
        cmocka_unit_test_setup_teardown(each_kind_of_picture_is_what_it_says, enter, leave),
        cmocka_unit_test_setup_teardown(a_screen_of_the_pc_that_cannot_be_read_is_bad_input, enter,
                                        leave),
        cmocka_unit_test_setup_teardown(a_limited_trace_ends_and_the_session_goes_on, enter, leave),
        cmocka_unit_test_setup_teardown(faults_come_between_the_recorder_and_the_board, enter,
                                        leave),
        cmocka_unit_test(a_device_stands_in_the_boards_place_and_explains_its_failure),
        cmocka_unit_test(a_full_disk_is_the_traces_failure_and_not_the_devices),
        cmocka_unit_test(only_a_strict_session_minds_a_violation),
        cmocka_unit_test(a_session_that_was_not_begun_can_be_freed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
