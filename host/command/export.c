/* SPDX-License-Identifier: MIT */
/* superframe export: a scene as source for another renderer. */
#include <errno.h>

#include "base/output.h"
#include "command/command.h"
#include "export/pov.h"
#include "scene/load.h"

/* Holds the options that `export` alone takes. */
struct export_options {
    struct options common;
    bool pov; /* source for POV-Ray */
};

static int write_source(const char *path, const struct scene_description *description,
                        const struct compiled_scene *scene) {
    struct output output;
    if (!output_open(&output, path)) {
        return STATUS_FAILED;
    }
    errno = 0;
    bool is_written = export_pov_write(output.file, description, scene);
    return output_finish(&output, is_written && !ferror(output.file));
}

static int run_export(const struct options *options) {
    struct scene_error error;
    struct scene_description *description =
        load_scene_with(options->operands[0], &options->overrides, &error);
    if (description == NULL) {
        return bad_input("%s", error.text);
    }
    struct compiled_scene *scene = scene_compile(description, &error);
    int status;
    if (scene == NULL || !export_pov_check(description, scene, &error)) {
        status = bad_input("%s", error.text);
    } else {
        status = write_source(options->output, description, scene);
    }
    compiled_scene_free(scene);
    scene_description_free(description);
    return status;
}

static bool check_export(const struct options *options, struct options_error *error) {
    if (!((const struct export_options *)options)->pov) {
        return options_refuse(error, "export: --pov is missing; it is the only kind of source");
    }
    return options->output != NULL ||
           options_refuse(error, "export: -o FILE is missing; -o - is standard output");
}

static const struct option_group group_own = {
    "Result", OPTION_ENTRIES({.name = "pov",
                              FLAG_IN(struct export_options, pov),
                              .help = "write source for POV-Ray 3.7"})};

const struct command command_export = {
    .name = "export",
    COMMAND_OPERANDS("SCENE", 1, 1, OPERANDS_SCENES),
    .summary = "Write a scene for POV-Ray.",
    .size = sizeof(struct export_options),
    .groups = OPTION_GROUPS(&group_result, &group_own, &group_scene),
    .examples =
        COMMAND_EXAMPLES("export fig3 --pov -o fig3.pov", "export my.scene --pov --depth 20 -o -"),
    .check = check_export,
    .run = run_export};
