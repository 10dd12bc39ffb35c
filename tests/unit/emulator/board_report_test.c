/* SPDX-License-Identifier: MIT */
/* How the board is made and what it reports: profiles, bases, counters, log, grades, 100,000
 * random accesses. */
#include "board_fixture.h"

static void only_the_seven_bases_of_the_jumper_are_offered(void **state) {
    (void)state;
    static struct board made;
    for (unsigned base = 0; base <= 0xFFFF; base++) {
        bool is_offered = base == 0x00D0 || base == 0x02D0 || base == 0x04D0 || base == 0x06D0 ||
                          base == 0x08D0 || base == 0x0AD0 || base == 0x0CD0;
        assert_int_equal(board_base_is_offered((uint16_t)base), is_offered);
    }
    struct board_desc desc = board_default_desc(BOARD_1987);
    made.accesses = 77;
    desc.base = 0x01D0;
    assert_false(board_init(&made, &desc));
    desc = board_default_desc((enum board_profile)2);
    assert_false(board_init(&made, &desc));
    assert_int_equal(made.accesses, 77);
}

static void another_base_moves_all_registers(void **state) {
    (void)state;
    struct board_desc desc = board_default_desc(BOARD_LATER);
    desc.base = 0x04D0;
    power_on_desc(&desc);
    outpw(0x04D4, 3);
    outpw(0x04D6, 4);
    outp(0x04D8, 0x99);
    outp(0x00D8, 0x11);
    assert_int_equal(inp(0x04D8), 0x99);
    assert_int_equal(inp(0x00D8), 0xFF);
}

static void memory_starts_black_or_with_seeded_noise(void **state) {
    (void)state;
    static struct board a, b;
    unsigned histogram[256] = {0};
    power_on(BOARD_1987);
    for (size_t i = 0; i < sizeof board.memory; i++) {
        assert_int_equal(board.memory[i], 0);
    }
    power_on_noise(BOARD_1987, 0);
    a = board;
    power_on_noise(BOARD_1987, 1);
    b = board;
    power_on_noise(BOARD_1987, 0);
    assert_memory_equal(board.memory, a.memory, sizeof a.memory);
    assert_memory_not_equal(board.memory, b.memory, sizeof b.memory);
    for (size_t i = 0; i < sizeof a.memory; i++) {
        histogram[a.memory[i]]++;
    }
    for (unsigned i = 0; i < 256; i++) { /* 3120 on average */
        assert_in_range(histogram[i], 2700, 3540);
    }
}

static void reset_clears_the_registers_and_keeps_memory_and_counters(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    initialise();
    outp(0x00DE, 0x41);
    put_pixel(5, 5, 0x123456);
    uint64_t accesses = board.accesses;
    board_reset(&board);
    assert_int_equal(board.accesses, accesses);
    assert_int_equal(board.mode, 0);
    assert_int_equal(get_here(), 0x000000); /* at 0, 0 */
    outp(0x00D0, 0x01);
    assert_int_equal(inp(0x00D2), 0x00);
    assert_int_equal(get_pixel(5, 5), 0x123456);
}

static void a_copy_is_a_board_of_its_own(void **state) {
    (void)state;
    static struct board copy;
    power_on(BOARD_1987);
    put_pixel(1, 1, 0x111111);
    copy = board;
    put_pixel(1, 1, 0x222222);
    assert_int_equal(board_read(&copy, 0x00D8, 1), 0x11);
    assert_int_equal(board_read(&board, 0x00D8, 1), 0x22);
}

static void accesses_are_counted_by_register_width_and_direction(void **state) {
    (void)state;
    power_on(BOARD_1987);
    outpw(0x00D4, 1);
    outpw(0x00D4, 2);
    outp(0x00D8, 3);
    outp(0x00D9, 3);
    inp(0x00D8);
    inpw(0x00DA);
    outp(0x00EE, 0xC0);
    assert_int_equal(board.accesses, 7);
    assert_int_equal(board.writes[0x4][1], 2);
    assert_int_equal(board.writes[0x4][0], 0);
    assert_int_equal(board.writes[0x8][0], 1);
    assert_int_equal(board.writes[0x9][0], 1);
    assert_int_equal(board.reads[0x8][0], 1);
    assert_int_equal(board.reads[0xA][1], 1);
}

