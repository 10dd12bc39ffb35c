/* SPDX-License-Identifier: MIT */
/* A machine in the manner of DOSBox-X, with the glue's hooks where docs/emulators.md puts them:
 * plays a trace, and holds picture, words, blanking and save states.
 *
 *     machine TRACE CRC
 *
 * CRC is the picture's, in hexadecimal. */
#include "dosbox.h"
#include "inout.h"
#include "pic.h"
#include "vga.h"

#include "superframe_dosbox.h"
#include "traced.h"

#include <climits>
#include <cstdlib>
#include <cstring>
#include <sstream>

enum { WIDTH = 640, HEIGHT = 400 };

VGA_Type vga;
unsigned char GFX_Rshift = 16, GFX_Gshift = 8, GFX_Bshift = 0;
uint32_t GFX_Amask = 0xFF000000U;
static double now;

double PIC_FullIndex() {
    return now;
}

SaveState &SaveState::instance() {
    static SaveState only;
    return only;
}

void SaveState::registerComponent(const std::string &name, Component &component) {
    registered = name == "SuperFrame" ? &component : nullptr;
}

/* ---- Ports: handlers by width; what nobody takes is halved ------------------------------------
 */

static IO_ReadHandler *readers[3][0x10004];
static IO_WriteHandler *writers[3][0x10004];

void IO_ReadHandleObject::Install(Bitu port, IO_ReadHandler *handler, Bitu mask, Bitu range) {
    for (; range-- > 0; port++) {
        for (unsigned i = 0; i < 3; i++) {
            readers[i][port] = (mask >> i & 1) != 0 ? handler : readers[i][port];
        }
    }
}

void IO_WriteHandleObject::Install(Bitu port, IO_WriteHandler *handler, Bitu mask, Bitu range) {
    for (; range-- > 0; port++) {
        for (unsigned i = 0; i < 3; i++) {
            writers[i][port] = (mask >> i & 1) != 0 ? handler : writers[i][port];
        }
    }
}

/* width is 1, 2 or 4. */
static uint32_t in(unsigned port, unsigned width) {
    IO_ReadHandler *handler = readers[width / 2][port];
    if (handler != nullptr) {
        return (uint32_t)handler(port, width);
    }
    if (width == 1) {
        return 0xFF;
    }
    unsigned half = width / 2;
    return in(port, half) | in(port + half, half) << 8 * half;
}

static void out(unsigned port, uint32_t value, unsigned width) {
    IO_WriteHandler *handler = writers[width / 2][port];
    if (handler != nullptr) {
        handler(port, value, width);
    } else if (width > 1) {
        unsigned half = width / 2;
        out(port, width == 2 ? value & 0xFF : value & 0xFFFF, half);
        out(port + half, value >> 8 * half, half);
    }
}

/* ---- The screen: every line of every frame ----------------------------------------------------
 */

static uint8_t seen[WIDTH * HEIGHT * 3];

/* The PC's picture: a dot of FF8040h at 3, 5, and black. */
static void draw() {
    for (unsigned y = 0; y < HEIGHT; y++) {
        uint32_t line[WIDTH], before[WIDTH], shown[WIDTH];
        for (unsigned x = 0; x < WIDTH; x++) {
            bool is_dot = x == 3 && y == 5;
            uint32_t dot = 0xFFU << GFX_Rshift | 0x80U << GFX_Gshift | 0x40U << GFX_Bshift;
            before[x] = line[x] = (is_dot ? dot : 0) | GFX_Amask;
        }
        memcpy(shown, SUPERFRAME_DrawLine(reinterpret_cast<uint8_t *>(line), y), sizeof shown);
        for (unsigned x = 0; x < WIDTH; x++) {
            uint8_t *pixel = seen + ((size_t)y * WIDTH + x) * 3;
            pixel[0] = (uint8_t)(shown[x] >> GFX_Rshift);
            pixel[1] = (uint8_t)(shown[x] >> GFX_Gshift);
            pixel[2] = (uint8_t)(shown[x] >> GFX_Bshift);
        }
        if (memcmp(line, before, sizeof line) != 0) {
            memset(seen, 0, sizeof seen); /* DOSBox-X's own line was changed */
        }
    }
}

