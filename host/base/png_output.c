/* SPDX-License-Identifier: MIT */
/* Writes a picture as a PNG and puts the file into its place. */
#include "base/png_output.h"

#include "png_file.h"

bool png_output(struct output *output, const uint8_t *rgb, unsigned width, unsigned height) {
    struct png_error error;
    if (write_png(output->file, rgb, width, height, &error) != PNG_OK) {
        output_complain(output, error.message);
        output_discard(output);
        return false;
    }
    return output_commit(output);
}
