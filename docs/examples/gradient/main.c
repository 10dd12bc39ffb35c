/* SPDX-License-Identifier: MIT */
/* Draws the gradient on an emulated board: gradient FILE.png */
#include "gradient.h"

#include <superframe/board.h>
#include <superframe/picture.h>
#include <superframe/png_file.h>

int main(int argc, char **argv) {
    static struct board board;
    static uint8_t rgb[PICTURE_BYTES];
    struct board_desc desc = board_default_desc(BOARD_1987);
    struct board_bus bus;
    struct png_error error = {PNG_IO_ERROR, "usage: gradient FILE.png"};
    if (argc == 2 && board_init(&board, &desc)) {
        board_bus_init(&bus, &board);
        (void)bus_bind(&bus.bus); /* from here on outp() reaches the board */
        draw_gradient();
        (void)picture_draw(&board, NULL, rgb);
        FILE *file = fopen(argv[1], "wb");
        if (file != NULL) {
            (void)write_png(file, rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error);
            if (fclose(file) != 0) {
                error.status = PNG_IO_ERROR;
            }
        }
    }
    if (error.status != PNG_OK) {
        (void)fprintf(stderr, "gradient: %s\n", error.message);
    }
    return error.status == PNG_OK ? 0 : 1;
}
