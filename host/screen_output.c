/* SPDX-License-Identifier: MIT */
/* What the CRT shows as a PNG in its place. */
#include "screen_output.h"

#include "command.h"
#include "png_file.h"

bool screen_write(struct output *output, struct port_chain *chain) {
    struct png_error error;
    port_chain_picture(chain);
    if (chain->picture_state != PICTURE_OK) {
        complain("the picture is black: %s", picture_state_text(chain->picture_state));
    }
    if (write_png(output->file, chain->rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error) != PNG_OK) {
        output_complain(output, error.message);
        return false;
    }
    return output_commit(output);
}
