/* SPDX-License-Identifier: MIT */
/* The board's state as bytes: saved, restored, and refused where it is bad. */
#include "board_fixture.h"

#include "board_screen.h"
#include "board_state.h"
#include "checksum.h"

enum { BYTES = 801233, CHECKED = BYTES - 4 };

/* Where docs/emulators.md says that members lie. */
enum {
    VERSION = 8,
    LENGTH = 12,
    PROFILE = 16,
    OUTSIDE = 17,
    BASE = 18,
    NOISE = 20,
    BLANKING = 29,
    X = 32,
    Y = 34,
    CONTROLLER = 36,
    WRITTEN = 292,
    ACCESSES = 548,
    COUNTS = 1068,
    FIRSTS = 1308,
    LOG_COUNT = 1548,
    LOG_ACCESS = 1549,
    LOG_BEHAVIOUR = 2061,
    LOG_PORT = 2125,
    LOG_VALUE = 2253,
    LOG_WIDTH = 2381,
    LOG_IS_READ = 2445,
    MEMORY = 2509
};

static uint8_t saved[BYTES], again[BYTES];
static struct board other, before;

static void put_32(uint8_t *bytes, uint32_t value) {
    for (unsigned i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> 8 * i);
    }
}

/* Makes the checksum of the saved bytes right. */
static void seal(void) {
    put_32(saved + CHECKED, crc_by_definition(saved, CHECKED));
}

/* A board of the later profile in the middle of something: every kind of member is in use. */
static void use_a_board(void) {
    power_on_noise(BOARD_LATER, 7);
    initialise();
    put_pixel(639, 399, 0x123456);
    put_pixel(383, 407, 0x654321);
    outp(0x00DE, 0x43);
    outp(0x00DC, 0x11);
    inp(0x00D5);
    inpw(0x00D9);
    outpw(0x00D8, 0x0102);
    outp(0x00D0, 0x77);
    outp(0x00D2, 0x99);
    board_set_blanking(&board, BOARD_BLANKING_ON);
    go_to(700, 3);
}

static void a_restored_board_saves_the_same_bytes(void **state) {
    (void)state;
    use_a_board();
    board_save(&board, saved);
    assert_int_equal(board_restore(&other, saved, BYTES), BOARD_STATE_OK);
    board_save(&other, again);
    assert_memory_equal(saved, again, BYTES);
}

static void a_restored_board_has_every_member(void **state) {
    (void)state;
    for (int outside = 0; outside < 2; outside++) {
        struct board_desc desc = board_default_desc(BOARD_LATER);
        desc.outside = (enum board_outside)outside;
        power_on_desc(&desc);
        initialise();
        outp(0x00DE, 0x43);
        inp(0x00D5);
        go_to(700, 3);
        board_save(&board, saved);
        memset(&other, 0xA5, sizeof other);
        assert_int_equal(board_restore(&other, saved, BYTES), BOARD_STATE_OK);
        assert_int_equal(other.place, board.place);
        assert_int_equal(other.is_wrapped, board.is_wrapped);
        assert_int_equal(other.is_stepping, board.is_stepping);
        assert_int_equal(other.accesses, board.accesses);
        assert_int_equal(other.log_count, board.log_count);
        assert_memory_equal(other.notes, board.notes, sizeof other.notes);
        assert_memory_equal(other.reads, board.reads, sizeof other.reads);
        assert_memory_equal(other.writes, board.writes, sizeof other.writes);
        assert_memory_equal(other.memory, board.memory, sizeof other.memory);
        assert_int_equal(other.log[1].port, 0x00D5); /* the mode was the first */
        assert_true(other.log[1].is_read);
    }
}

/* Both boards do the same after the state was taken, and answer the same. */
static void a_restored_board_goes_on_as_the_saved_one(void **state) {
    uint64_t random = 0x2545F4914F6CDD1DU;
    (void)state;
    use_a_board();
    board_save(&board, saved);
    assert_int_equal(board_restore(&other, saved, BYTES), BOARD_STATE_OK);
    for (unsigned i = 0; i < 20000; i++) {
        random = random * 6364136223846793005U + 1442695040888963407U;
        uint16_t port = (uint16_t)(0x00CE + (random >> 40) % 20);
        unsigned width = 1U << (random >> 50) % 3;
        if ((random >> 60) == 0) {
            assert_int_equal(board_read(&board, port, width), board_read(&other, port, width));
        } else {
            board_write(&board, port, (uint32_t)(random >> 20), width);
            board_write(&other, port, (uint32_t)(random >> 20), width);
        }
    }
    board_save(&board, saved);
    board_save(&other, again);
    assert_memory_equal(saved, again, BYTES);
}

