/* SPDX-License-Identifier: MIT */
/* A short text that stays the same for as long as a compiled scene does. */
#include "compiler/digest.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include <xxhash.h>

#include "compiler/emit.h"

bool scene_digest(const struct compiled_scene *scene, char digest[SCENE_DIGEST_SIZE]) {
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    if (file == NULL) {
        return false;
    }
    bool is_written = scene_emit(file, scene, "digest") == 0;
    is_written = fclose(file) == 0 && is_written;
    if (is_written) {
        (void)snprintf(digest, SCENE_DIGEST_SIZE, "%016" PRIx64,
                       (uint64_t)XXH3_64bits(text, length));
    }
    free(text);
    return is_written;
}
