/* SPDX-License-Identifier: MIT */
/* What a Cortex-M needs before its first floating-point instruction. */
#ifndef SUPERFRAME_TARGETS_COPROCESSOR_H
#define SUPERFRAME_TARGETS_COPROCESSOR_H

/* Switches the floating-point unit on, where there is one. */
void coprocessor_enable(void);

#endif
