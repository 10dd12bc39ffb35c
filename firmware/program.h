/* SPDX-License-Identifier: MIT */
/* An object as a Boolean function of the primitives that a place is in. */
#ifndef SUPERFRAME_PROGRAM_H
#define SUPERFRAME_PROGRAM_H

#include "scene.h"

/* Runs an object's postfix program on the bits of the set; the stack of Booleans is one word. */
static inline bool program_holds(const program_code *program, run_count length,
                                 const struct primitive_set *inside) {
    uint32_t stack = 0;
    for (run_count i = 0; i < length; i++) {
        program_code code = program[i];
        if (code < PROGRAM_UNION) {
            stack = stack << 1 | (uint32_t)set_has(inside, code);
            continue;
        }
        uint32_t right = stack & 1;
        stack >>= 1;
        if (code == PROGRAM_UNION) {
            stack |= right;
        } else if (code == PROGRAM_DIFFERENCE) {
            stack &= ~right;
        } else {
            stack &= right | ~(uint32_t)1;
        }
    }
    return (stack & 1) != 0;
}

#endif
