/* SPDX-License-Identifier: MIT */
/* The sink by semihosting: a file called ports.bin where the emulator or debugger runs. */
#include "semihosting.h"
#include "sink.h"

enum {
    MODE_WRITE_BINARY = 5,
    STOPPED_APPLICATION_EXIT = 0x20026,
    STOPPED_RUN_TIME_ERROR = 0x20023
};

static int32_t handle;

void sink_open(void) {
    static const char name[] = "ports.bin";
    const uintptr_t block[3] = {(uintptr_t)name, MODE_WRITE_BINARY, sizeof name - 1};
    handle = semihosting_call(SEMIHOSTING_OPEN, (uintptr_t)block);
    if (handle < 0) {
        sink_exit(1);
    }
}

/* Writes the bytes, or ends the run as failed. The call returns how many bytes were not written. */
void sink_write(const uint8_t *bytes, uint16_t count) {
    const uintptr_t block[3] = {(uintptr_t)handle, (uintptr_t)bytes, count};
    if (semihosting_call(SEMIHOSTING_WRITE, (uintptr_t)block) != 0) {
        sink_exit(1);
    }
}

void sink_exit(int status) {
    for (;;) {
        (void)semihosting_call(SEMIHOSTING_EXIT,
                               status == 0 ? STOPPED_APPLICATION_EXIT : STOPPED_RUN_TIME_ERROR);
    }
}
