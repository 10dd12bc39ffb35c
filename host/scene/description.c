/* SPDX-License-Identifier: MIT */
/* The memory of a description. */
#include <stdlib.h>
#include <string.h>

#include "scene/reader_internal.h"

/* Refuses for want of memory, which has no place in the file. */
static void *fail_memory(struct scene_reader *reader) {
    static const struct scene_place nowhere = {0, 0};
    (void)scene_fail(reader, nowhere, "not enough memory to read the scene");
    return NULL;
}

void *scene_allocate(struct scene_reader *reader, size_t count, size_t size) {
    void *memory = memory_take(&reader->scene->memory, (count > 0 ? count : 1) * size);
    return memory != NULL ? memory : fail_memory(reader);
}

char *scene_copy(struct scene_reader *reader, const char *text) {
    size_t size = strlen(text) + 1;
    char *copy = scene_allocate(reader, size, 1);
    return copy != NULL ? memcpy(copy, text, size) : NULL;
}

void *scene_grow(struct scene_reader *reader, void *things, size_t count, size_t *room,
                 size_t size) {
    if (count < *room) {
        return things;
    }
    const size_t wanted = *room == 0 ? 64 : 2 * *room;
    void *larger = realloc(things, wanted * size);
    if (larger == NULL) {
        return fail_memory(reader);
    }
    *room = wanted;
    return larger;
}

void scene_description_free(struct scene_description *description) {
    if (description != NULL) {
        memory_free(&description->memory);
        free(description->nodes);
        free(description);
    }
}
