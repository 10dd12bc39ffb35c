/* SPDX-License-Identifier: MIT */
/* What can be done with a trace: replay, statistics, comparison. */
#include "trace_fixture.h"

#include "fault_bus.h"
#include "trace_compare.h"
#include "trace_replay.h"
#include "trace_statistics.h"

static struct trace_reader reader, other_reader;

/* ---- Replay --------------------------------------------------------------------------------- */

static enum trace_status replay_text(const char *text, uint64_t stop_after,
                                     struct trace_replay *replay) {
    FILE *file = file_of_text(text);
    memset(replay, 0, sizeof *replay);
    power_on(BOARD_1987);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    enum trace_status status = trace_replay(&reader, &board_bus.bus, stop_after, replay);
    fclose(file);
    return status;
}

static void a_replay_does_to_the_board_what_the_run_did(void **state) {
    static struct trace_recorder recorder;
    static struct board original;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    struct trace_replay replay = {0};
    FILE *file = tmpfile();
    (void)state;
    assert_non_null(file);
    power_on(BOARD_1987);
    trace_recorder_init(&recorder, &board_bus.bus, file, TRACE_BINARY, &header);
    bus_bind(&recorder.bus);
    initialise();
    for (unsigned i = 0; i < 5000; i++) {
        put_pixel(i * 13 % 640, i * 7 % 400, i * 12345);
        get_here();
    }
    assert_int_equal(trace_recorder_finish(&recorder), BUS_OK);
    original = board;
    rewind(file);
    power_on(BOARD_1987);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_replay(&reader, &board_bus.bus, 0, &replay), TRACE_END);
    assert_int_equal(replay.accesses, original.accesses);
    assert_int_equal(replay.reads, 15000);
    assert_int_equal(replay.different_reads, 0);
    assert_int_equal(replay.first_different, 0);
    assert_memory_equal(board.memory, original.memory, sizeof board.memory);
    assert_memory_equal(board.writes, original.writes, sizeof board.writes);
    fclose(file);
}

static void a_different_answer_is_reported_and_does_not_stop(void **state) {
    struct trace_replay replay;
    (void)state;
    assert_int_equal(replay_text("out16 00D4 0001\n"
                                 "out8 00D8 55\n"
                                 "in8 00D8 55\n"
                                 "in8 00D8 AA # the board says 55\n"
                                 "in8 00DA 01 # the board says 00\n"
                                 "out8 00DA 77\n",
                                 0, &replay),
                     TRACE_END);
    assert_int_equal(replay.accesses, 6);
    assert_int_equal(replay.reads, 3);
    assert_int_equal(replay.different_reads, 2);
    assert_int_equal(replay.first_different, 4);
    assert_true(
        trace_access_equal(&replay.first_access, &(struct trace_access){0x00D8, 0xAA, 1, true}));
    assert_int_equal(replay.first_answer, 0x55);
    assert_int_equal(inp(0x00DA), 0x77);
}

static void a_replay_stops_after_access_k_and_goes_on_from_there(void **state) {
    struct trace_replay replay = {0};
    FILE *file = file_of_text("out8 00D8 01\nout8 00D8 02\nout8 00D8 03\n");
    (void)state;
    power_on(BOARD_1987);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_replay(&reader, &board_bus.bus, 2, &replay), TRACE_OK);
    assert_int_equal(replay.accesses, 2);
    assert_int_equal(inp(0x00D8), 0x02);
    assert_int_equal(trace_replay(&reader, &board_bus.bus, 2, &replay), TRACE_OK);
    assert_int_equal(replay.accesses, 2);
    assert_int_equal(trace_replay(&reader, &board_bus.bus, 9, &replay), TRACE_END);
    assert_int_equal(replay.accesses, 3);
    assert_int_equal(inp(0x00D8), 0x03);
    fclose(file);
}

static void a_bad_trace_ends_a_replay_with_what_came_before_it_done(void **state) {
    struct trace_replay replay;
    (void)state;
    assert_int_equal(replay_text("out8 00D8 42\nout8 00D8\n", 0, &replay), TRACE_BAD_LINE);
    assert_int_equal(replay.accesses, 1);
    assert_int_equal(inp(0x00D8), 0x42);
    assert_int_equal(reader.error.line, 2);
}

static void a_bus_that_fails_ends_a_replay_and_names_the_access(void **state) {
    const struct fault_plan plan = {.vanish_after = 2, .vanish_status = BUS_LOST};
    struct fault_bus faulty;
    struct trace_replay replay = {0};
    FILE *file = file_of_text("out8 00D8 1\nout8 00D8 2\nout8 00D8 3\nout8 00D8 4\n");
    (void)state;
    power_on(BOARD_1987);
    fault_bus_init(&faulty, &board_bus.bus, &plan);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_replay(&reader, &faulty.bus, 0, &replay), TRACE_BUS_FAILED);
    assert_int_equal(replay.accesses, 3);
    assert_non_null(strstr(reader.error.message, "access 3"));
    assert_int_equal(reader.error.line, 3);
    assert_int_equal(faulty.bus.status, BUS_LOST);
    fclose(file);
}

