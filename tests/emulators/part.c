/* SPDX-License-Identifier: MIT */
/* An emulator of nothing but the board: plays a text trace into the part that `make amalgamation`
 * writes. C99 and C++17.
 *
 *     part TRACE FIRST LAST FROM TO
 *
 * plays the accesses FIRST..LAST, counted from 1, into a board restored from the file FROM ("-": a
 * board that was just switched on), and prints what each read was answered. The state goes to the
 * file TO, and the CRC-32 of the picture is printed to standard error. */
#include "superframe_board.h"

#include "traced.h"

static struct superframe board;
static uint8_t state[SUPERFRAME_STATE_BYTES];
static uint8_t rgb[SUPERFRAME_WIDTH * SUPERFRAME_HEIGHT * 3];

static bool take_state(const char *name) {
    struct superframe_desc desc = superframe_default_desc(SUPERFRAME_1987);
    if (strcmp(name, "-") == 0) {
        return superframe_init(&board, &desc);
    }
    FILE *file = fopen(name, "rb");
    size_t count = file == NULL ? 0 : fread(state, 1, sizeof state, file);
    enum superframe_state_status status = superframe_restore(&board, state, count);
    if (file != NULL) {
        fclose(file);
    }
    if (status != SUPERFRAME_STATE_OK) {
        fprintf(stderr, "part: %s: %s\n", name, superframe_state_text(status));
    }
    return status == SUPERFRAME_STATE_OK;
}

static void play(FILE *trace, unsigned long first, unsigned long last) {
    struct traced access;
    for (unsigned long number = 1; number <= last && next_traced(trace, &access); number++) {
        if (number < first) {
            continue;
        }
        if (access.is_read) {
            access.value = superframe_read(&board, (uint16_t)access.port, access.width);
        } else {
            superframe_write(&board, (uint16_t)access.port, access.value, access.width);
        }
        if (access.is_read) {
            printf("%lu %04X %02X\n", number, access.port, access.value);
        }
    }
}

int main(int count, char **arguments) {
    FILE *trace = count == 6 ? fopen(arguments[1], "r") : NULL;
    if (trace == NULL) {
        fprintf(stderr, "usage: part TRACE FIRST LAST FROM TO\n");
        return 2;
    }
    if (!take_state(arguments[4])) {
        return 1;
    }
    play(trace, strtoul(arguments[2], NULL, 10), strtoul(arguments[3], NULL, 10));
    fclose(trace);
    superframe_draw_over(&board, rgb);
    fprintf(stderr, "%08lx\n", (unsigned long)crc_by_definition(rgb, sizeof rgb));
    superframe_save(&board, state);
    FILE *file = fopen(arguments[5], "wb");
    if (file == NULL || fwrite(state, 1, sizeof state, file) != sizeof state || fclose(file) != 0) {
        fprintf(stderr, "part: %s: cannot be written\n", arguments[5]);
        return 1;
    }
    return 0;
}
