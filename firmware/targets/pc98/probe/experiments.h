/* SPDX-License-Identifier: MIT */
/* What the probe asks the board, and what each profile of the emulator answers. */
#ifndef SUPERFRAME_TARGETS_PC98_PROBE_EXPERIMENTS_H
#define SUPERFRAME_TARGETS_PC98_PROBE_EXPERIMENTS_H

#include <stdint.h>

/* docs/probe.md says of each, by its number, what is done and what the digits mean. An experiment
 * leaves the board in mode 01, its dots black, the controller as the initialisation made it. */
struct experiment {
    char name[15];
    uint8_t digits;             /* of the answer in hexadecimal, 1..8 */
    uint32_t in_1987, in_later; /* what the two profiles of the emulated board answer */
    uint32_t (*answer)(void);
};

/* The number of an experiment is its place here, from 1. The first ones come before the board is
 * initialised: EXPERIMENTS_BEFORE of them. */
enum { EXPERIMENTS = 52, EXPERIMENTS_BEFORE = 3 };
extern const struct experiment experiments[EXPERIMENTS];

/* Asks about control 1 and 2, their controller, ports that should answer nothing
 * (control_experiments.c). */
uint32_t control_1_read(void);
uint32_t control_1_read_after_write(void);
uint32_t control_1_read_bytes(void);
uint32_t index_by_word(void);
uint32_t registers_kept(void);
uint32_t data_by_word(void);
uint32_t cursor_register(void);
uint32_t index_width(void);
uint32_t status_bits(void);
uint32_t frame_accesses(void);
uint32_t control_1_odd_write(void);
uint32_t control_2_odd_write(void);
uint32_t low_odd_reads(void);
uint32_t high_odd_reads(void);
uint32_t write_only_bytes(void);
uint32_t write_only_words(void);
uint32_t aliases(void);

/* Tests every primary of every dot, twice (memory_test.c). */
uint32_t memory_errors(void);

/* Asks about positions, primaries, fills, what lies outside the screen (dot_experiments.c). */
uint32_t memory_at_first(void);
uint32_t x_by_byte(void);
uint32_t y_by_byte(void);
uint32_t x_by_odd_byte(void);
uint32_t y_by_odd_byte(void);
uint32_t word_at_odd_port(void);
uint32_t x_upper_bits(void);
uint32_t primaries_by_odd_byte(void);
uint32_t primary_words_read(void);
uint32_t fill_at_0(void);
uint32_t fill_at_1(void);
uint32_t fill_at_3(void);
uint32_t fill_first_dot(void);
uint32_t fill_second_dot(void);
uint32_t green_by_word(void);
uint32_t blue_by_word(void);
uint32_t right_of_screen(void);
uint32_t far_right_of_screen(void);
uint32_t hidden_first(void);
uint32_t hidden_last(void);
uint32_t hidden_right(void);
uint32_t hidden_lower(void);
uint32_t below_memory(void);

/* Asks what bits of the mode register do that drivers do not use (mode_experiments.c). */
uint32_t steps_after_writes(void);
uint32_t steps_after_reads(void);
uint32_t steps_after_odd_mode(void);
uint32_t mode_bit_04(void);
uint32_t mode_bit_08(void);
uint32_t mode_bit_10(void);
uint32_t mode_bit_20(void);
uint32_t mode_bit_80(void);
uint32_t steal(void);
uint32_t mode_reads(void);
uint32_t red_run(void);

#endif