static void the_bytes_lie_where_the_page_says(void **state) {
    static const uint8_t head[16] = {0x89, 'S', 'F', 'B', 0x0D, 0x0A, 0x1A, 0x0A,
                                     1,    0,   0,   0,   0xD1, 0x39, 0x0C, 0x00};
    (void)state;
    use_a_board();
    board_save(&board, saved);
    assert_memory_equal(saved, head, 16);
    assert_int_equal(saved[PROFILE], 1);
    assert_int_equal(saved[BASE] | saved[BASE + 1] << 8, 0x00D0);
    assert_int_equal(saved[NOISE], 1);
    assert_int_equal(saved[NOISE + 1], 7);
    assert_int_equal(saved[BLANKING], 2);
    assert_int_equal(saved[BLANKING + 1], 0x77); /* index */
    assert_int_equal(saved[BLANKING + 2], 0x43); /* mode */
    assert_int_equal(saved[X] | saved[X + 1] << 8, 700);
    assert_int_equal(saved[Y] | saved[Y + 1] << 8, 3);
    assert_int_equal(saved[CONTROLLER + 0x77], 0x99);
    assert_int_equal(saved[WRITTEN + 0x77], 1);
    assert_int_equal(saved[ACCESSES], board.accesses);
    assert_int_equal(saved[LOG_COUNT], board.log_count);
    assert_int_equal(saved[LOG_ACCESS], board.log[0].access);
    assert_int_equal(saved[LOG_BEHAVIOUR], board.log[0].behaviour);
    assert_int_equal(saved[LOG_WIDTH], 1);
    assert_int_equal(saved[MEMORY + (407 * 640 + 383) * 3], board.memory[(407 * 640 + 383) * 3]);
    assert_int_equal(saved[CHECKED - 1], board.memory[sizeof board.memory - 1]);
    uint32_t crc = crc_by_definition(saved, CHECKED);
    assert_int_equal(saved[CHECKED] | saved[CHECKED + 1] << 8, crc & 0xFFFF);
    assert_int_equal(saved[CHECKED + 2] | saved[CHECKED + 3] << 8, crc >> 16);
}

/* ---- Refused -------------------------------------------------------------------------------- */

/* Holds that the bytes are refused with this status, and that the board is as it was. */
static void refused(size_t count, enum board_state_status status) {
    memcpy(&other, &board, sizeof other);
    memcpy(&before, &board, sizeof before);
    assert_int_equal(board_restore(&other, saved, count), status);
    assert_memory_equal(&other, &before, sizeof other);
}

/* Saves the board that is in use, changes a byte, and holds that it is refused. */
static void refused_with(unsigned place, uint8_t value, enum board_state_status status) {
    use_a_board();
    board_save(&board, saved);
    assert_int_not_equal(saved[place], value);
    saved[place] = value;
    if (status != BOARD_STATE_DAMAGED) {
        seal();
    }
    refused(BYTES, status);
}

static void a_state_of_another_length_is_refused(void **state) {
    static const size_t cut[] = {0, 1, 7, 8, 11};
    static const size_t wrong[] = {12,        15,        16,        17,       1000,
                                   BYTES - 5, BYTES - 4, BYTES - 1, BYTES + 1};
    (void)state;
    use_a_board();
    board_save(&board, saved);
    for (size_t i = 0; i < sizeof cut / sizeof cut[0]; i++) {
        refused(cut[i], BOARD_STATE_FOREIGN);
    }
    assert_int_equal(board_restore(&board, NULL, 0), BOARD_STATE_FOREIGN);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        refused(wrong[i], BOARD_STATE_WRONG_LENGTH);
    }
    refused_with(LENGTH, 0xD0, BOARD_STATE_WRONG_LENGTH);
}

static void a_foreign_state_and_another_version_are_refused(void **state) {
    (void)state;
    refused_with(0, 0x88, BOARD_STATE_FOREIGN);
    refused_with(7, 0x0D, BOARD_STATE_FOREIGN);
    refused_with(VERSION, 2, BOARD_STATE_WRONG_VERSION);
    refused_with(VERSION, 0, BOARD_STATE_WRONG_VERSION);
    refused_with(VERSION + 3, 1, BOARD_STATE_WRONG_VERSION);
}

static void a_changed_byte_anywhere_is_refused(void **state) {
    (void)state;
    refused_with(MEMORY, (uint8_t)(board.memory[0] ^ 1), BOARD_STATE_DAMAGED);
    refused_with(X, 1, BOARD_STATE_DAMAGED);
    use_a_board();
    board_save(&board, saved);
    saved[BYTES - 1] ^= 0x80;
    refused(BYTES, BOARD_STATE_DAMAGED);
}

