/* SPDX-License-Identifier: MIT */
/* A folder of its own for each test of the suites that write files. */
#ifndef SUPERFRAME_TESTS_FOLDER_FIXTURE_H
#define SUPERFRAME_TESTS_FOLDER_FIXTURE_H

#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* Each test runs in a new folder of its own. */
struct place {
    char before[4096];
    char folder[64];
};

static inline int enter(void **state) {
    struct place *place = calloc(1, sizeof *place);
    if (place == NULL || getcwd(place->before, sizeof place->before) == NULL) {
        return -1;
    }
    strcpy(place->folder, "/tmp/superframe-folder-XXXXXX");
    *state = place;
    return mkdtemp(place->folder) == NULL || chdir(place->folder) != 0 ? -1 : 0;
}

/* The number of files; their names, if wanted, are removed as well. */
static inline int count_files(bool removes) {
    int count = 0;
    DIR *folder = opendir(".");
    struct dirent *entry;
    while ((entry = readdir(folder)) != NULL) {
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0) {
            count++;
            if (removes && remove(entry->d_name) != 0) {
                (void)fprintf(stderr, "%s stays\n", entry->d_name);
            }
        }
    }
    (void)closedir(folder);
    return count;
}

static inline int leave(void **state) {
    struct place *place = *state;
    (void)count_files(true);
    int failed = chdir(place->before) != 0 || rmdir(place->folder) != 0;
    free(place);
    return failed ? -1 : 0;
}

static inline void put(const char *path, const char *text) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

static inline void assert_holds(const char *path, const char *text) {
    char bytes[64] = "";
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    bytes[fread(bytes, 1, sizeof bytes - 1, file)] = '\0';
    (void)fclose(file);
    assert_string_equal(bytes, text);
}

#endif