/* ---- What must hold ---------------------------------------------------------------------------
 */

static void play(FILE *trace, unsigned long count) {
    struct traced access;
    while (count-- > 0 && next_traced(trace, &access)) {
        if (access.is_read) {
            (void)in(access.port, access.width);
        } else {
            out(access.port, access.value, access.width);
        }
    }
}

/* Draws, and returns the CRC of the board's picture without the PC's dot. */
static unsigned long drawn_crc() {
    draw();
    out(0xD4, 3, 2);
    out(0xD6, 5, 2);
    for (unsigned i = 0; i < 3; i++) {
        seen[(5 * WIDTH + 3) * 3 + i] = (uint8_t)in(0xD8 + i * 2, 1);
    }
    return crc_by_definition(seen, sizeof seen);
}

static bool check_picture(FILE *trace, unsigned long crc, std::string &state) {
    std::ostringstream stream;
    play(trace, 500000);
    SaveState::instance().registered->getBytes(stream);
    state = stream.str();
    play(trace, ULONG_MAX);
    draw();
    HOLDS(memcmp(seen + (5 * WIDTH + 3) * 3, "\xFF\x80\x40", 3) == 0);
    HOLDS(drawn_crc() == crc);
    GFX_Rshift = 0; /* another order of the primaries, as some hosts have */
    GFX_Bshift = 16;
    HOLDS(drawn_crc() == crc);
    return true;
}

/* Restores, and returns what the glue threw, or nothing. */
static std::string restored(const std::string &state) {
    std::istringstream stream(state);
    try {
        SaveState::instance().registered->setBytes(stream);
    } catch (const SaveState::Error &error) {
        return error;
    }
    return "";
}

static bool check_state(FILE *trace, unsigned long crc, const std::string &state) {
    std::string bad = state;
    bad[1000] ^= 1;
    HOLDS(restored(bad).find("checksum") != std::string::npos);
    HOLDS(restored(state.substr(0, 5000)).find("length") != std::string::npos);
    HOLDS(drawn_crc() == crc); /* as it was */
    HOLDS(restored(state).empty());
    draw();
    HOLDS(crc_by_definition(seen, sizeof seen) != crc);
    rewind(trace);
    play(trace, ULONG_MAX);
    HOLDS(drawn_crc() == crc);
    return true;
}

static bool check_widths() {
    out(0xD4, 0x01000123, 4); /* X = 291, Y = 256 */
    out(0xD8, 0x77, 1);
    out(0xD4, 0x0023, 2);
    HOLDS(in(0xD8, 1) != 0x77);
    out(0xD4, 0x23, 1);
    out(0xD5, 0x01, 1);
    HOLDS(in(0xD8, 1) == 0x77);
    HOLDS((in(0xD8, 4) & 0xFFFF) == 0xFF77);
    out(0xDA, 0x55, 1);
    out(0xD8, 0, 2); /* a word of red fills all primaries; two bytes do not */
    HOLDS(in(0xDA, 1) == 0);
    HOLDS(in(0xE0, 2) == 0xFFFF); /* nobody's */
    out(0xCF, 0x1F00, 2);         /* the word's high byte is control 1's */
    vga.draw.delay.framestart = 100;
    vga.draw.delay.vdend = 16;
    now = 116;
    HOLDS(in(0xD2, 1) == 0x02);
    now = 115;
    HOLDS(in(0xD2, 2) == 0xFF00);
    SUPERFRAME_Reset();
    draw();
    HOLDS(seen[0] == 0 && seen[(5 * WIDTH + 3) * 3] == 0xFF);
    return true;
}

static bool check(FILE *trace, unsigned long crc) {
    std::string state;
    SUPERFRAME_Start();
    return check_picture(trace, crc, state) && check_state(trace, crc, state) && check_widths();
}

int main(int count, char **arguments) {
    return check_machine(count, arguments, check);
}
