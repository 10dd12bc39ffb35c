/* SPDX-License-Identifier: MIT */
/* The instructions of a 386, as far as their lengths. By them a block of code is searched for what
 * a 386 without a 387 does not have. */
#ifndef SUPERFRAME_BOOT_INSTRUCTION_H
#define SUPERFRAME_BOOT_INSTRUCTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* So many bytes an instruction has at most, with its prefixes. */
enum { INSTRUCTION_BYTES_MOST = 15 };

enum instruction_kind {
    INSTRUCTION_386,         /* or too little of one to tell */
    INSTRUCTION_387,         /* D8h to DFh: for the coprocessor */
    INSTRUCTION_CONTROL,     /* may write CR0 or CR3: MOV CRn, LMSW */
    INSTRUCTION_NOT_ON_A_386 /* of a later CPU, or of none */
};

struct instruction {
    enum instruction_kind kind;
    size_t length;   /* bytes; 0: the bytes end before the instruction does */
    size_t opcode;   /* offset of the first byte after the prefixes */
    uint8_t segment; /* the prefix that chooses a segment, 26h, 2Eh, 36h, 3Eh, 64h, 65h; 0: none */
};

/* Decodes the instruction that the bytes begin with. is_32: the code segment's default. Source: the
 * opcode maps of the Intel 386 manual. */
struct instruction instruction_decode(const uint8_t *bytes, size_t count, bool is_32);

#endif
