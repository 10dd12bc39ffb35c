/* SPDX-License-Identifier: MIT */
/* Scenes by the names that people give them: a built-in one or a file. */
#include "scene/load.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/nearest.h"
#include "scene/builtin.h"

/* The most that is read of a file. BYTES_MOST is more than the reader takes, so that the reader
 * says what is allowed. The limit also ends the reading of an endless file. */
enum { BYTES_MOST = 65 * 1024 * 1024, CHUNK = 65536, BUILTIN_MOST = 32 };

/* What messages call a scene from there. */
static const char STANDARD_INPUT[] = "standard input";

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

/* Finds the built-in scene that a misspelled name may stand for; NULL if none comes near. */
static const char *nearest_builtin(const char *name) {
    const char *names[BUILTIN_MOST + 1] = {NULL};
    for (size_t i = 0; i < BUILTIN_MOST && i < builtin_scene_count; i++) {
        names[i] = builtin_scenes[i].name;
    }
    return nearest_word(name, names);
}

/* Refuses a name that is no readable file, and lists the built-in scenes as what is allowed. */
static void refuse_name(struct scene_error *error, const char *name, int error_number) {
    char names[200] = "", meant[64] = "";
    const char *near = error_number == ENOENT ? nearest_builtin(name) : NULL;
    size_t used = 0;
    for (size_t i = 0; i < builtin_scene_count && used < sizeof names; i++) {
        int letters = snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                               builtin_scenes[i].name);
        used += letters > 0 ? (size_t)letters : 0;
    }
    if (near != NULL) {
        (void)snprintf(meant, sizeof meant, "did you mean %.40s? ", near);
    }
    (void)snprintf(
        error->text, sizeof error->text,
        "%.120s: cannot be read: %.80s; %s%s is: a scene file, or a built-in scene (%.160s)", name,
        strerror(error_number), meant, near != NULL ? "Allowed" : "allowed", names);
}

static struct scene_description *
load_file(const char *path, const struct scene_overrides *overrides, struct scene_error *error) {
    struct stat facts;
    size_t length = 0;
    bool is_standard = strcmp(path, "-") == 0;
    FILE *file = is_standard ? stdin : fopen(path, "rb");
    if (file == NULL) {
        refuse_name(error, path, errno);
        return NULL;
    }
    if (!is_standard && fstat(fileno(file), &facts) == 0 && S_ISDIR(facts.st_mode)) {
        (void)fclose(file);
        return refuse(error, path, "is a folder; allowed is: a scene file");
    }
    char *text = read_all(file, &length);
    int error_number = errno;
    if (!is_standard) {
        (void)fclose(file);
    }
    if (text == NULL) {
        refuse_name(error, path, error_number);
        return NULL;
    }
    const char *shown = is_standard ? STANDARD_INPUT : path;
    struct scene_description *description =
        scene_description_read_with(shown, text, length, overrides, error);
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

struct scene_description *load_scene_with(const char *name_or_path,
                                          const struct scene_overrides *overrides,
                                          struct scene_error *error) {
    const struct builtin_scene *scene = find_builtin(name_or_path);
    struct scene_description *description =
        scene != NULL
            ? scene_description_read_with(scene->name, scene->text, scene->length, overrides, error)
            : load_file(name_or_path, overrides, error);
    if (description != NULL) {
        scene_override(description, overrides);
    }
    return description;
}

struct scene_description *load_scene(const char *name_or_path, struct scene_error *error) {
    static const struct scene_overrides none;
    return load_scene_with(name_or_path, &none, error);
}

void scene_short_name(const char *name_or_path, char *name, size_t size) {
    const char *slash = strrchr(name_or_path, '/');
    const char *start = strcmp(name_or_path, "-") == 0 ? "scene"
                        : slash == NULL                ? name_or_path
                                                       : slash + 1;
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
