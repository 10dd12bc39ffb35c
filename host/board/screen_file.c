/* SPDX-License-Identifier: MIT */
/* PNG files into and out of the emulated board. */
#include "board/screen_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/png_output.h"
#include "picture.h"
#include "png_file.h"

static bool native_take(struct native_screen *native, const char *path,
                        const struct png_image *image) {
    char message[160];
    if (image->width != NATIVE_WIDTH || image->height != NATIVE_HEIGHT) {
        complain("%s: the picture has %u x %u pixels; allowed is: 640 x 400, the PC-9801's own "
                 "screen",
                 path, image->width, image->height);
        return false;
    }
    if (!native_screen_from_rgb(native, image->rgb, message, sizeof message)) {
        complain("%s: %s", path, message);
        return false;
    }
    return true;
}

bool native_read(struct native_screen *native, const char *path) {
    struct png_image image;
    struct png_error error;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        complain("%s: cannot be read: %s", path, strerror(errno));
        return false;
    }
    enum png_status status = read_png(file, &image, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        complain("%s: %s; allowed is: a PNG of 640 x 400 pixels", path, error.message);
        return false;
    }
    bool is_taken = native_take(native, path, &image);
    free_png(&image);
    return is_taken;
}

static bool write_screen(struct output *output, const struct board *board,
                         const struct native_screen *native) {
    const uint8_t *plain = picture_in_memory(board, native);
    if (plain != NULL) {
        return png_output(output, plain, PICTURE_WIDTH, PICTURE_HEIGHT);
    }
    uint8_t *rgb = malloc(PICTURE_BYTES);
    if (rgb == NULL) {
        complain("out of memory");
        return false;
    }
    enum picture_state state = picture_draw(board, native, rgb);
    if (state != PICTURE_OK) {
        complain("the picture is black: %s", picture_state_text(state));
    }
    bool is_written = png_output(output, rgb, PICTURE_WIDTH, PICTURE_HEIGHT);
    free(rgb);
    return is_written;
}

bool board_picture_write(struct output *output, const struct board *board,
                         const struct native_screen *native, enum picture_kind kind) {
    if (kind == PICTURE_KIND_SCREEN) {
        return write_screen(output, board, native);
    }
    return png_output(output, board->memory, BOARD_WIDTH,
                      kind == PICTURE_KIND_WHOLE ? BOARD_MEMORY_HEIGHT : BOARD_HEIGHT);
}
