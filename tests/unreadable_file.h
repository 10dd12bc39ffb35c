/* SPDX-License-Identifier: MIT */
/* Files that can be read so far and no further, as from a disk that goes bad. */
#ifndef SUPERFRAME_TESTS_UNREADABLE_FILE_H
#define SUPERFRAME_TESTS_UNREADABLE_FILE_H

#include <fcntl.h>
#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

/* A pipe without an end that nothing more comes out of. */
struct unreadable_file {
    int reader, writer;
};

/* Makes a file whose first bytes, at most 65,536, can be read; reading on gives EAGAIN. */
static inline bool unreadable_file_open(struct unreadable_file *file, const void *bytes,
                                        size_t size) {
    int ends[2];
    if (pipe(ends) != 0) {
        return false;
    }
    file->reader = ends[0];
    file->writer = ends[1];
    return fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0 &&
           (size == 0 || write(ends[1], bytes, size) == (ssize_t)size);
}

#endif