/* ---- Comparison ----------------------------------------------------------------------------- */

static enum trace_status compare_texts(const char *a, const char *b,
                                       struct trace_difference *difference) {
    FILE *files[2] = {file_of_text(a), file_of_text(b)};
    struct trace_reader *const readers[2] = {&reader, &other_reader};
    assert_int_equal(trace_reader_open(&reader, files[0]), TRACE_OK);
    assert_int_equal(trace_reader_open(&other_reader, files[1]), TRACE_OK);
    enum trace_status status = trace_compare(readers, difference);
    fclose(files[0]);
    fclose(files[1]);
    return status;
}

/* n lines, out8 00D8 with values from `first` on. */
static char *lines(char *text, unsigned n, unsigned first) {
    char *end = text;
    *end = '\0';
    for (unsigned i = 0; i < n; i++) {
        end += sprintf(end, "out8 00D8 %02X\n", (first + i) & 0xFF);
    }
    return text;
}

static void equal_traces_have_no_difference(void **state) {
    char a[2000], b[2000];
    struct trace_difference difference;
    (void)state;
    assert_int_equal(compare_texts(lines(a, 20, 0), lines(b, 20, 0), &difference), TRACE_OK);
    assert_false(difference.is_found);
    assert_int_equal(difference.access, 20);
    assert_int_equal(difference.failed, -1);
}

static void the_first_difference_is_shown_with_its_surroundings(void **state) {
    char a[2000], b[2000];
    struct trace_difference difference;
    (void)state;
    strcat(lines(a, 10, 0), "out8 00DA 10\nout8 00DA 11\nout8 00DA 12\n");
    strcat(lines(b, 10, 0), "in8 00DA 10\nout8 00DA 20\nout8 1 1\nout8 2 2\nout8 3 3\nout8 4 4\n"
                            "out8 5 5\nout8 6 6\n");
    assert_int_equal(compare_texts(a, b, &difference), TRACE_OK);
    assert_true(difference.is_found);
    assert_int_equal(difference.access, 11);
    assert_int_equal(difference.before_count, 5);
    for (unsigned i = 0; i < 5; i++) {
        assert_int_equal(difference.before[i].value, 5 + i);
    }
    assert_int_equal(difference.after_count[0], 3);
    assert_int_equal(difference.after[0][0].value, 0x10);
    assert_false(difference.after[0][0].is_read);
    assert_int_equal(difference.after[0][2].value, 0x12);
    assert_int_equal(difference.after_count[1], 6);
    assert_true(difference.after[1][0].is_read);
    assert_int_equal(difference.after[1][5].value, 4);
}

static void a_trace_that_ends_early_differs_at_its_end(void **state) {
    char a[2000], b[2000];
    struct trace_difference difference;
    (void)state;
    assert_int_equal(compare_texts(lines(a, 2, 0), lines(b, 3, 0), &difference), TRACE_OK);
    assert_true(difference.is_found);
    assert_int_equal(difference.access, 3);
    assert_int_equal(difference.before_count, 2);
    assert_int_equal(difference.after_count[0], 0);
    assert_int_equal(difference.after_count[1], 1);
}

static void a_trace_that_can_not_be_read_is_named(void **state) {
    char a[2000];
    struct trace_difference difference;
    (void)state;
    assert_int_equal(compare_texts(lines(a, 2, 0), "out8 00D8 00\nrubbish\n", &difference),
                     TRACE_BAD_LINE);
    assert_int_equal(difference.failed, 1);
    assert_int_equal(compare_texts("rubbish\n", a, &difference), TRACE_BAD_LINE);
    assert_int_equal(difference.failed, 0);
    assert_int_equal(compare_texts("out8 1 1\nrubbish\n", "out8 2 2\n", &difference),
                     TRACE_BAD_LINE);
    assert_true(difference.is_found);
    assert_int_equal(difference.failed, 0);
}

/* ---- Statistics ----------------------------------------------------------------------------- */

static struct trace_statistics statistics;

static void gather(enum board_profile profile, const char *text) {
    struct board_desc desc = board_default_desc(profile);
    struct trace_access access;
    FILE *file = file_of_text(text);
    assert_true(trace_statistics_init(&statistics, &desc));
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    while (trace_reader_next(&reader, &access) == TRACE_OK) {
        trace_statistics_add(&statistics, &access);
    }
    assert_int_equal(reader.error.status, TRACE_END);
    fclose(file);
}

static void writes_are_counted_by_register(void **state) {
    (void)state;
    gather(BOARD_1987, "out16 00D4 1\nout16 00D6 1\nout8 00D8 1\nout8 00D8 2\nin8 00D8 2\n");
    assert_int_equal(statistics.writes, 4);
    assert_int_equal(statistics.reads, 1);
    assert_int_equal(statistics.board.writes[0x8][0], 2);
    assert_int_equal(statistics.board.writes[0x4][1], 1);
    assert_int_equal(statistics.board.reads[0x8][0], 1);
}

