/* SPDX-License-Identifier: MIT */
/* What instructions of a 387 do on a machine that has none. */
#ifndef SUPERFRAME_BOOT_ABSENT_387_H
#define SUPERFRAME_BOOT_ABSENT_387_H

#include "boot/cpu.h"

/* What stays of an instruction without a 387: the bus floats, so that FFFFh is read. */
struct absent_387_answer {
    bool is_known;    /* false: nothing is said below; such an instruction is not emulated */
    uint32_t length;  /* bytes of the instruction */
    bool is_ax;       /* AX becomes FFFFh */
    bool is_stored;   /* a word FFFFh is stored at `address` */
    uint32_t address; /* linear */
};

/* Answers the instructions by which programs look for a 387, in real mode: FNINIT, FNCLEX, FNSTSW,
 * FNSTCW, with addresses of 16 bits. registers: by enum processor_register. */
struct absent_387_answer absent_387_answer(const uint8_t *bytes, size_t count,
                                           const uint32_t registers[PROCESSOR_REGISTERS]);

#endif
