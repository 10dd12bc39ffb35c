/* SPDX-License-Identifier: MIT */
/* Ends a long run cleanly when its user interrupts it, and leaves no files behind after any run. */
#include "base/interrupt.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

#include "base/stopwatch.h"

enum { GUARDED_MOST = 16 };

/* timeout(1) sends its signal to the program and then to the program's group. So one interruption
 * comes twice at once. A user who presses a key again needs longer. */
static const double same_seconds = 0.25;

static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

/* The one written global of the host, besides the bound bus. A signal handler has no other way to
 * tell the program anything, or to be told which files lie about. The time is the handler's own. */
static struct {
    bool is_caught; /* the first signal is only noted */
    volatile sig_atomic_t signal;
    struct timespec at;
    const char *volatile guarded[GUARDED_MOST]; /* NULL: a free place */
} noted;

/* Removes what is guarded, the last first: a folder stands before what is in it. */
static void remove_guarded(void) {
    for (int i = GUARDED_MOST - 1; i >= 0; i--) {
        const char *path = noted.guarded[i];
        if (path != NULL && unlink(path) != 0) {
            (void)rmdir(path);
        }
    }
}

static void take(int signal_number) {
    if (noted.is_caught && noted.signal == 0) {
        noted.at = stopwatch_start();
        noted.signal = signal_number;
    } else if (!noted.is_caught || stopwatch_seconds(&noted.at) > same_seconds) {
        remove_guarded();
        (void)signal(signal_number, SIG_DFL);
        (void)raise(signal_number);
    }
}

static void take_signals(void) {
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = take;
    action.sa_flags = SA_RESTART; /* a write to a pipe goes on */
    (void)sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        (void)sigaddset(&action.sa_mask, signals[i]);
    }
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        if (sigaction(signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
            (void)sigaction(signals[i], &action, NULL);
        }
    }
}

void interrupt_catch(void) {
    noted.is_caught = true;
    take_signals();
}

const volatile sig_atomic_t *interrupt_noted(void) {
    return &noted.signal;
}

void interrupt_guard(const char *path) {
    for (int i = 0; i < GUARDED_MOST; i++) {
        if (noted.guarded[i] == NULL) {
            noted.guarded[i] = path;
            break;
        }
    }
    take_signals();
}

void interrupt_release(const char *path) {
    for (int i = 0; i < GUARDED_MOST; i++) {
        if (noted.guarded[i] == path) {
            noted.guarded[i] = NULL;
        }
    }
}
