/* SPDX-License-Identifier: MIT */
/* The memory of a description, and why it can't be read. */
#include "scene/reader_internal.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool scene_fail(struct scene_reader *reader, unsigned line, const char *format, ...) {
    char *text = reader->error->text;
    size_t size = sizeof reader->error->text;
    int used = snprintf(text, size, "%.200s:%u: ", reader->path, line ? line : 1);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - (size_t)used, format, arguments);
    va_end(arguments);
    for (; *text; text++) {
        if ((unsigned char)*text < 0x20 || *text == 0x7F) {
            *text = '?'; /* whatever the file holds, the message stays one line */
        }
    }
    return false;
}

void *scene_allocate(struct scene_reader *reader, size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) {
        scene_fail(reader, 1, "not enough memory to read the scene");
    }
    return memory;
}

char *scene_copy(struct scene_reader *reader, const char *text) {
    size_t size = strlen(text) + 1;
    char *copy = scene_allocate(reader, size, 1);
    if (copy) {
        memcpy(copy, text, size);
    }
    return copy;
}

void scene_description_free(struct scene_description *description) {
    if (!description) {
        return;
    }
    for (size_t i = 0; i < description->material_count; i++) {
        free(description->materials[i].name);
    }
    for (size_t i = 0; i < description->node_count; i++) {
        free(description->nodes[i].planes);
        free(description->nodes[i].children);
    }
    for (size_t i = 0; i < description->object_count; i++) {
        free(description->objects[i].name);
    }
    free(description->lights);
    free(description->materials);
    free(description->nodes);
    free(description->objects);
    free(description->title);
    free(description->path);
    free(description);
}
