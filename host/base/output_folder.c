/* SPDX-License-Identifier: MIT */
/* A folder of results that appears whole, or not at all. */
#include "base/output_folder.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/path.h"

enum { NAMES_TRIED = 100, NEW_FOLDER_MODE = 0777 };

static bool fail(struct paper_folder *folder, int error_number) {
    complain("%s: cannot be written: %s", folder->target, strerror(error_number));
    paper_folder_discard(folder);
    return false;
}

/* Returns the folder in which the target is, or is to be. NULL: out of memory. */
static char *parent_of(const char *target) {
    const char *slash = strrchr(target, '/');
    size_t length = slash == NULL ? 1 : slash == target ? 1 : (size_t)(slash - target);
    char *parent = malloc(length + 1);
    if (parent != NULL) {
        memcpy(parent, slash == NULL ? "." : target, length);
        parent[length] = '\0';
    }
    return parent;
}

/* Copies a name without the slashes at its end. NULL: out of memory. */
static char *copy_name(const char *name) {
    size_t length = strlen(name);
    while (length > 1 && name[length - 1] == '/') {
        length--;
    }
    char *copy = malloc(length + 1);
    if (copy != NULL) {
        memcpy(copy, name, length);
        copy[length] = '\0';
    }
    return copy;
}

static bool make_temporary(struct paper_folder *folder, const char *place) {
    for (unsigned attempt = 0; attempt < NAMES_TRIED; attempt++) {
        char name[64];
        (void)snprintf(name, sizeof name, ".superframe-%ld-%u.tmp", (long)getpid(), attempt);
        char *path = path_join(place, name);
        if (path == NULL) {
            errno = ENOMEM;
            return false;
        }
        if (mkdir(path, NEW_FOLDER_MODE) == 0) {
            folder->temporary = path;
            interrupt_guard(path);
            return true;
        }
        int error_number = errno;
        free(path);
        errno = error_number;
        if (error_number != EEXIST) {
            return false;
        }
    }
    return false;
}

bool paper_folder_open(struct paper_folder *folder, const char *target) {
    struct stat facts;
    memset(folder, 0, sizeof *folder);
    folder->target = copy_name(target);
    if (folder->target == NULL) {
        complain("out of memory");
        return false;
    }
    folder->is_there = stat(folder->target, &facts) == 0;
    if (folder->is_there && !S_ISDIR(facts.st_mode)) {
        return fail(folder, ENOTDIR);
    }
    if (!folder->is_there && errno != ENOENT) {
        return fail(folder, errno);
    }
    char *place = folder->is_there ? copy_name(folder->target) : parent_of(folder->target);
    bool is_made = place != NULL && make_temporary(folder, place);
    int error_number = place == NULL ? ENOMEM : errno;
    free(place);
    return is_made || fail(folder, error_number);
}

static bool is_dots(const char *name) {
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

/* Returns the next entry of a folder. NULL: there is no more, or, with *is_good false and errno
 * set, the folder can't be read. */
static struct dirent *next_entry(DIR *entries, bool *is_good) {
    errno = 0;
    struct dirent *entry = readdir(entries);
    *is_good = entry != NULL || errno == 0;
    return entry;
}

/* Moves every file of the temporary folder into the target, or removes every file. False with errno
 * set at the first failure. */
static bool empty_temporary(const struct paper_folder *folder, bool moves) {
    DIR *entries = opendir(folder->temporary);
    bool is_done = entries != NULL;
    struct dirent *entry;
    while (is_done && (entry = next_entry(entries, &is_done)) != NULL) {
        if (is_dots(entry->d_name)) {
            continue;
        }
        char *from = path_join(folder->temporary, entry->d_name);
        char *to = path_join(folder->target, entry->d_name);
        is_done = from != NULL && to != NULL && (moves ? rename(from, to) : unlink(from)) == 0;
        int error_number = errno;
        free(from);
        free(to);
        errno = error_number;
    }
    int error_number = errno;
    if (entries != NULL) {
        (void)closedir(entries);
    }
    errno = error_number;
    return is_done;
}

bool paper_folder_commit(struct paper_folder *folder) {
    bool is_done = folder->is_there ? empty_temporary(folder, true)
                                    : rename(folder->temporary, folder->target) == 0;
    if (!is_done) {
        return fail(folder, errno);
    }
    if (!folder->is_there) {
        interrupt_release(folder->temporary);
        free(folder->temporary); /* it is the target now */
        folder->temporary = NULL;
    }
    paper_folder_discard(folder);
    return true;
}

void paper_folder_discard(struct paper_folder *folder) {
    if (folder->temporary != NULL) {
        (void)empty_temporary(folder, false);
        (void)rmdir(folder->temporary);
        interrupt_release(folder->temporary);
    }
    free(folder->temporary);
    free(folder->target);
    memset(folder, 0, sizeof *folder);
}
