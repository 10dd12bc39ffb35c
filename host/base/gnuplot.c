/* SPDX-License-Identifier: MIT */
/* Runs gnuplot, where it is installed. */
#include "base/gnuplot.h"

#include <errno.h>
#include <stddef.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/complain.h"

enum { STATUS_NOT_FOUND = 127, STATUS_NOT_RUN = 126 };

enum gnuplot_status gnuplot_run(const char *folder, const char *script) {
    int status = 0;
    pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0) {
            (void)execlp("gnuplot", "gnuplot", script, (char *)NULL);
        }
        _exit(errno == ENOENT ? STATUS_NOT_FOUND : STATUS_NOT_RUN);
    }
    if (child < 0) {
        return GNUPLOT_FAILED;
    }
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            return GNUPLOT_FAILED;
        }
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == STATUS_NOT_FOUND) {
        return GNUPLOT_NOT_FOUND;
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? GNUPLOT_DONE : GNUPLOT_FAILED;
}

void gnuplot_complain(enum gnuplot_status status, const char *script, const char *plots) {
    if (status == GNUPLOT_NOT_FOUND) {
        complain("gnuplot is not there: %s are left out; install it (Debian: apt-get install "
                 "gnuplot-nox, or sh setup.sh paper), or draw %s later",
                 plots, script);
    } else if (status == GNUPLOT_FAILED) {
        complain("gnuplot could not draw %s: %s are left out", script, plots);
    }
}
