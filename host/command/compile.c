/* SPDX-License-Identifier: MIT */
/* superframe compile: a scene as const tables in C. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "command/command.h"
#include "compiler/emit.h"
#include "compiler/features.h"
#include "scene/load.h"

enum { NAME_SIZE = 128 };

int run_compile(const struct options *options) {
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
        scene_short_name(options->operands[0], name, sizeof name);
        errno = 0;
        int emitted = options->minimal ? features_emit(output.file, compiled, name)
                                       : scene_emit(output.file, compiled, name);
        if (emitted != 0) {
            output_complain(&output, errno != 0 ? strerror(errno) : "a write failed");
            output_discard(&output);
        } else if (output_commit(&output)) {
            status = STATUS_DONE;
        }
    }
    free(compiled);
    return status;
}
