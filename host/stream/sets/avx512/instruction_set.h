/* SPDX-License-Identifier: MIT */
/* The instructions that a stream engine is compiled for, by the include path. */
#ifndef SUPERFRAME_INSTRUCTION_SET_H
#define SUPERFRAME_INSTRUCTION_SET_H

#define INSTRUCTION_SET avx512

#endif
