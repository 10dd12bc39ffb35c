/* SPDX-License-Identifier: MIT */
/* Runs a command some times and prints what the runs took. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* usage: timed TIMES COMMAND...
 * Standard output gets one line: seconds by the clock, user and system CPU seconds, all of one run
 * on the average, and the largest peak of memory in KiB. What the command prints goes to
 * standard error. Exit status: 0, or 1 if a run failed, with nothing printed; 2 bad usage.
 *
 * A program of its own because a shell's `times` has hundredths of a second and no memory. Many
 * runs of a short command are summed up: the kernel splits user from system time by samples. */

static double seconds(const struct timeval *time) {
    return (double)time->tv_sec + (double)time->tv_usec * 1e-6;
}

static double now(void) {
    struct timespec time = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static int run_once(char **command) {
    int status = 0;
    pid_t child = fork();
    if (child == 0) {
        if (dup2(STDERR_FILENO, STDOUT_FILENO) >= 0) {
            (void)execvp(command[0], command);
        }
        (void)fprintf(stderr, "timed: %s: %s\n", command[0], strerror(errno));
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child) {
        return -1;
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int main(int argc, char **argv) {
    struct rusage usage;
    char *end = NULL;
    long times = argc >= 3 ? strtol(argv[1], &end, 10) : 0;
    if (times < 1 || times > 10000 || *end != '\0') {
        (void)fprintf(stderr, "usage: timed TIMES COMMAND... (TIMES: 1..10000)\n");
        return 2;
    }
    double began = now();
    for (long i = 0; i < times; i++) {
        int status = run_once(argv + 2);
        if (status != 0) {
            (void)fprintf(stderr, "timed: %s: exit status %d\n", argv[2], status);
            return 1;
        }
    }
    double wall = now() - began;
    if (getrusage(RUSAGE_CHILDREN, &usage) != 0) {
        return 1;
    }
    (void)printf("%.6f %.6f %.6f %ld\n", wall / (double)times,
                 seconds(&usage.ru_utime) / (double)times, seconds(&usage.ru_stime) / (double)times,
                 usage.ru_maxrss);
    return 0;
}
