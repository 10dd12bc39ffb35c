/* SPDX-License-Identifier: MIT */
/* The firmware as a program of its own that writes its port records to ports.bin. */
#include <stdio.h>
#include <stdlib.h>

#include "frame.h"
#include "sink.h"

static FILE *ports;

void sink_open(void) {
    ports = fopen("ports.bin", "wb");
    if (ports == NULL) {
        perror("ports.bin");
        exit(EXIT_FAILURE);
    }
}

void sink_write(const uint8_t *bytes, uint16_t count) {
    if (fwrite(bytes, 1, count, ports) != count) {
        perror("ports.bin");
        exit(EXIT_FAILURE);
    }
}

void sink_exit(int status) {
    exit(fclose(ports) == 0 ? status : EXIT_FAILURE);
}

int main(void) {
    sink_open();
    frame_draw();
    sink_exit(0);
    return 0;
}
