/* SPDX-License-Identifier: MIT */
/* Semihosting on Cortex-M: breakpoint ABh, operation in r0, argument in r1, answer in r0. */
#include "semihosting.h"

int32_t semihosting_call(uint32_t operation, uintptr_t argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}