static void a_write_that_changes_nothing_is_redundant_but_not_the_first(void **state) {
    static const struct {
        const char *text;
        unsigned redundant;
    } cases[] = {
        {"out16 00D4 0\n", 0}, /* X was 0 by chance */
        {"out16 00D4 0\nout16 00D4 0\n", 1},
        {"out16 00D4 1\nout16 00D4 2\nout16 00D4 1\n", 0},
        {"out16 00D6 7\nout16 00D6 7\nout16 00D4 7\n", 1},
        {"out16 00D4 0105\nout8 00D4 05\nout8 00D5 01\n", 2},
        {"out8 00D0 01\nout8 00D2 50\nout8 00D0 01\nout8 00D2 50\n", 2},
        {"out8 00D0 01\nout8 00D2 50\nout8 00D0 02\nout8 00D2 50\n", 0},
        {"out8 00DE 0\nout8 00DE 0\nout16 00DE 1\nout8 00DE 1\n", 2},
        {"out8 00D8 0\n", 0}, /* black was not known to be there */
        {"out8 00D8 5\nout8 00D8 5\nout8 00DA 5\nout8 00DC 5\nout8 00DC 6\n", 1},
        {"out8 00D8 5\nout16 00D4 1\nout8 00D8 5\nout16 00D4 0\nout8 00D8 5\n", 1},
        {"out16 00D4 700\nout8 00D8 5\nout8 00D8 5\n", 0}, /* outside: no pixel */
        {"out8 00EE C0\nout8 00EE C0\nout8 00D9 1\nout8 00D9 1\n", 0},
        {"out16 00D5 0\nout16 00D5 0\n", 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        gather(BOARD_1987, cases[i].text);
        if (statistics.redundant_writes != cases[i].redundant) {
            fail_msg("case %zu: found %u redundant writes", i,
                     (unsigned)statistics.redundant_writes);
        }
    }
}

static void a_fill_is_redundant_when_all_four_pixels_are_there_already(void **state) {
    (void)state;
    gather(BOARD_LATER, "out16 00D8 0\nout16 00D8 0\nout8 00D8 1\nout16 00D8 0\n");
    assert_int_equal(statistics.redundant_writes, 1);
    struct trace_pixels pixels = trace_statistics_pixels(&statistics);
    assert_int_equal(pixels.again, 4);
    assert_int_equal(pixels.never, 255996);
    gather(BOARD_LATER, "out16 00D4 700\nout16 00D8 0\nout16 00D8 0\n");
    assert_int_equal(statistics.redundant_writes, 0);
    assert_int_equal(trace_statistics_pixels(&statistics).never, 256000);
}

static void pixels_are_counted_by_how_often_they_were_written(void **state) {
    (void)state;
    gather(BOARD_1987, "out8 00D8 1\nout8 00DA 1\nout8 00DC 1\n"  /* once */
                       "out16 00D4 1\nout8 00D8 1\n"              /* once: red only */
                       "out16 00D4 2\nout8 00D8 1\nout8 00D8 2\n" /* again */
                       "in8 00DA 0\n");                           /* a read is no touch */
    struct trace_pixels pixels = trace_statistics_pixels(&statistics);
    assert_int_equal(pixels.once, 2);
    assert_int_equal(pixels.again, 1);
    assert_int_equal(pixels.never, 640 * 400 - 3);
}

static void auto_increment_counts_as_a_write_of_x(void **state) {
    (void)state;
    gather(BOARD_LATER, "out8 00DE 41\nout8 00DC 1\nout8 00DC 1\nout16 00D4 2\n");
    assert_int_equal(statistics.redundant_writes, 1); /* X is 2 by then */
    struct trace_pixels pixels = trace_statistics_pixels(&statistics);
    assert_int_equal(pixels.once, 2);
}

static void statistics_of_an_impossible_board_are_refused(void **state) {
    struct board_desc desc = board_default_desc(BOARD_1987);
    (void)state;
    desc.base = 0x00C0;
    assert_false(trace_statistics_init(&statistics, &desc));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_replay_does_to_the_board_what_the_run_did),
        cmocka_unit_test(a_different_answer_is_reported_and_does_not_stop),
        cmocka_unit_test(a_replay_stops_after_access_k_and_goes_on_from_there),
        cmocka_unit_test(a_bad_trace_ends_a_replay_with_what_came_before_it_done),
        cmocka_unit_test(a_bus_that_fails_ends_a_replay_and_names_the_access),
        cmocka_unit_test(equal_traces_have_no_difference),
        cmocka_unit_test(the_first_difference_is_shown_with_its_surroundings),
        cmocka_unit_test(a_trace_that_ends_early_differs_at_its_end),
        cmocka_unit_test(a_trace_that_can_not_be_read_is_named),
        cmocka_unit_test(writes_are_counted_by_register),
        cmocka_unit_test(a_write_that_changes_nothing_is_redundant_but_not_the_first),
        cmocka_unit_test(a_fill_is_redundant_when_all_four_pixels_are_there_already),
        cmocka_unit_test(pixels_are_counted_by_how_often_they_were_written),
        cmocka_unit_test(auto_increment_counts_as_a_write_of_x),
        cmocka_unit_test(statistics_of_an_impossible_board_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
