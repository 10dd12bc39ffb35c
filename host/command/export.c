/* SPDX-License-Identifier: MIT */
/* superframe export: a scene as source for another renderer. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "command/command.h"
#include "export/pov.h"
#include "scene/load.h"

static int write_source(const char *path, const struct scene_description *description,
                        const struct compiled_scene *scene) {
    struct output output;
    if (!output_open(&output, path)) {
        return STATUS_FAILED;
    }
    errno = 0;
    export_pov_write(output.file, description, scene);
    if (ferror(output.file)) {
        output_complain(&output, errno != 0 ? strerror(errno) : "a write failed");
        output_discard(&output);
        return STATUS_FAILED;
    }
    return output_commit(&output) ? STATUS_DONE : STATUS_FAILED;
}

int run_export(const struct options *options) {
    struct scene_error error;
    struct scene_description *description = load_scene(options->operands[0], &error);
    if (description == NULL) {
        return bad_input("%s", error.text);
    }
    scene_override(description, &options->overrides);
    struct compiled_scene *scene = scene_compile(description, &error);
    int status;
    if (scene == NULL || !export_pov_check(description, scene, &error)) {
        status = bad_input("%s", error.text);
    } else {
        status = write_source(options->output, description, scene);
    }
    free(scene);
    scene_description_free(description);
    return status;
}
