/* SPDX-License-Identifier: MIT */
/* The scene compiler: how colours are shown. */
#include "compiler/compiler_internal.h"

#include "board.h"

bool compile_colour(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    static const enum compiled_show shows[] = {[COLOUR_FULL] = COMPILED_FULL,
                                               [COLOUR_BITS] = COMPILED_BITS,
                                               [COLOUR_DITHER] = COMPILED_DITHER,
                                               [COLOUR_EXPOSURES] = COMPILED_EXPOSURES};
    scene->show = (uint8_t)shows[description->colour];
    scene->show_bits = (uint8_t)(description->colour == COLOUR_BITS ? description->colour_bits : 8);
    scene->seed = description->seed;
    if (description->colour == COLOUR_DITHER &&
        (description->width > BOARD_WIDTH / 2 || description->height > BOARD_HEIGHT / 2)) {
        return compile_fail(compiler, 0,
                            "colour \"dither\" with %d x %d pixels, each of 2 x 2 dots; allowed "
                            "is: up to %d x %d, or another colour",
                            description->width, description->height, BOARD_WIDTH / 2,
                            BOARD_HEIGHT / 2);
    }
    return true;
}
