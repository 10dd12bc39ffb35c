/* SPDX-License-Identifier: MIT */
/* Independent pieces of work on several threads. */
#ifndef SUPERFRAME_PARALLEL_H
#define SUPERFRAME_PARALLEL_H

#include <signal.h>

/* Calls work(context, i) once for each i of first .. last-1, from up to `jobs` threads at a time,
 * and returns when all are done or *stop (may be NULL) is no longer zero. Where threads are lacking
 * the caller's own does the work. */
void parallel_for(unsigned first, unsigned last, unsigned jobs,
                  void (*work)(void *context, unsigned i), void *context,
                  const volatile sig_atomic_t *stop);

#endif
