/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_DOSBOX_PIC_H
#define SUPERFRAME_TESTS_DOSBOX_PIC_H

/* Milliseconds since the start. */
double PIC_FullIndex();

#endif
