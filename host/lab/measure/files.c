/* SPDX-License-Identifier: MIT */
/* The files that `superframe measure` writes into its folder. */
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/path.h"
#include "lab/measure/measure.h"

bool measure_create(struct measure_file *file, const struct measure *measure, const char *name) {
    memset(file, 0, sizeof *file);
    file->path = path_join(measure->folder, name);
    if (file->path == NULL) {
        complain("out of memory");
        return false;
    }
    if (!output_open(&file->output, file->path)) {
        measure_discard(file);
        return false;
    }
    return true;
}

int measure_close(struct measure_file *file) {
    bool is_written = output_commit(&file->output);
    measure_discard(file);
    return is_written ? STATUS_DONE : STATUS_FAILED;
}

void measure_discard(struct measure_file *file) {
    output_discard(&file->output);
    free(file->path);
    file->path = NULL;
}
