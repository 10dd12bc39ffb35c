/* SPDX-License-Identifier: MIT */
/* Ending a long run cleanly when its user interrupts it, and any run without files left behind. */
#ifndef SUPERFRAME_INTERRUPT_H
#define SUPERFRAME_INTERRUPT_H

#include <signal.h>

/* From now on the first SIGINT, SIGTERM, SIGHUP or SIGQUIT is only noted; one that comes more than
 * a quarter of a second later ends the program, and what comes earlier counts as the first. A
 * signal that the caller had ignored (nohup, a job in the background) stays ignored. */
void interrupt_catch(void);

/* The number of the signal that was noted; 0: none. */
const volatile sig_atomic_t *interrupt_noted(void);

/* From now on one of these signals that ends the program removes this file, or this folder where it
 * is empty, before. The path must stay until it is released. Up to 16 at a time; what is beyond is
 * left behind. */
void interrupt_guard(const char *path);

/* Ends that; harmless on what is not guarded. */
void interrupt_release(const char *path);

#endif
