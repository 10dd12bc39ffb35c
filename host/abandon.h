/* SPDX-License-Identifier: MIT */
/* Computations that can be given up in their midst. */
#ifndef SUPERFRAME_ABANDON_H
#define SUPERFRAME_ABANDON_H

#include <signal.h>
#include <stdbool.h>

/* Calls work(context), and gives it up within a twentieth of a second once *stop is no longer zero.
 * The work must be pure: it takes no locks, no memory and no files, and writes to nothing that
 * matters where it is given up, as the firmware's rows are. True: it is done. stop may be NULL;
 * then, and where there is no thread to be had, the work can't be given up. */
bool do_until(const volatile sig_atomic_t *stop, void (*work)(void *context), void *context);

#endif
