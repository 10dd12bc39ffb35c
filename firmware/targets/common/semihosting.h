/* SPDX-License-Identifier: MIT */
/* The one trap by which a program asks its debugger or emulator for a service. */
#ifndef SUPERFRAME_TARGETS_SEMIHOSTING_H
#define SUPERFRAME_TARGETS_SEMIHOSTING_H

#include <stdint.h>

/* Arm's numbers; RISC-V has taken them over. */
enum { SEMIHOSTING_OPEN = 0x01, SEMIHOSTING_WRITE = 0x05, SEMIHOSTING_EXIT = 0x18 };

/* Asks for a service. The argument is a number, or the address of a block of numbers. Each CPU has
 * its own trap. */
int32_t semihosting_call(uint32_t operation, uintptr_t argument);

#endif
