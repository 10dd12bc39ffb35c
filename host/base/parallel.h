/* SPDX-License-Identifier: MIT */
/* Independent pieces of work on several threads. */
#ifndef SUPERFRAME_PARALLEL_H
#define SUPERFRAME_PARALLEL_H

#include <signal.h>

/* Calls work(context, i) once for each i of first .. last-1, from up to `jobs` threads at a time.
 * Returns when all calls are done. Begins no more calls once *stop is no longer zero; stop may be
 * NULL. Where threads are missing, the caller's own does the work. */
void parallel_for(unsigned first, unsigned last, unsigned jobs,
                  void (*work)(void *context, unsigned i), void *context,
                  const volatile sig_atomic_t *stop);

#endif
