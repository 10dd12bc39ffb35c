/* SPDX-License-Identifier: MIT */
/* Cortex-M: the vectors, and the path from reset to the frame. */
#include "coprocessor.h"
#include "frame.h"
#include "sink.h"

#include <stdint.h>

/* From the linker script. */
extern uint32_t bss_start[], bss_end[], stack_top[];

void reset(void);

static void fault(void) {
    sink_exit(1);
}

/* Clears .bss, draws the frame and ends the run. The linker script sees to it that there is no
 * .data to copy. */
void reset(void) {
    for (uint32_t *word = bss_start; word != bss_end; word++) {
        *word = 0;
    }
    coprocessor_enable();
    sink_open();
    frame_draw();
    sink_exit(0);
}

/* The architecture's table: the first stack pointer, then handlers; no interrupt is enabled. */
struct vectors {
    uint32_t *stack;
    void (*handlers[15])(void);
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault}};
