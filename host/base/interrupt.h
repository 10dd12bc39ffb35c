/* SPDX-License-Identifier: MIT */
/* Ends a long run cleanly when its user interrupts it, and leaves no files behind after any run. */
#ifndef SUPERFRAME_INTERRUPT_H
#define SUPERFRAME_INTERRUPT_H

#include <signal.h>

/* Notes the first SIGINT, SIGTERM, SIGHUP or SIGQUIT from now on, and lets the program go on. A
 * signal that comes more than a quarter of a second later ends the program. A signal that comes
 * earlier counts as the first. A signal that the caller had ignored (nohup, a job in the
 * background) stays ignored. */
void interrupt_catch(void);

/* Returns where the number of the noted signal stands; a 0 there: none was noted. */
const volatile sig_atomic_t *interrupt_noted(void);

/* Guards a file or a folder: before one of these signals ends the program, the file is removed. A
 * folder is removed if it is empty. The path must stay until it is released. Up to 16 paths are
 * guarded at a time; what is beyond is left behind. */
void interrupt_guard(const char *path);

/* Ends the guard of a path, by the same pointer; harmless on what is not guarded. */
void interrupt_release(const char *path);

#endif
