/* SPDX-License-Identifier: MIT */
/* The firmware, one scene and the emulated board as a WebAssembly module. */
#include "superframe.h"

#include "board.h"
#include "image.h"
#include "outp.h"
#include "scene.h"

#define EXPORT(name) __attribute__((export_name(name)))

enum { BYTE = 1, WORD = 2 };

/* The build names both. */
extern const struct image TARGET_IMAGE;
extern const struct scene TARGET_SCENE;

static struct board board;

void outp(uint16_t port, uint8_t value) {
    board_write(&board, port, value, BYTE);
    page_port_write(port, value, BYTE);
}

void outpw(uint16_t port, uint16_t value) {
    board_write(&board, port, value, WORD);
    page_port_write(port, value, WORD);
}

uint8_t inp(uint16_t port) {
    return (uint8_t)board_read(&board, port, BYTE);
}

uint16_t inpw(uint16_t port) {
    return (uint16_t)board_read(&board, port, WORD);
}

EXPORT("superframe_width") uint32_t superframe_width(void) {
    return TARGET_SCENE.width;
}

EXPORT("superframe_height") uint32_t superframe_height(void) {
    return TARGET_SCENE.height;
}

EXPORT("superframe_reset") void superframe_reset(void) {
    const struct board_desc desc = board_default_desc(BOARD_1987);
    (void)board_init(&board, &desc);
}

EXPORT("superframe_draw") void superframe_draw(uint32_t first, uint32_t last) {
    const struct drawing drawing = {
        .base = BOARD_FACTORY_BASE, .first = (uint16_t)first, .last = (uint16_t)last};
    TARGET_IMAGE.draw(&TARGET_SCENE, &drawing);
}

EXPORT("superframe_pixels") uint32_t superframe_pixels(void) {
    return (uint32_t)(uintptr_t)board.memory;
}

EXPORT("superframe_violations") uint32_t superframe_violations(void) {
    return (uint32_t)board_violations(&board);
}
