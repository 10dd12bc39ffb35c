/* SPDX-License-Identifier: MIT */
/* superframe paper: every figure of the paper, and its claims measured. */
#include "lab/paper/paper.h"
#include "command/command.h"

static int run_paper(const struct options *options) {
    const struct scene_overrides *overrides = &options->overrides;
    if (overrides->width > PAPER_SMALL_WIDTH || overrides->height > PAPER_SMALL_HEIGHT) {
        return bad_input("--size %dx%d: it is that of the paper's small pictures, the large ones "
                         "have twice that; allowed is: 1x1..%dx%d",
                         overrides->width, overrides->height, PAPER_SMALL_WIDTH,
                         PAPER_SMALL_HEIGHT);
    }
    return paper_run(options);
}

static bool check_paper(const struct options *options, struct options_error *error) {
    return options->output != NULL || options_refuse(error, "paper: -o FOLDER is missing");
}

const struct command command_paper = {
    .name = "paper",
    .operands = "",
    .summary = "Make every figure of the paper, and measure its claims.",
    .groups = OPTION_GROUPS(&group_folder, &group_small_size, &group_arithmetic, &group_jobs,
                            &group_quiet),
    .examples = COMMAND_EXAMPLES("paper -o paper --jobs 2", "paper -o quick --size 80x50"),
    .check = check_paper,
    .run = run_paper};
