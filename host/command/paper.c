/* SPDX-License-Identifier: MIT */
/* superframe paper: every figure of the paper, and its claims measured. */
#include "lab/paper/paper.h"
#include "command/command.h"

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
    .run = paper_run};
