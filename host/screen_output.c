/* SPDX-License-Identifier: MIT */
/* What the CRT shows as a PNG in its place. */
#include "screen_output.h"

#include "png_file.h"

bool picture_write(struct output *output, const uint8_t rgb[PICTURE_BYTES]) {
    struct png_error error;
    if (write_png(output->file, rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error) != PNG_OK) {
        output_complain(output, error.message);
        return false;
    }
    return output_commit(output);
}