/* What one access, after an X and an index were set, makes the board note. */
static const struct noted {
    enum board_profile profile;
    uint16_t x, y;
    uint8_t index, mode;
    char access; /* b, w: written as a byte, a word; B, W: read */
    uint16_t port, value;
    enum board_behaviour behaviours[3];
    unsigned count;
} noted[] = {
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD0, 0x10, {BOARD_INDEX_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xD0, 0x10, {BOARD_INDEX_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD2, 0x61, {BOARD_DATA_WRITE}, 1},
    {BOARD_LATER, 0, 0, 0x0C, 0, 'b', 0xD2, 0x00, {BOARD_DATA_WRITE, BOARD_START_ADDRESS}, 2},
    {BOARD_LATER, 0, 0, 0x0C, 0, 'b', 0xD2, 0xFF, {BOARD_DATA_WRITE}, 1},
    {BOARD_1987, 0, 0, 0x77, 0, 'b', 0xD2, 0x00, {BOARD_DATA_WRITE, BOARD_UNKNOWN_INDEX}, 2},
    {BOARD_1987, 0, 0, 0x00, 0, 'B', 0xD2, 0, {BOARD_UNWRITTEN_READ}, 1},
    {BOARD_LATER, 0, 0, 0x1F, 0, 'B', 0xD2, 0, {BOARD_STATUS_READ}, 1},
    {BOARD_1987, 0, 0, 0x1F, 0, 'B', 0xD2, 0, {BOARD_UNWRITTEN_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xD4, 5, {BOARD_POSITION_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xD6, 5, {BOARD_POSITION_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD4, 5, {BOARD_POSITION_LOW_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD6, 5, {BOARD_POSITION_LOW_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD5, 1, {BOARD_POSITION_HIGH_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD7, 1, {BOARD_POSITION_HIGH_WRITE}, 1},
    {BOARD_1987, 639, 399, 0, 0, 'b', 0xD8, 1, {BOARD_PRIMARY_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDA, 1, {BOARD_PRIMARY_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDC, 1, {BOARD_PRIMARY_WRITE}, 1},
    {BOARD_1987, 640, 0, 0, 0, 'b', 0xDC, 1, {BOARD_PRIMARY_WRITE, BOARD_OUTSIDE_WRITE}, 2},
    {BOARD_1987, 0, 400, 0, 0, 'b', 0xDC, 1, {BOARD_PRIMARY_WRITE, BOARD_OUTSIDE_WRITE}, 2},
    {BOARD_LATER, 0, 400, 0, 0, 'b', 0xDC, 1, {BOARD_PRIMARY_WRITE, BOARD_HIDDEN_ACCESS}, 2},
    {BOARD_LATER, 0, 0, 0, 0x40, 'b', 0xDC, 1, {BOARD_PRIMARY_WRITE, BOARD_AUTO_INCREMENT}, 2},
    {BOARD_LATER, 0, 0, 0, 0x40, 'b', 0xD8, 1, {BOARD_PRIMARY_WRITE}, 1},
    {BOARD_1987, 639, 399, 0, 0, 'B', 0xD8, 0, {BOARD_PRIMARY_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xDA, 0, {BOARD_PRIMARY_READ}, 1},
    {BOARD_LATER, 0, 0, 0, 0x40, 'B', 0xDC, 0, {BOARD_PRIMARY_READ}, 1},
    {BOARD_1987, 640, 0, 0, 0, 'B', 0xD8, 0, {BOARD_PRIMARY_READ, BOARD_OUTSIDE_READ}, 2},
    {BOARD_LATER, 0, 400, 0, 0, 'B', 0xD8, 0, {BOARD_PRIMARY_READ, BOARD_HIDDEN_ACCESS}, 2},
    {BOARD_1987, 0, 0, 0, 0, 'W', 0xDA, 0, {BOARD_PRIMARY_WORD_READ}, 1},
    {BOARD_1987, 640, 0, 0, 0, 'W', 0xDA, 0, {BOARD_OUTSIDE_READ, BOARD_PRIMARY_WORD_READ}, 2},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xD8, 1, {BOARD_RED_WORD_WRITE}, 1},
    {BOARD_LATER, 4, 0, 0, 0, 'w', 0xD8, 0, {BOARD_RED_WORD_WRITE}, 1},
    {BOARD_LATER, 4, 0, 0, 0, 'w', 0xD8, 1, {BOARD_RED_WORD_WRITE, BOARD_FILL_UNSEEN}, 2},
    {BOARD_LATER, 5, 0, 0, 0, 'w', 0xD8, 0, {BOARD_RED_WORD_WRITE, BOARD_FILL_UNSEEN}, 2},
    {BOARD_LATER, 0, 0, 0, 0, 'w', 0xDA, 0, {BOARD_PRIMARY_WORD_WRITE}, 1},
    {BOARD_LATER, 0, 0, 0, 0, 'w', 0xDC, 0, {BOARD_PRIMARY_WORD_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDE, 0, {BOARD_MODE_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDE, 1, {BOARD_MODE_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDE, 3, {BOARD_MODE_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDE, 2, {BOARD_MODE_UNKNOWN}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xDE, 0x40, {BOARD_MODE_UNKNOWN}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'W', 0xD0, 0, {BOARD_CONTROL1_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xD0, 0, {BOARD_CONTROL1_BYTE_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xD1, 0, {BOARD_ODD_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xD9, 0, {BOARD_ODD_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xD9, 0, {BOARD_ODD_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xD4, 0, {BOARD_WRITE_ONLY_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'W', 0xD6, 0, {BOARD_WRITE_ONLY_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'W', 0xDE, 0, {BOARD_WRITE_ONLY_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'b', 0xE0, 0, {BOARD_FOREIGN_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xCE, 0, {BOARD_FOREIGN_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'w', 0xE1, 0, {BOARD_FOREIGN_WRITE}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'B', 0xE0, 0, {BOARD_FOREIGN_READ}, 1},
    {BOARD_1987, 0, 0, 0, 0, 'W', 0xE1, 0, {BOARD_FOREIGN_READ}, 1},
    {BOARD_1987,
     0,
     0,
     0,
     0,
     'w',
     0xCF,
     0x0000,
     {BOARD_WORD_SPLIT, BOARD_FOREIGN_WRITE, BOARD_INDEX_WRITE},
     3},
    {BOARD_1987,
     0,
     0,
     0,
     0,
     'W',
     0xD9,
     0,
     {BOARD_WORD_SPLIT, BOARD_ODD_READ, BOARD_PRIMARY_READ},
     3},
};

static void access_of(const struct noted *row) {
    if (row->access == 'b') {
        outp(row->port, (uint8_t)row->value);
    } else if (row->access == 'w') {
        outpw(row->port, row->value);
    } else if (row->access == 'B') {
        (void)inp(row->port);
    } else {
        (void)inpw(row->port);
    }
}

static void an_access_notes_its_behaviours_once_and_no_others(void **state) {
    (void)state;
    static struct board_note before[BOARD_BEHAVIOURS];
    bool is_covered[BOARD_BEHAVIOURS] = {false};
    for (size_t i = 0; i < sizeof noted / sizeof *noted; i++) {
        const struct noted *row = &noted[i];
        power_on(row->profile);
        outpw(0x00D4, row->x);
        outpw(0x00D6, row->y);
        outp(0x00D0, row->index);
        outp(0x00DE, row->mode);
        memcpy(before, board.notes, sizeof before);
        access_of(row);
        for (unsigned j = 0; j < BOARD_BEHAVIOURS; j++) {
            uint64_t expected = before[j].count;
            for (unsigned k = 0; k < row->count; k++) {
                expected += row->behaviours[k] == j;
                is_covered[row->behaviours[k]] = true;
            }
            if (board.notes[j].count != expected) {
                fail_msg("row %u: \"%s\" noted %u times, not %u", (unsigned)i,
                         board_behaviour_text((enum board_behaviour)j),
                         (unsigned)(board.notes[j].count - before[j].count),
                         (unsigned)(expected - before[j].count));
            }
        }
    }
    /* Data read from an index that was written needs two accesses to the one index. */
    power_on(BOARD_1987);
    outp(0x00D0, 0x00);
    outp(0x00D2, 0x61);
    assert_int_equal(inp(0x00D2), 0x61);
    assert_int_equal(board.notes[BOARD_DATA_READ].count, 1);
    assert_int_equal(board.notes[BOARD_UNWRITTEN_READ].count, 0);
    is_covered[BOARD_DATA_READ] = true;
    for (unsigned j = 0; j < BOARD_BEHAVIOURS; j++) {
        if (!is_covered[j]) {
            fail_msg("no row for \"%s\"", board_behaviour_text((enum board_behaviour)j));
        }
    }
}

static void a_violation_is_logged_with_number_port_value_and_width(void **state) {
    (void)state;
    power_on(BOARD_1987);
    outpw(0x00D4, 700);
    outp(0x00D8, 0x42);
    inpw(0x00DA);
    assert_int_equal(board.log_count, 3);
    const struct board_violation *entry = &board.log[0];
    assert_int_equal(entry->access, 2);
    assert_int_equal(entry->behaviour, BOARD_OUTSIDE_WRITE);
    assert_int_equal(entry->port, 0x00D8);
    assert_int_equal(entry->value, 0x42);
    assert_int_equal(entry->width, 1);
    assert_false(entry->is_read);
    entry = &board.log[2];
    assert_int_equal(entry->access, 3);
    assert_int_equal(entry->behaviour, BOARD_PRIMARY_WORD_READ);
    assert_int_equal(entry->value, 0xFFFF);
    assert_int_equal(entry->width, 2);
    assert_true(entry->is_read);
    assert_int_equal(board.notes[BOARD_OUTSIDE_WRITE].first, 2);
    assert_int_equal(board.notes[BOARD_OUTSIDE_READ].first, 3);
}

static void the_log_is_bounded_and_the_count_is_not(void **state) {
    (void)state;
    power_on(BOARD_1987);
    for (unsigned i = 0; i < 1000; i++) {
        inp(0x00DE);
    }
    assert_int_equal(board.log_count, 64);
    assert_int_equal(board.log[63].access, 64);
    assert_int_equal(board_violations(&board), 1000);
    assert_int_equal(board.notes[BOARD_WRITE_ONLY_READ].first, 1);
}

static void reliances_are_counted_by_grade(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    outpw(0x00D4, 4); /* P */
    outp(0x00D8, 1);  /* P */
    outp(0x00DE, 1);  /* D */
    outpw(0x00D8, 0); /* I: the fill */
    outp(0x00D4, 8);  /* I: a byte to X */
    outpw(0x00DA, 0); /* A: a word to green */
    assert_int_equal(board_reliances(&board, GRADE_ASSUMED), 1);
    assert_int_equal(board_reliances(&board, GRADE_INFERRED), 3);
    assert_int_equal(board_reliances(&board, GRADE_SHEET), 3);
    assert_int_equal(board_reliances(&board, GRADE_DRIVER), 4);
    assert_int_equal(board_reliances(&board, GRADE_PAPER), 6);
}

static void whatever_is_assumed_is_a_violation_and_every_behaviour_has_a_text(void **state) {
    (void)state;
    for (unsigned i = 0; i < BOARD_BEHAVIOURS; i++) {
        enum board_behaviour behaviour = (enum board_behaviour)i;
        assert_true(strlen(board_behaviour_text(behaviour)) > 10);
        for (unsigned j = 0; j < i; j++) {
            assert_string_not_equal(board_behaviour_text(behaviour),
                                    board_behaviour_text((enum board_behaviour)j));
        }
        for (unsigned p = 0; p < BOARD_PROFILES; p++) {
            enum board_profile profile = (enum board_profile)p;
            assert_int_equal(board_behaviour_grade(behaviour, profile) == GRADE_ASSUMED,
                             board_behaviour_is_violation(behaviour, profile));
        }
    }
}

static void names_of_grades_and_profiles_are_read_and_written(void **state) {
    static const char *const words[] = {"P",     "paper", "D",        "driver", "S",
                                        "sheet", "I",     "inferred", "A",      "assumed"};
    static const char *const none[] = {"", "X", "AA", "assume", "pap", "papers"};
    enum board_grade grade;
    enum board_profile profile;
    (void)state;
    for (unsigned i = 0; i < 10; i++) {
        assert_true(board_grade_from_text(words[i], &grade));
        assert_int_equal(grade, i / 2);
        assert_string_equal(board_grade_letter(grade), words[i / 2 * 2]);
    }
    assert_true(board_grade_from_text("ASSUMED", &grade) && grade == GRADE_ASSUMED);
    assert_true(board_grade_from_text("i", &grade) && grade == GRADE_INFERRED);
    for (unsigned i = 0; i < sizeof none / sizeof none[0]; i++) {
        assert_false(board_grade_from_text(none[i], &grade));
    }
    assert_true(board_profile_from_text("1987", &profile) && profile == BOARD_1987);
    assert_true(board_profile_from_text("later", &profile) && profile == BOARD_LATER);
    assert_false(board_profile_from_text("1988", &profile));
    assert_string_equal(board_profile_text(BOARD_1987), "1987");
    assert_string_equal(board_profile_text(BOARD_LATER), "later");
}

/* Under the sanitizers: any access at all is defined, counted, and of the right size. */
static void random_accesses_do_no_harm(void **state) {
    (void)state;
    uint64_t random = 0x5EED;
    for (int variant = 0; variant < 4; variant++) {
        struct board_desc desc = board_default_desc(variant & 1 ? BOARD_LATER : BOARD_1987);
        desc.outside = variant & 2 ? BOARD_OUTSIDE_WRAPS : BOARD_OUTSIDE_IGNORED;
        power_on_desc(&desc);
        for (unsigned i = 0; i < 100000; i++) {
            uint32_t draw = next_random(&random);
            /* Seven of eight within and just around the sixteen ports. */
            uint16_t port = (uint16_t)((draw & 7) == 0 ? draw >> 16 : 0xCE + (draw >> 16) % 20);
            uint16_t value = (uint16_t)next_random(&random);
            switch (draw >> 3 & 3) {
            case 0:
                outp(port, (uint8_t)value);
                break;
            case 1:
                outpw(port, value);
                break;
            case 2:
                inp(port);
                break;
            default:
                inpw(port);
            }
            assert_in_range(board.x, 0, 1023);
            assert_in_range(board.y, 0, 511);
        }
        assert_int_equal(board.accesses, 100000);
        assert_int_equal(board_reliances(&board, GRADE_ASSUMED), board_violations(&board));
        assert_true(board_reliances(&board, GRADE_PAPER) >= 100000);
        assert_int_equal(bus_bound_status(), BUS_OK);
    }
}

/* The two observations on a real board contradict each other: a start is no better known. */
static void a_display_start_is_inferred_on_later_boards(void **state) {
    (void)state;
    assert_int_equal(board_behaviour_grade(BOARD_START_ADDRESS, BOARD_LATER), GRADE_INFERRED);
    assert_false(board_behaviour_is_violation(BOARD_START_ADDRESS, BOARD_LATER));
    assert_int_equal(board_behaviour_grade(BOARD_START_ADDRESS, BOARD_1987), GRADE_ASSUMED);
    assert_true(board_behaviour_is_violation(BOARD_START_ADDRESS, BOARD_1987));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_display_start_is_inferred_on_later_boards),
        cmocka_unit_test(only_the_seven_bases_of_the_jumper_are_offered),
        cmocka_unit_test(another_base_moves_all_registers),
        cmocka_unit_test(memory_starts_black_or_with_seeded_noise),
        cmocka_unit_test(reset_clears_the_registers_and_keeps_memory_and_counters),
        cmocka_unit_test(a_copy_is_a_board_of_its_own),
        cmocka_unit_test(accesses_are_counted_by_register_width_and_direction),
        cmocka_unit_test(an_access_notes_its_behaviours_once_and_no_others),
        cmocka_unit_test(a_violation_is_logged_with_number_port_value_and_width),
        cmocka_unit_test(the_log_is_bounded_and_the_count_is_not),
        cmocka_unit_test(reliances_are_counted_by_grade),
        cmocka_unit_test(whatever_is_assumed_is_a_violation_and_every_behaviour_has_a_text),
        cmocka_unit_test(names_of_grades_and_profiles_are_read_and_written),
        cmocka_unit_test(random_accesses_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