static void a_value_that_no_board_has_is_refused_whatever_its_checksum(void **state) {
    (void)state;
    refused_with(PROFILE, 2, BOARD_STATE_IMPOSSIBLE);
    refused_with(OUTSIDE, 2, BOARD_STATE_IMPOSSIBLE);
    refused_with(BASE, 0xD1, BOARD_STATE_IMPOSSIBLE);
    refused_with(BASE + 1, 0x0E, BOARD_STATE_IMPOSSIBLE);
    refused_with(NOISE, 2, BOARD_STATE_IMPOSSIBLE);
    refused_with(BLANKING, 3, BOARD_STATE_IMPOSSIBLE);
    refused_with(X + 1, 4, BOARD_STATE_IMPOSSIBLE);
    refused_with(Y + 1, 2, BOARD_STATE_IMPOSSIBLE);
    refused_with(CONTROLLER + 0x78, 1, BOARD_STATE_IMPOSSIBLE); /* never written */
    refused_with(WRITTEN + 0x78, 2, BOARD_STATE_IMPOSSIBLE);
    refused_with(ACCESSES, 1, BOARD_STATE_IMPOSSIBLE); /* notes of later accesses */
    refused_with(COUNTS, 0, BOARD_STATE_IMPOSSIBLE);   /* of index writes: has a first one */
    refused_with(FIRSTS, 0, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_COUNT, 65, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_COUNT, 64, BOARD_STATE_IMPOSSIBLE); /* more than the violations */
    refused_with(LOG_COUNT, 1, BOARD_STATE_IMPOSSIBLE);  /* fewer than the violations */
    refused_with(LOG_ACCESS, 0, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_ACCESS + 7, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_ACCESS + 8 * 63, 1, BOARD_STATE_IMPOSSIBLE); /* behind the last entry */
    refused_with(LOG_BEHAVIOUR + 63, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_PORT + 2 * 63, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_VALUE + 2 * 63 + 1, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_WIDTH + 63, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_IS_READ + 63, 1, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_BEHAVIOUR, BOARD_BEHAVIOURS, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_BEHAVIOUR, BOARD_PRIMARY_WRITE, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_WIDTH, 0, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_WIDTH, 3, BOARD_STATE_IMPOSSIBLE);
    refused_with(LOG_IS_READ, 2, BOARD_STATE_IMPOSSIBLE);
}

/* More violations than the log holds, and exactly as many. */
static void a_full_log_comes_back_and_is_held_against_the_violations(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    for (unsigned i = 1; i <= 66; i++) {
        inp(0x00D5);
        board_save(&board, saved);
        assert_int_equal(saved[LOG_COUNT], i < 64 ? i : 64);
        assert_int_equal(board_restore(&other, saved, BYTES), BOARD_STATE_OK);
        assert_int_equal(board_violations(&other), i);
    }
    saved[LOG_COUNT] = 63;
    seal();
    refused(BYTES, BOARD_STATE_IMPOSSIBLE);
}

static void a_restored_screen_has_changed_as_a_whole(void **state) {
    (void)state;
    use_a_board();
    board_save(&board, saved);
    board_take_changes(&board);
    assert_int_equal(board_take_changes(&board).width, 0);
    assert_int_equal(board_restore(&board, saved, BYTES), BOARD_STATE_OK);
    assert_int_equal(board_take_changes(&board).width, 640);
    assert_int_equal(board_take_changes(&board).width, 0);
}

static void every_status_has_a_text_of_its_own(void **state) {
    (void)state;
    for (int i = 0; i <= BOARD_STATE_IMPOSSIBLE + 1; i++) {
        for (int k = 0; k < i; k++) {
            assert_string_not_equal(board_state_text((enum board_state_status)i),
                                    board_state_text((enum board_state_status)k));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_restored_board_saves_the_same_bytes),
        cmocka_unit_test(a_restored_board_has_every_member),
        cmocka_unit_test(a_restored_board_goes_on_as_the_saved_one),
        cmocka_unit_test(the_bytes_lie_where_the_page_says),
        cmocka_unit_test(a_state_of_another_length_is_refused),
        cmocka_unit_test(a_foreign_state_and_another_version_are_refused),
        cmocka_unit_test(a_changed_byte_anywhere_is_refused),
        cmocka_unit_test(a_value_that_no_board_has_is_refused_whatever_its_checksum),
        cmocka_unit_test(a_full_log_comes_back_and_is_held_against_the_violations),
        cmocka_unit_test(a_restored_screen_has_changed_as_a_whole),
        cmocka_unit_test(every_status_has_a_text_of_its_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
