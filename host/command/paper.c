/* SPDX-License-Identifier: MIT */
/* superframe paper: every figure of the paper, and its claims measured. */
#include "lab/paper/paper.h"
#include "command/command.h"

int run_paper(const struct options *options) {
    const struct scene_overrides *overrides = &options->overrides;
    if (overrides->has_size &&
        (overrides->width > PAPER_SMALL_WIDTH || overrides->height > PAPER_SMALL_HEIGHT)) {
        return bad_input("--size %dx%d: it is that of the paper's small pictures, the large ones "
                         "have twice that; allowed is: 1x1..%dx%d",
                         overrides->width, overrides->height, PAPER_SMALL_WIDTH,
                         PAPER_SMALL_HEIGHT);
    }
    return paper_run(options);
}
