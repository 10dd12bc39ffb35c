/* SPDX-License-Identifier: MIT */
/* Scenes by the names that people give them: a built-in one or a file. */
#include "scene/load.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "scene/builtin.h"

/* The most that is read of a file. BYTES_MOST is more than the reader takes, so that the reader
 * says what is allowed. The limit also ends the reading of an endless file. */
enum { BYTES_MOST = 2 * 1024 * 1024, CHUNK = 65536 };

static void *refuse(struct scene_error *error, const char *path, const char *reason) {
    (void)snprintf(error->text, sizeof error->text, "%.200s: %.200s", path, reason);
    return NULL;
}

/* Reads all of a file, at most BYTES_MOST. Returns NULL with errno set on failure. */
static char *read_all(FILE *file, size_t *length) {
    char *text = NULL;
    size_t used = 0, got;
    do {
        char *larger = realloc(text, used + CHUNK);
        if (larger == NULL) {
            free(text);
            errno = ENOMEM;
            return NULL;
        }
        text = larger;
        errno = 0;
        got = fread(text + used, 1, CHUNK, file);
        used += got;
    } while (got == CHUNK && used < BYTES_MOST);
    if (ferror(file)) {
        free(text);
        return NULL;
    }
    *length = used;
    return text;
}

/* Refuses a name that is no readable file, and lists the built-in scenes as what is allowed. */
static void refuse_name(struct scene_error *error, const char *name, int error_number) {
    char names[256] = "";
    size_t used = 0;
    for (size_t i = 0; i < builtin_scene_count && used < sizeof names; i++) {
        int letters = snprintf(names + used, sizeof names - used, "%s, ", builtin_scenes[i].name);
        used += letters > 0 ? (size_t)letters : 0;
    }
    (void)snprintf(error->text, sizeof error->text,
                   "%.150s: cannot be read: %s; allowed is: a scene file, or a built-in scene "
                   "(%.*s)",
                   name, strerror(error_number), (int)(strlen(names) > 2 ? strlen(names) - 2 : 0),
                   names);
}

static struct scene_description *load_file(const char *path, struct scene_error *error) {
    struct stat facts;
    size_t length = 0;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        refuse_name(error, path, errno);
        return NULL;
    }
    if (fstat(fileno(file), &facts) == 0 && S_ISDIR(facts.st_mode)) {
        (void)fclose(file);
        return refuse(error, path, "is a folder; allowed is: a scene file");
    }
    char *text = read_all(file, &length);
    int error_number = errno;
    (void)fclose(file);
    if (text == NULL) {
        refuse_name(error, path, error_number);
        return NULL;
    }
    struct scene_description *description = scene_description_read(path, text, length, error);
    free(text);
    return description;
}

/* Finds the built-in scene of a name. NULL: no built-in scene has that name. */
static const struct builtin_scene *find_builtin(const char *name) {
    for (size_t i = 0; i < builtin_scene_count; i++) {
        if (strcmp(builtin_scenes[i].name, name) == 0) {
            return &builtin_scenes[i];
        }
    }
    return NULL;
}

bool scene_is_builtin(const char *name_or_path) {
    return find_builtin(name_or_path) != NULL;
}

struct scene_description *load_scene(const char *name_or_path, struct scene_error *error) {
    const struct builtin_scene *scene = find_builtin(name_or_path);
    return scene != NULL ? scene_description_read(scene->name, scene->text, scene->length, error)
                         : load_file(name_or_path, error);
}

void scene_short_name(const char *name_or_path, char *name, size_t size) {
    const char *slash = strrchr(name_or_path, '/');
    const char *start = slash == NULL ? name_or_path : slash + 1;
    (void)snprintf(name, size, "%s", start);
    char *dot = strrchr(name, '.');
    if (dot != NULL && dot != name) {
        *dot = '\0';
    }
}

void scene_picture_name(const char *name_or_path, char *name, size_t size) {
    static const char ending[] = ".png";
    scene_short_name(name_or_path, name, size - (sizeof ending - 1));
    strcat(name, ending);
}
