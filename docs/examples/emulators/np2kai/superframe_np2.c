/* SPDX-License-Identifier: MIT */
/* The SuperFrame board in NP2kai: ports, words before NP2kai's table, screen, save states. */
#include "compiler.h"
#include "iocore.h"
#include "pccore.h"
#include "scrndraw.h"
#include "scrnmng.h"
#include "statsave.h"

#include "superframe_board.h"
#include "superframe_np2.h"

static struct superframe board;
static bool is_on;
static uint8_t bytes[SUPERFRAME_STATE_BYTES];

void superframe_np2_reset(const NP2CFG *config) {
    struct superframe_desc desc = superframe_default_desc(SUPERFRAME_LATER);
    (void)config;
    if (is_on) {
        superframe_reset(&board);
    } else {
        is_on = superframe_init(&board, &desc);
    }
}

/* ---- Ports ---------------------------------------------------------------------------------- */

static uint16_t read_board(UINT port, unsigned width) {
    bool is_blank = (gdc.vsync & 0x20) != 0;
    superframe_set_blanking(&board, is_blank ? SUPERFRAME_BLANKING_ON : SUPERFRAME_BLANKING_OFF);
    return (uint16_t)superframe_read(&board, (uint16_t)port, width);
}

static void IOOUTCALL out8(UINT port, REG8 value) {
    superframe_write(&board, (uint16_t)port, value, 1);
}

static REG8 IOINPCALL inp8(UINT port) {
    return (REG8)read_board(port, 1);
}

void superframe_np2_bind(void) {
    for (UINT i = 0; i < SUPERFRAME_PORTS; i++) {
        iocore_attachout(board.desc.base + i, out8);
        iocore_attachinp(board.desc.base + i, inp8);
    }
}

/* Tells whether a word is the board's. Words at odd ports are not: NP2kai makes two bytes of them,
 * and of those each reaches its own device. */
static bool is_word_of_board(UINT port) {
    return is_on && (port & ~(UINT)(SUPERFRAME_PORTS - 2)) == board.desc.base;
}

BOOL superframe_np2_out16(UINT port, REG16 value) {
    if (!is_word_of_board(port)) {
        return FALSE;
    }
    superframe_write(&board, (uint16_t)port, value, 2);
    return TRUE;
}

BOOL superframe_np2_inp16(UINT port, REG16 *value) {
    if (!is_word_of_board(port)) {
        return FALSE;
    }
    *value = read_board(port, 2);
    return TRUE;
}

/* ---- The screen ----------------------------------------------------------------------------- */

void superframe_np2_update(void) {
    struct superframe_area area = superframe_take_changes(&board);
    for (unsigned y = area.y; y < area.y + area.height; y++) {
        renewal_line[y] |= 0x80;
        pcstat.screenupdate |= 1;
    }
}

/* A pixel of 16 bits has 5, 6 and 5 of red, green and blue; one of 32 has bytes, blue first. */
static void take_pixel(const UINT8 *pixel, UINT bpp, uint8_t rgb[3]) {
    if (bpp == 16) {
        unsigned value = pixel[0] | (unsigned)pixel[1] << 8;
        unsigned red = value >> 11, green = value >> 5 & 63, blue = value & 31;
        rgb[0] = (uint8_t)(red << 3 | red >> 2);
        rgb[1] = (uint8_t)(green << 2 | green >> 4);
        rgb[2] = (uint8_t)(blue << 3 | blue >> 2);
    } else {
        rgb[0] = pixel[2];
        rgb[1] = pixel[1];
        rgb[2] = pixel[0];
    }
}

static void put_pixel(UINT8 *pixel, UINT bpp, const uint8_t rgb[3]) {
    if (bpp == 16) {
        unsigned value = (rgb[0] >> 3U) << 11 | (rgb[1] >> 2U) << 5 | rgb[2] >> 3U;
        pixel[0] = (UINT8)value;
        pixel[1] = (UINT8)(value >> 8);
    } else {
        pixel[0] = rgb[2];
        pixel[1] = rgb[1];
        pixel[2] = rgb[0];
    }
}

static void draw_line(const SCRNSURF *surface, unsigned y, unsigned width) {
    uint8_t rgb[SUPERFRAME_WIDTH * 3];
    UINT8 *first = surface->ptr + (int)y * surface->yalign;
    struct superframe_area area = {0, y, width, 1};
    for (unsigned x = 0; x < width; x++) {
        take_pixel(first + (int)x * surface->xalign, surface->bpp, rgb + x * 3);
    }
    superframe_draw_over_area(&board, area, rgb, sizeof rgb);
    for (unsigned x = 0; x < width; x++) {
        put_pixel(first + (int)x * surface->xalign, surface->bpp, rgb + x * 3);
    }
}

void superframe_np2_draw(const SCRNSURF *surface, const UINT8 *dirty) {
    unsigned width =
        surface->width < SUPERFRAME_WIDTH ? (unsigned)surface->width : (unsigned)SUPERFRAME_WIDTH;
    for (unsigned y = 0; y < SUPERFRAME_HEIGHT && y < (unsigned)surface->height; y++) {
        if (dirty[y] != 0 && (surface->bpp == 16 || surface->bpp == 32)) {
            draw_line(surface, y, width);
        }
    }
}

/* ---- Save states ---------------------------------------------------------------------------- */

int superframe_np2_save(STFLAGH state, const SFENTRY *entry) {
    (void)entry;
    superframe_save(&board, bytes);
    return statflag_write(state, bytes, sizeof bytes);
}

int superframe_np2_load(STFLAGH state, const SFENTRY *entry) {
    (void)entry;
    int result = statflag_read(state, bytes, sizeof bytes);
    if (result != STATFLAG_SUCCESS) {
        return result;
    }
    enum superframe_state_status status = superframe_restore(&board, bytes, sizeof bytes);
    if (status != SUPERFRAME_STATE_OK) {
        statflag_seterr(state, superframe_state_text(status));
        return STATFLAG_FAILURE;
    }
    return STATFLAG_SUCCESS;
}
