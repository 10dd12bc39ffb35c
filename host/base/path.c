/* SPDX-License-Identifier: MIT */
/* Paths of files: joined, followed through links, and resolved so that they can be compared. */
/* realpath() is of POSIX 2008, but glibc declares it only with this switch. */
#define _XOPEN_SOURCE 700 // NOLINT(bugprone-reserved-identifier): glibc's own switch
#include "base/path.h"

#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LINKS_MOST = 40 };

char *path_join(const char *folder, const char *name) {
    size_t size = strlen(folder) + strlen(name) + 2;
    char *path = malloc(size);
    if (path != NULL) {
        (void)snprintf(path, size, "%s/%s", folder, name);
    }
    return path;
}

/* Returns the length of the folder's part of a path, its last slash included. */
static size_t folder_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash == NULL ? 0 : (size_t)(slash - path) + 1;
}

char *path_beside(const char *path, const char *name) {
    size_t folder = name[0] == '/' ? 0 : folder_length(path);
    size_t size = folder + strlen(name) + 1;
    char *joined = malloc(size);
    if (joined != NULL) {
        memcpy(joined, path, folder);
        memcpy(joined + folder, name, size - folder);
    }
    return joined;
}

char *path_follow_links(const char *path) {
    char *place = path_beside("", path);
    for (int links = 0; place != NULL; links++) {
        char name[PATH_MAX];
        ssize_t length = readlink(place, name, sizeof name - 1);
        if (length < 0) {
            return place; /* no link: the place itself, there or not */
        }
        name[length] = '\0';
        char *next = path_beside(place, name);
        free(place);
        place = next;
        if (links == LINKS_MOST) {
            free(place);
            errno = ELOOP;
            return NULL;
        }
    }
    errno = ENOMEM;
    return NULL;
}

/* Appends the parts of a path that do not exist yet to the folder that does. */
static char *append_parts(char *folder, char *parts) {
    for (char *part = strtok(parts, "/"); part != NULL && folder != NULL;
         part = strtok(NULL, "/")) {
        if (strcmp(part, ".") != 0) {
            char *longer = path_join(strcmp(folder, "/") == 0 ? "" : folder, part);
            free(folder);
            folder = longer;
        }
    }
    return folder;
}

char *path_resolve(const char *path) {
    char *place = path_follow_links(path);
    if (place == NULL) {
        return NULL;
    }
    char *resolved = realpath(place, NULL);
    size_t there = strlen(place);
    while (resolved == NULL && there > 0) {
        do {
            there--;
        } while (there > 0 && place[there] != '/');
        char before = place[there];
        place[there] = '\0';
        resolved = realpath(there > 0 ? place : before == '/' ? "/" : ".", NULL);
        place[there] = before;
    }
    if (resolved != NULL) {
        resolved = append_parts(resolved, place + there);
    }
    free(place);
    return resolved;
}
