/* SPDX-License-Identifier: MIT */
/* Ending a long run cleanly when its user interrupts it. */
#include "interrupt.h"

#include <string.h>

/* A handler has no other way to tell the program anything: the one written global of the host,
 * besides the bound bus. */
static volatile sig_atomic_t noted_signal;

static void note(int signal_number) {
    noted_signal = signal_number;
}

static void catch_one(int signal_number) {
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = note;
    /* A write to a pipe goes on; the second signal does what it always did. */
    action.sa_flags = (int)(SA_RESTART | SA_RESETHAND);
    if (sigaction(signal_number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
        (void)sigaction(signal_number, &action, NULL);
    }
}

void interrupt_catch(void) {
    catch_one(SIGINT);
    catch_one(SIGTERM);
}

const volatile sig_atomic_t *interrupt_noted(void) {
    return &noted_signal;
}
