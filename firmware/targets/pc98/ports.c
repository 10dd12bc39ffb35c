/* SPDX-License-Identifier: MIT */
/* outp() and its siblings on a 386: one instruction each. */
#include "outp.h"

void outp(uint16_t port, uint8_t value) {
    __asm__ volatile("outb %b0, %w1" : : "a"(value), "d"(port) : "memory");
}

void outpw(uint16_t port, uint16_t value) {
    __asm__ volatile("outw %w0, %w1" : : "a"(value), "d"(port) : "memory");
}

uint8_t inp(uint16_t port) {
    uint8_t value;
    __asm__ volatile("inb %w1, %b0" : "=a"(value) : "d"(port) : "memory");
    return value;
}

uint16_t inpw(uint16_t port) {
    uint16_t value;
    __asm__ volatile("inw %w1, %w0" : "=a"(value) : "d"(port) : "memory");
    return value;
}
