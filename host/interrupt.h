/* SPDX-License-Identifier: MIT */
/* Ending a long run cleanly when its user interrupts it. */
#ifndef SUPERFRAME_INTERRUPT_H
#define SUPERFRAME_INTERRUPT_H

#include <signal.h>

/* From now on the first SIGINT or SIGTERM is only noted; one that comes more than a quarter of a
 * second later ends the program, and what comes earlier counts as the first. A signal that the
 * caller had ignored (nohup, a job in the background) stays ignored. */
void interrupt_catch(void);

/* The number of the signal that was noted; 0: none. */
const volatile sig_atomic_t *interrupt_noted(void);

#endif
