/* SPDX-License-Identifier: MIT */
/* superframe compile: a scene as const tables in C. */
#include <errno.h>

#include "base/output.h"
#include "command/command.h"
#include "compiler/emit.h"
#include "compiler/features.h"
#include "scene/load.h"

enum { NAME_SIZE = 128 };

/* Holds the options that `compile` alone takes. */
struct compile_options {
    struct options common;
    bool minimal; /* a feature_set.h instead of the tables */
};

static int run_compile(const struct options *options) {
    struct output output;
    struct scene_error error;
    char name[NAME_SIZE];
    struct compiled_scene *compiled =
        load_compiled_scene(options->operands[0], &options->overrides, &error);
    if (compiled == NULL) {
        return bad_input("%s", error.text);
    }
    int status = STATUS_FAILED;
    if (output_open(&output, options->output)) {
        const bool is_minimal = ((const struct compile_options *)options)->minimal;
        scene_short_name(options->operands[0], name, sizeof name);
        errno = 0;
        int emitted = is_minimal ? features_emit(output.file, compiled, name)
                                 : scene_emit(output.file, compiled, name);
        status = output_finish(&output, emitted == 0);
    }
    compiled_scene_free(compiled);
    return status;
}

static bool check_compile(const struct options *options, struct options_error *error) {
    return options->output != NULL ||
           options_refuse(error, "compile: -o FILE.c is missing; -o - is standard output");
}

static const struct option_group group_own = {
    "Result", OPTION_ENTRIES({.name = "minimal",
                              FLAG_IN(struct compile_options, minimal),
                              .help = "write the feature_set.h of an image for this scene alone"})};

const struct command command_compile = {
    .name = "compile",
    COMMAND_OPERANDS("SCENE", 1, 1, OPERANDS_SCENES),
    .summary = "Write a scene as const tables for a firmware image.",
    .size = sizeof(struct compile_options),
    .groups = OPTION_GROUPS(&group_result, &group_own, &group_scene),
    .examples =
        COMMAND_EXAMPLES("compile fig3 -o fig3.c", "compile my.scene --minimal -o feature_set.h"),
    .check = check_compile,
    .run = run_compile};
