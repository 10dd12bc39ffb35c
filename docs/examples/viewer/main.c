/* SPDX-License-Identifier: MIT */
/* A picture viewer: viewer PICTURE.png SCREEN.png
 *
 * Reads a PNG of at most 640 x 400 pixels, shows it on an emulated board through the ports, and
 * writes what the CRT then shows. */
#include "viewer.h"

#include <superframe/board.h>
#include <superframe/picture.h>
#include <superframe/png_file.h>

static int complain(const char *path, const char *reason) {
    (void)fprintf(stderr, "viewer: %s: %s\n", path, reason);
    return 1;
}

static int write_screen(const struct board *board, const char *path) {
    static uint8_t rgb[PICTURE_BYTES];
    struct png_error error;
    (void)picture_draw(board, NULL, rgb);
    FILE *file = fopen(path, "wb");
    if (file == NULL) {
        return complain(path, "can't be written");
    }
    enum png_status status = write_png(file, rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error);
    if (fclose(file) != 0 || status != PNG_OK) {
        return complain(path, status != PNG_OK ? error.message : "can't be written");
    }
    return 0;
}

static int view(const struct png_image *image, const char *from, const char *to) {
    static struct board board;
    struct board_desc desc = board_default_desc(BOARD_1987);
    struct board_bus bus;
    if (!board_init(&board, &desc)) {
        return complain("00D0", "no such board");
    }
    board_bus_init(&bus, &board);
    (void)bus_bind(&bus.bus);
    if (!board_is_present()) {
        return complain("00D0", "no board answers");
    }
    if (!show_picture(image->rgb, image->width, image->height)) {
        return complain(from, "larger than the screen; allowed is at most 640 x 400");
    }
    return write_screen(&board, to);
}

int main(int argc, char **argv) {
    struct png_image image;
    struct png_error error;
    if (argc != 3) {
        return complain("usage", "viewer PICTURE.png SCREEN.png");
    }
    FILE *file = fopen(argv[1], "rb");
    if (file == NULL) {
        return complain(argv[1], "can't be read");
    }
    enum png_status status = read_png(file, &image, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        return complain(argv[1], error.message);
    }
    int result = view(&image, argv[1], argv[2]);
    free_png(&image);
    return result;
}
