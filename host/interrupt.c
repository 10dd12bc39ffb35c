/* SPDX-License-Identifier: MIT */
/* Ending a long run cleanly when its user interrupts it. */
#include "interrupt.h"

#include <string.h>

#include "stopwatch.h"

/* timeout(1) sends its signal to the program and then to its group, so that one interruption comes
 * twice at once; a user who presses a key again needs longer. */
static const double same_seconds = 0.25;

/* A handler has no other way to tell the program anything: the one written global of the host,
 * besides the bound bus. The time is the handler's own. */
static struct {
    volatile sig_atomic_t signal;
    struct timespec at;
} noted;

static void note(int signal_number) {
    if (noted.signal == 0) {
        noted.at = stopwatch_start();
        noted.signal = signal_number;
    } else if (stopwatch_seconds(&noted.at) > same_seconds) {
        (void)signal(signal_number, SIG_DFL);
        (void)raise(signal_number);
    }
}

static void catch_one(int signal_number) {
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = note;
    action.sa_flags = SA_RESTART; /* a write to a pipe goes on */
    (void)sigemptyset(&action.sa_mask);
    (void)sigaddset(&action.sa_mask, SIGINT);
    (void)sigaddset(&action.sa_mask, SIGTERM);
    if (sigaction(signal_number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
        (void)sigaction(signal_number, &action, NULL);
    }
}

void interrupt_catch(void) {
    catch_one(SIGINT);
    catch_one(SIGTERM);
}

const volatile sig_atomic_t *interrupt_noted(void) {
    return &noted.signal;
}
