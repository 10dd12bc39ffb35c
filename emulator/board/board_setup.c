/* SPDX-License-Identifier: MIT */
/* How the board is made, powered on and reset. */
#include "board.h"

#include "board_internal.h"

#include <string.h>

#include "splitmix64.h"

struct board_desc board_default_desc(enum board_profile profile) {
    struct board_desc desc = {profile, BOARD_FACTORY_BASE, BOARD_OUTSIDE_IGNORED, false, 0};
    return desc;
}

static void fill_with_noise(struct board *board, uint64_t seed) {
    uint64_t noise = 0;
    for (size_t i = 0; i < sizeof board->memory; i++) {
        noise = i % 8 == 0 ? splitmix64(&seed) : noise >> 8;
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
    board_forget_changes(board);
    board_reset(board);
    return true;
}

void board_set_blanking(struct board *board, enum board_blanking blanking) {
    board->blanking = blanking;
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
    board->changes.is_all = true;
}
