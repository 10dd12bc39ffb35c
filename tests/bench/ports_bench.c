/* SPDX-License-Identifier: MIT */
/* What a port write costs: nanoseconds through outp() into the emulated board, plain and through
 * the decorators, against a plain store loop in the same run. */
#include "board.h"
#include "bus.h"
#include "outp.h"
#include "trace_hash.h"
#include "trace_recorder.h"

#include <stdio.h>
#include <time.h>

enum { FRAMES = 40, WIDTH = 640, HEIGHT = 400, WRITES = HEIGHT + WIDTH * HEIGHT * 4 };

static struct board board;
static struct trace_recorder recorder;
static volatile uint8_t store[4];

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* One frame as the firmware's driver writes it: Y a line, then X, R, G, B a pixel. */
static void frame_of_ports(unsigned seed) {
    for (unsigned y = 0; y < HEIGHT; y++) {
        outpw(0x00D6, (uint16_t)y);
        for (unsigned x = 0; x < WIDTH; x++) {
            outpw(0x00D4, (uint16_t)x);
            outp(0x00D8, (uint8_t)(x * y + seed));
            outp(0x00DA, (uint8_t)(x ^ y));
            outp(0x00DC, (uint8_t)(x + y));
        }
    }
}

/* The same values into a few bytes that the compiler must not leave out. */
static void frame_of_stores(unsigned seed) {
    for (unsigned y = 0; y < HEIGHT; y++) {
        store[3] = (uint8_t)y;
        for (unsigned x = 0; x < WIDTH; x++) {
            store[3] = (uint8_t)x;
            store[0] = (uint8_t)(x * y + seed);
            store[1] = (uint8_t)(x ^ y);
            store[2] = (uint8_t)(x + y);
        }
    }
}

/* The best of several frames, in nanoseconds a write: other programs only ever make it slower. */
static double best(void (*frame)(unsigned seed)) {
    double fastest = 1e9;
    for (unsigned i = 0; i < FRAMES; i++) {
        double start = seconds();
        frame(i);
        double time = seconds() - start;
        fastest = time < fastest ? time : fastest;
    }
    return fastest * 1e9 / WRITES;
}

static void print(const char *name, double nanoseconds) {
    printf("%-28s %6.2f ns a write, %6.1f million a second\n", name, nanoseconds,
           1e3 / nanoseconds);
}

int main(void) {
    struct board_desc desc = board_default_desc(BOARD_1987);
    struct board_bus to_board;
    struct trace_hash hash;
    if (!board_init(&board, &desc)) {
        return 1;
    }
    board_bus_init(&to_board, &board);
    print("plain store", best(frame_of_stores));
    bus_bind(&to_board.bus);
    print("board", best(frame_of_ports));
    if (!trace_hash_init(&hash, &to_board.bus)) {
        return 1;
    }
    bus_bind(&hash.bus);
    print("board + hash", best(frame_of_ports));
    trace_hash_free(&hash);

    const struct trace_header header = {BOARD_1987, BOARD_FACTORY_BASE};
    FILE *file = tmpfile();
    if (file == NULL) {
        return 1;
    }
    trace_recorder_init(&recorder, &to_board.bus, file, TRACE_BINARY, &header);
    bus_bind(&recorder.bus);
    print("board + recording", best(frame_of_ports));
    bus_bind(NULL);
    enum bus_status status = trace_recorder_finish(&recorder);
    printf("%-28s %ld bytes a frame, as written\n", "", ftell(file) / FRAMES);
    fclose(file);
    return status == BUS_OK ? 0 : 1;
}
