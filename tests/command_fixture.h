/* SPDX-License-Identifier: MIT */
/* The program as its users call it, for the suites that do: a folder of its own for each test, and
 * lines of shell with `superframe` on their path.
 *
 * SUPERFRAME names the program (build/sanitized/superframe). */
#ifndef SUPERFRAME_TESTS_COMMAND_FIXTURE_H
#define SUPERFRAME_TESTS_COMMAND_FIXTURE_H

#include <dirent.h>
#include <sys/stat.h>

#include "shell_fixture.h"

struct place {
    char before[PATH_SIZE];
    char folder[64];
};

static inline int enter_group(void **state) {
    (void)state;
    char program[2 * PATH_SIZE], path[2 * PATH_SIZE], here[PATH_SIZE] = "";
    static char folder[] = "/tmp/superframe-bin-XXXXXX";
    const char *name = getenv("SUPERFRAME");
    name = name != NULL ? name : "build/sanitized/superframe";
    if (name[0] != '/' && getcwd(here, sizeof here) == NULL) {
        return -1;
    }
    (void)snprintf(program, sizeof program, "%s/%s", here, name);
    if (access(program, X_OK) != 0 || mkdtemp(folder) == NULL) {
        (void)fprintf(stderr, "SUPERFRAME does not name the program\n");
        return -1;
    }
    (void)snprintf(path, sizeof path, "%s/superframe", folder);
    if (symlink(program, path) != 0) {
        return -1;
    }
    (void)snprintf(path, sizeof path, "%s:%s", folder, getenv("PATH"));
    /* A sanitizer's report must not pass for one of the program's own statuses. */
    return setenv("PATH", path, 1) | setenv("ASAN_OPTIONS", "exitcode=99", 1) |
           setenv("UBSAN_OPTIONS", "exitcode=99:print_stacktrace=1", 1) |
           setenv("LSAN_OPTIONS", "exitcode=99", 1);
}

static inline int leave_group(void **state) {
    (void)state;
    char folder[64];
    const char *path = getenv("PATH");
    size_t length = strcspn(path, ":");
    if (length >= sizeof folder - sizeof "/superframe") {
        return -1;
    }
    memcpy(folder, path, length);
    folder[length] = '\0';
    char link[80];
    (void)snprintf(link, sizeof link, "%s/superframe", folder);
    return unlink(link) | rmdir(folder);
}

static inline int enter(void **state) {
    struct place *place = calloc(1, sizeof *place);
    if (place == NULL || getcwd(place->before, sizeof place->before) == NULL) {
        return -1;
    }
    strcpy(place->folder, "/tmp/superframe-command-XXXXXX");
    *state = place;
    return mkdtemp(place->folder) == NULL || chdir(place->folder) != 0 ? -1 : 0;
}

static inline int leave(void **state) {
    struct place *place = *state;
    char line[128];
    (void)snprintf(line, sizeof line, "rm -rf %s", place->folder);
    int failed = chdir(place->before) != 0 || system(line) != 0;
    free(place);
    return failed ? -1 : 0;
}

/* How many temporary files lie about. */
static inline int leftovers(void) {
    int count = 0;
    DIR *folder = opendir(".");
    struct dirent *entry;
    while ((entry = readdir(folder)) != NULL) {
        count += strncmp(entry->d_name, ".superframe", 11) == 0;
    }
    (void)closedir(folder);
    return count;
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)

#endif
