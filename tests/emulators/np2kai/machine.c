/* SPDX-License-Identifier: MIT */
/* A machine in the manner of NP2kai, with the glue's hooks where docs/emulators.md puts them: plays
 * a trace, and holds picture, words, blanking and save states.
 *
 *     machine TRACE CRC
 *
 * CRC is the picture's, in hexadecimal. */
#include "compiler.h"
#include "iocore.h"
#include "pccore.h"
#include "scrndraw.h"
#include "scrnmng.h"
#include "statsave.h"

#include "superframe_np2.h"
#include "traced.h"

#include <limits.h>
#include <stdlib.h>

enum { WIDTH = 640, HEIGHT = 400 };

static const NP2CFG config;
struct core_state pcstat;
struct gdc_state gdc;
UINT8 renewal_line[SURFACE_HEIGHT];

/* ---- Ports: handlers of bytes, and a table of words that are cut to their low byte ------------
 */

static IOOUT outs[0x10000];
static IOINP inps[0x10000];

BRESULT iocore_attachout(UINT port, IOOUT function) {
    outs[port] = function;
    return 0;
}

BRESULT iocore_attachinp(UINT port, IOINP function) {
    inps[port] = function;
    return 0;
}

static void out8(UINT port, REG8 value) {
    if (outs[port & 0xFFFF] != NULL) {
        outs[port & 0xFFFF](port, value);
    }
}

static REG8 inp8(UINT port) {
    return inps[port & 0xFFFF] == NULL ? 0xFF : inps[port & 0xFFFF](port);
}

static bool is_cut(UINT port) {
    UINT low = port & 0xFF;
    return (port & 0x0C00) == 0 && low >= 0xD0 && low <= 0xDE && low % 2 == 0 && low != 0xDA;
}

static void out16(UINT port, REG16 value) {
    if (superframe_np2_out16(port, value)) {
        return;
    }
    out8(port, value & 0xFF);
    if (!is_cut(port)) {
        out8(port + 1, value >> 8);
    }
}

static REG16 inp16(UINT port) {
    REG16 value;
    if (superframe_np2_inp16(port, &value)) {
        return value;
    }
    REG8 low = inp8(port);
    return is_cut(port) ? low : low | inp8(port + 1) << 8;
}

static void out32(UINT port, UINT32 value) {
    out16(port, value & 0xFFFF);
    out16(port + 2, value >> 16);
}

/* ---- The screen: a surface that keeps its lines until they are drawn anew -------------------- */

static UINT8 pixels[WIDTH * HEIGHT * 4], seen[WIDTH * HEIGHT * 3];

/* The PC's picture: a dot of FF8040h at 3, 5, and black. */
static void draw_pc(UINT8 *pixel, unsigned x, unsigned y, UINT bpp) {
    bool is_dot = x == 3 && y == 5;
    memset(pixel, 0, bpp / 8);
    if (is_dot && bpp == 32) {
        memcpy(pixel, "\x40\x80\xFF", 3);
    } else if (is_dot) {
        memcpy(pixel, "\x08\xFC", 2); /* F81Fh without blue's low bits: 11111 100000 01000 */
    }
}

/* Returns how many lines were drawn. */
static unsigned draw(UINT bpp) {
    SCRNSURF surface = {pixels, (int)bpp / 8, WIDTH * (int)bpp / 8, WIDTH, HEIGHT, bpp};
    UINT8 dirty[SURFACE_HEIGHT] = {0};
    unsigned count = 0;
    superframe_np2_update();
    if (pcstat.screenupdate == 0) {
        return 0;
    }
    pcstat.screenupdate = 0;
    for (unsigned y = 0; y < HEIGHT; y++) {
        dirty[y] = renewal_line[y] & 0x80;
        renewal_line[y] = 0;
        count += dirty[y] != 0;
        for (unsigned x = 0; dirty[y] != 0 && x < WIDTH; x++) {
            draw_pc(pixels + (y * WIDTH + x) * bpp / 8, x, y, bpp);
        }
    }
    superframe_np2_draw(&surface, dirty);
    return count;
}

/* Takes what a surface of 32 bits shows as R, G, B. */
static void look(void) {
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        seen[i * 3] = pixels[i * 4 + 2];
        seen[i * 3 + 1] = pixels[i * 4 + 1];
        seen[i * 3 + 2] = pixels[i * 4];
    }
}

/* ---- Save states ------------------------------------------------------------------------------
 */

struct state_section {
    UINT8 bytes[1 << 20];
    UINT size, place;
    char error[80];
};

static struct state_section section;

int statflag_read(STFLAGH from, void *to, UINT size) {
    if (from->place + size > from->size) {
        return STATFLAG_FAILURE;
    }
    memcpy(to, from->bytes + from->place, size);
    from->place += size;
    return STATFLAG_SUCCESS;
}

int statflag_write(STFLAGH to, const void *from, UINT size) {
    memcpy(to->bytes + to->size, from, size);
    to->size += size;
    return STATFLAG_SUCCESS;
}

