/* SPDX-License-Identifier: MIT */
/* Files that appear whole under the name that was asked for, or not at all. */
#include "base/output.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/path.h"

enum { NAMES_TRIED = 100, NEW_FILE_MODE = 0666 };

bool output_is_closed_pipe(void) {
    struct pollfd pipe = {.fd = STDOUT_FILENO, .events = POLLOUT};
    return poll(&pipe, 1, 0) == 1 && (pipe.revents & POLLERR) != 0;
}

void output_complain(const struct output *output, const char *reason) {
    bool is_standard = strcmp(output->path, "-") == 0;
    if (!is_standard || !output_is_closed_pipe()) {
        complain("%s: cannot be written: %s", is_standard ? "standard output" : output->path,
                 reason);
    }
}

static bool fail(struct output *output, int error_number) {
    output_complain(output, error_number != 0 ? strerror(error_number) : "an earlier write failed");
    output_discard(output);
    return false;
}

/* Opens a new file in the target's folder, with the rights of the file that it will replace. */
static bool open_temporary(struct output *output, const struct stat *replaced) {
    int descriptor = -1;
    for (unsigned attempt = 0; descriptor < 0 && attempt < NAMES_TRIED; attempt++) {
        char name[64];
        (void)snprintf(name, sizeof name, ".superframe-%ld-%u.tmp", (long)getpid(), attempt);
        free(output->temporary);
        output->temporary = path_beside(output->target, name);
        if (output->temporary == NULL) {
            errno = ENOMEM;
            return false;
        }
        descriptor = open(output->temporary, O_WRONLY | O_CREAT | O_EXCL, NEW_FILE_MODE);
        if (descriptor < 0 && errno != EEXIST) {
            break;
        }
    }
    if (descriptor < 0) {
        free(output->temporary); /* not ours: nothing is to be removed */
        output->temporary = NULL;
        return false;
    }
    interrupt_guard(output->temporary);
    if (replaced != NULL) {
        (void)fchmod(descriptor, replaced->st_mode & 07777); /* best effort */
    }
    output->file = fdopen(descriptor, "wb");
    if (output->file == NULL) {
        (void)close(descriptor);
        return false;
    }
    return true;
}

bool output_open(struct output *output, const char *path) {
    struct stat facts;
    memset(output, 0, sizeof *output);
    output->path = path;
    if (strcmp(path, "-") == 0) {
        output->file = stdout;
        return true;
    }
    bool is_there = stat(path, &facts) == 0;
    if (!is_there && (errno != ENOENT || path[0] == '\0')) {
        return fail(output, errno);
    }
    if (is_there && !S_ISREG(facts.st_mode)) {
        output->file = fopen(path, "wb");
        return output->file != NULL || fail(output, errno);
    }
    /* rename() would replace a file that may not be written to. */
    if (is_there && access(path, W_OK) != 0) {
        return fail(output, errno);
    }
    output->target = path_follow_links(path);
    if (output->target == NULL || !open_temporary(output, is_there ? &facts : NULL)) {
        return fail(output, errno);
    }
    return true;
}

static void drop_temporary(struct output *output) {
    interrupt_release(output->temporary);
    free(output->temporary);
    output->temporary = NULL;
}

bool output_commit(struct output *output) {
    errno = 0;
    if (fflush(output->file) != 0 || ferror(output->file)) {
        return fail(output, errno);
    }
    if (output->file == stdout) {
        output->file = NULL;
        return true;
    }
    /* A file that was named by rename() before its bytes are on the disk may be empty after a
     * power cut. Some file systems know no fsync(): EINVAL. */
    if (output->temporary != NULL && fsync(fileno(output->file)) != 0 && errno != EINVAL) {
        return fail(output, errno);
    }
    FILE *file = output->file;
    output->file = NULL;
    if (fclose(file) != 0) {
        return fail(output, errno);
    }
    if (output->temporary != NULL && rename(output->temporary, output->target) != 0) {
        return fail(output, errno);
    }
    drop_temporary(output); /* it is the target now */
    output_discard(output);
    return true;
}

int output_finish(struct output *output, bool is_written) {
    bool is_done = is_written ? output_commit(output) : fail(output, errno);
    return is_done ? STATUS_DONE : STATUS_FAILED;
}

void output_discard(struct output *output) {
    if (output->file != NULL && output->file != stdout) {
        (void)fclose(output->file);
    }
    if (output->temporary != NULL) {
        (void)unlink(output->temporary);
    }
    drop_temporary(output);
    free(output->target);
    output->file = NULL;
    output->target = NULL;
}
