/* SPDX-License-Identifier: MIT */
/* How the board is made, powered on and reset. */
#include "board.h"

#include <string.h>

struct board_desc board_default_desc(enum board_profile profile) {
    struct board_desc desc = {profile, BOARD_FACTORY_BASE, BOARD_OUTSIDE_IGNORED, false, 0};
    return desc;
}

bool board_base_is_offered(uint16_t base) {
    /* 00D0h, 02D0h, 04D0h, 06D0h, 08D0h, 0AD0h, 0CD0h */
    return (base & 0xF1FF) == BOARD_FACTORY_BASE && base <= 0x0CD0;
}

/* splitmix64: one 64-bit number for each state, every seed as good as another. */
static uint64_t next_noise(uint64_t *state) {
    uint64_t z = (*state += 0x9E3779B97F4A7C15U);
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
    z = (z ^ z >> 27) * 0x94D049BB133111EBU;
    return z ^ z >> 31;
}

static void fill_with_noise(struct board *board, uint64_t seed) {
    uint64_t noise = 0;
    for (size_t i = 0; i < sizeof board->memory; i++) {
        noise = i % 8 == 0 ? next_noise(&seed) : noise >> 8;
        board->memory[i] = (uint8_t)noise;
    }
}

bool board_init(struct board *board, const struct board_desc *desc) {
    bool is_known = (unsigned)desc->profile < BOARD_PROFILES;
    if (!is_known || !board_base_is_offered(desc->base)) {
        return false;
    }
    memset(board, 0, sizeof *board);
    board->desc = *desc;
    if (desc->noise) {
        fill_with_noise(board, desc->noise_seed);
    }
    board_reset(board);
    return true;
}

void board_reset(struct board *board) {
    board->x = 0;
    board->y = 0;
    board->place = 0;
    board->index = 0;
    board->mode = 0;
    board->is_stepping = false;
    board->is_wrapped = false;
    memset(board->controller, 0, sizeof board->controller);
    memset(board->controller_written, 0, sizeof board->controller_written);
}