void statflag_seterr(STFLAGH of, const OEMCHAR *text) {
    snprintf(of->error, sizeof of->error, "%s", text);
}

/* ---- What must hold ---------------------------------------------------------------------------
 */

/* Plays the rest of the trace, or `count` accesses of it. The board answers as later boards do. */
static void play(FILE *trace, unsigned long count) {
    struct traced access;
    while (count-- > 0 && next_traced(trace, &access)) {
        if (access.is_read) {
            (void)(access.width == 1 ? inp8(access.port) : inp16(access.port));
        } else if (access.width == 1) {
            out8(access.port, access.value);
        } else {
            out16(access.port, access.value);
        }
    }
}

/* Holds that the whole is drawn, that the PC's dot lies over it, and the picture besides. */
static bool check_picture(FILE *trace, unsigned long crc) {
    static UINT8 exact[WIDTH * HEIGHT * 4];
    play(trace, 500000);
    HOLDS(draw(32) == HEIGHT);
    play(trace, 4000);
    unsigned lines = draw(32);
    HOLDS(lines >= 1 && lines <= 3);
    HOLDS(draw(32) == 0);
    section.size = 0;
    HOLDS(superframe_np2_save(&section, NULL) == STATFLAG_SUCCESS);
    play(trace, ULONG_MAX);
    (void)draw(32);
    look();
    HOLDS(memcmp(seen + (5 * WIDTH + 3) * 3, "\xFF\x80\x40", 3) == 0);
    out16(0xD4, 3);
    out16(0xD6, 5);
    seen[(5 * WIDTH + 3) * 3] = (UINT8)inp8(0xD8);
    seen[(5 * WIDTH + 3) * 3 + 1] = (UINT8)inp8(0xDA);
    seen[(5 * WIDTH + 3) * 3 + 2] = (UINT8)inp8(0xDC);
    HOLDS(crc_by_definition(seen, sizeof seen) == crc);
    memcpy(exact, pixels, sizeof exact);
    memset(renewal_line, 0x80, sizeof renewal_line);
    pcstat.screenupdate = 1;
    HOLDS(draw(16) == HEIGHT);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        unsigned value = pixels[i * 2] | (unsigned)pixels[i * 2 + 1] << 8;
        HOLDS(value >> 11 == exact[i * 4 + 2] >> 3);
        HOLDS((value >> 5 & 63) == exact[i * 4 + 1] >> 2);
        HOLDS((value & 31) == exact[i * 4] >> 3);
    }
    return true;
}

/* Goes back to the state in the middle: its picture comes back, and a bad state is refused. */
static bool check_state(unsigned long crc) {
    HOLDS(superframe_np2_load(&section, NULL) == STATFLAG_SUCCESS);
    HOLDS(draw(32) == HEIGHT);
    look();
    unsigned long half = crc_by_definition(seen, sizeof seen);
    HOLDS(half != crc);
    section.place = 0;
    section.bytes[1000] ^= 1;
    HOLDS(superframe_np2_load(&section, NULL) == STATFLAG_FAILURE);
    HOLDS(strstr(section.error, "checksum") != NULL);
    section.place = 0;
    section.size = 1000;
    HOLDS(superframe_np2_load(&section, NULL) == STATFLAG_FAILURE);
    HOLDS(draw(32) == 0);
    return true;
}

static bool check_widths(void) {
    out32(0xD4, 0x01000123); /* X = 291, Y = 256 */
    out8(0xD8, 0x77);
    out16(0xD4, 0x0023);
    HOLDS(inp8(0xD8) != 0x77);
    out8(0xD4, 0x23);
    out8(0xD5, 0x01);
    HOLDS(inp8(0xD8) == 0x77);
    HOLDS(inp16(0xD8) == 0xFF77);
    out8(0xDA, 0x55);
    out16(0xD8, 0); /* a word of red fills all primaries; two bytes do not */
    HOLDS(inp8(0xDA) == 0);
    HOLDS(inp16(0xE0) == 0xFFFF); /* nobody's */
    out16(0xCF, 0x1F00);          /* the word's high byte is control 1's */
    gdc.vsync = 0x20;
    HOLDS(inp8(0xD2) == 0x02);
    gdc.vsync = 0;
    HOLDS(inp16(0xD2) == 0xFF00);
    superframe_np2_reset(&config);
    HOLDS(draw(32) == HEIGHT);
    for (unsigned x = 0; x < WIDTH; x++) {
        HOLDS(x == 3 || memcmp(pixels + (5 * WIDTH + x) * 4, "\0\0\0", 3) == 0);
    }
    return true;
}

static bool check(FILE *trace, unsigned long crc) {
    superframe_np2_reset(&config);
    superframe_np2_bind();
    return check_picture(trace, crc) && check_state(crc) && check_widths();
}

int main(int count, char **arguments) {
    return check_machine(count, arguments, check);
}
