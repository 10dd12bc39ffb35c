/* SPDX-License-Identifier: MIT */
/* Ports that lead nowhere, for programs that ask an image of the firmware for rows alone. */
#include "outp.h"

void outp(uint16_t port, uint8_t value) {
    (void)port;
    (void)value;
}

void outpw(uint16_t port, uint16_t value) {
    (void)port;
    (void)value;
}

uint8_t inp(uint16_t port) {
    (void)port;
    return 0xFF;
}

uint16_t inpw(uint16_t port) {
    (void)port;
    return 0xFFFF;
}
