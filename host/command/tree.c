/* SPDX-License-Identifier: MIT */
/* superframe tree: the tree of rays of one pixel, as in the paper's Fig. 2. */
#include <errno.h>
#include <stdlib.h>

#include "base/numbers.h"
#include "base/output.h"
#include "command/command.h"
#include "render/arithmetic.h"
#include "render/ray_tree.h"
#include "scene/load.h"

/* Holds the options that `tree` alone takes. */
struct tree_options {
    struct options common;
    bool dot; /* a graph for Graphviz */
};

static int print_tree(const struct options *options, const struct compiled_scene *compiled,
                      const struct ray_tree *tree) {
    struct output output;
    if (!output_open(&output, options->output ? options->output : "-")) {
        return STATUS_FAILED;
    }
    const bool is_dot = ((const struct tree_options *)options)->dot;
    errno = 0;
    int printed = is_dot          ? ray_tree_print_dot(output.file, tree, compiled)
                  : options->json ? ray_tree_print_json(output.file, tree, compiled)
                                  : ray_tree_print(output.file, tree, compiled);
    return output_finish(&output, printed == 0);
}

static int grow_and_print(const struct options *options, const struct compiled_scene *compiled,
                          uint16_t x, uint16_t y) {
    struct scene_error error;
    struct ray_tree tree;
    const struct arithmetic *arithmetic =
        arithmetic_for(arithmetic_find(options->arithmetic), compiled);
    struct scene *scene = arithmetic->load(compiled, &error);
    if (scene == NULL) {
        return bad_input("%s", error.text);
    }
    struct estimate estimate;
    struct render_counts counts = {0};
    arithmetic->learn(scene, &estimate, &counts);
    int status = STATUS_FAILED;
    if (ray_tree_grow(&tree, arithmetic, scene, x, y)) {
        status = print_tree(options, compiled, &tree);
    } else {
        complain("the tree has more than %d nodes; a smaller --depth or a larger --threshold "
                 "makes it smaller",
                 RAY_TREE_NODES_MOST);
    }
    ray_tree_free(&tree);
    free(scene);
    return status;
}

static int run_tree(const struct options *options) {
    struct scene_error error;
    uint64_t x, y;
    struct compiled_scene *compiled =
        load_compiled_scene(options->operands[0], &options->overrides, &error);
    if (compiled == NULL) {
        return bad_input("%s", error.text);
    }
    int status;
    if (!value_whole(options->operands[1], 0, compiled->width - 1u, &x) ||
        !value_whole(options->operands[2], 0, compiled->height - 1u, &y)) {
        status = bad_input("tree: pixel %.40s %.40s is invalid; allowed is: X 0..%d, Y 0..%d",
                           options->operands[1], options->operands[2], compiled->width - 1,
                           compiled->height - 1);
    } else {
        status = grow_and_print(options, compiled, (uint16_t)x, (uint16_t)y);
    }
    compiled_scene_free(compiled);
    return status;
}

static bool check_tree(const struct options *options, struct options_error *error) {
    return !(((const struct tree_options *)options)->dot && options->json) ||
           options_refuse(error, "--dot and --json exclude each other; give one of them");
}

static const struct option_group group_own = {
    "Result",
    OPTION_ENTRIES(
        {.name = "dot", FLAG_IN(struct tree_options, dot), .help = "a graph for Graphviz"})};

const struct command command_tree = {
    .name = "tree",
    COMMAND_OPERANDS("SCENE X Y", 3, 3, OPERANDS_SCENE_FIRST),
    .summary = "Print the tree of rays of one pixel.",
    .size = sizeof(struct tree_options),
    .groups =
        OPTION_GROUPS(&group_result, &group_own, &group_json, &group_scene, &group_arithmetic),
    .examples =
        COMMAND_EXAMPLES("tree fig3 100 80", "tree fig3 100 80 --dot | dot -Tpng -o tree.png"),
    .check = check_tree,
    .run = run_tree};
