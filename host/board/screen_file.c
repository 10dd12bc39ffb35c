/* SPDX-License-Identifier: MIT */
/* Pictures into and out of the emulated board. */
#include "board/screen_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/complain.h"
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

/* Returns the screen's 640 x 400 pixels; *state: why they are black, if they are. */
static const uint8_t *screen_of(const struct board *board, const struct native_screen *native,
                                uint8_t rgb[PICTURE_BYTES], enum picture_state *state) {
    const uint8_t *plain = picture_in_memory(board, native);
    *state = PICTURE_OK;
    if (plain != NULL) {
        return plain;
    }
    *state = picture_draw(board, native, rgb);
    return rgb;
}

/* Returns the picture of a kind; *state: why a screen is black, if it is. */
static struct shown_picture picture_of(const struct board *board,
                                       const struct native_screen *native, enum picture_kind kind,
                                       uint8_t rgb[PICTURE_BYTES], enum picture_state *state) {
    struct shown_picture picture = {board->memory, BOARD_WIDTH, BOARD_HEIGHT};
    *state = PICTURE_OK;
    switch (kind) {
    case PICTURE_KIND_SCREEN:
        picture.rgb = screen_of(board, native, rgb, state);
        break;
    case PICTURE_KIND_MEMORY:
        break;
    case PICTURE_KIND_WHOLE:
        picture.height = BOARD_MEMORY_HEIGHT;
        break;
    }
    return picture;
}

struct shown_picture board_picture(const struct board *board, const struct native_screen *native,
                                   enum picture_kind kind, uint8_t rgb[PICTURE_BYTES]) {
    enum picture_state state;
    return picture_of(board, native, kind, rgb, &state);
}

bool board_picture_finish(struct picture_sink *sink, const struct board *board,
                          const struct native_screen *native, enum picture_kind kind,
                          uint8_t rgb[PICTURE_BYTES]) {
    enum picture_state state;
    const struct shown_picture picture = picture_of(board, native, kind, rgb, &state);
    if (state != PICTURE_OK) {
        complain("the picture is black: %s", picture_state_text(state));
    }
    return picture_sink_finish(sink, &picture);
}
