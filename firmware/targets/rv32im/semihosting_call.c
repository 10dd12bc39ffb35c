/* SPDX-License-Identifier: MIT */
/* Semihosting on RISC-V: three instructions that must stand together, uncompressed, in one page. */
#include "semihosting.h"

__attribute__((aligned(16), noinline)) int32_t semihosting_call(uint32_t operation,
                                                                uintptr_t argument) {
    register uint32_t a0 __asm__("a0") = operation;
    register uintptr_t a1 __asm__("a1") = argument;
    __asm__ volatile(".option push\n\t"
                     ".option norvc\n\t"
                     ".balign 16\n\t"
                     "slli x0, x0, 0x1f\n\t"
                     "ebreak\n\t"
                     "srai x0, x0, 7\n\t"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return (int32_t)a0;
}
