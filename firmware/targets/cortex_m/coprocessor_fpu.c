/* SPDX-License-Identifier: MIT */
/* A Cortex-M with a floating-point unit: coprocessors 10 and 11 are opened to everybody. */
#include "coprocessor.h"

#include <stdint.h>

/* CPACR of the Armv7-M architecture. */
static volatile uint32_t *const access_control = (volatile uint32_t *)0xE000ED88;

void coprocessor_enable(void) {
    *access_control |= UINT32_C(0xF) << 20;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
}
