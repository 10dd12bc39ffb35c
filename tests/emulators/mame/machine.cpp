/* SPDX-License-Identifier: MIT */
/* A machine in the manner of MAME with the card in its slot: plays a trace, and holds picture,
 * masks, blanking and save states.
 *
 *     machine TRACE CRC
 *
 * CRC is the picture's, in hexadecimal. */
#include "emu.h"

#include "superframe.h"
#include "traced.h"

#include <climits>
#include <cstdlib>
#include <cstring>

enum { WIDTH = 640, HEIGHT = 400 };

static pc9801_slot_device slot;
static screen_device screen;
static superframe_device *card;

/* ---- Ports: a CPU of 16 bits, whose words at odd ports are two bytes --------------------------
 */

static u16 in(unsigned port, unsigned width) {
    if (width == 2 && port % 2 == 1) {
        return u16(in(port, 1) | in(port + 1, 1) << 8);
    }
    if (port < slot.io.start || port > slot.io.end) {
        return width == 1 ? 0xFF : 0xFFFF;
    }
    offs_t offset = (port - slot.io.start) / 2;
    if (width == 2) {
        return slot.io.reader(offset, 0xFFFF);
    }
    return port % 2 == 0 ? slot.io.reader(offset, 0x00FF) & 0xFF
                         : slot.io.reader(offset, 0xFF00) >> 8;
}

static void out(unsigned port, unsigned value, unsigned width) {
    if (width == 2 && port % 2 == 1) {
        out(port, value & 0xFF, 1);
        out(port + 1, value >> 8, 1);
    } else if (port >= slot.io.start && port <= slot.io.end) {
        u16 mask = u16(width == 2 ? 0xFFFF : port % 2 == 0 ? 0x00FF : 0xFF00);
        u16 data = u16(mask == 0xFF00 ? value << 8 : mask == 0x00FF ? value | 0xAA00 : value);
        slot.io.writer((port - slot.io.start) / 2, data, mask);
    }
}

/* ---- The screen: drawn from scratch, in two parts ---------------------------------------------
 */

static u8 seen[WIDTH * HEIGHT * 3];

/* The PC's picture: a dot of FF8040h at 3, 5, and black. */
static void draw() {
    bitmap_rgb32 bitmap;
    bitmap.pixels.assign(WIDTH * HEIGHT, 0xFF000000U);
    bitmap.pix(5, 3) = 0xFFFF8040U;
    card->screen_update(bitmap, rectangle{0, WIDTH - 1, 0, 122});
    card->screen_update(bitmap, rectangle{0, 99, 123, HEIGHT - 1});
    card->screen_update(bitmap, rectangle{100, WIDTH - 1, 123, HEIGHT - 1});
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        u32 value = bitmap.pixels[i];
        seen[i * 3] = u8(value >> 16);
        seen[i * 3 + 1] = u8(value >> 8);
        seen[i * 3 + 2] = u8(value);
    }
}

/* Draws, and returns the CRC of the board's picture without the PC's dot. */
static unsigned long drawn_crc() {
    draw();
    out(0xD4, 3, 2);
    out(0xD6, 5, 2);
    for (unsigned i = 0; i < 3; i++) {
        seen[(5 * WIDTH + 3) * 3 + i] = u8(in(0xD8 + i * 2, 1));
    }
    return crc_by_definition(seen, sizeof seen);
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

/* Loads, and returns what the card threw, or nothing. */
static std::string loaded(const std::vector<u8> &bytes) {
    try {
        card->load(bytes);
    } catch (const emu_fatalerror &error) {
        return error.what();
    }
    return "";
}

static bool check_picture_and_state(FILE *trace, unsigned long crc) {
    play(trace, 500000);
    std::vector<u8> state = card->save();
    std::vector<u8> bad = state;
    play(trace, ULONG_MAX);
    draw();
    HOLDS(memcmp(seen + (5 * WIDTH + 3) * 3, "\xFF\x80\x40", 3) == 0);
    HOLDS(drawn_crc() == crc);
    bad[1000] ^= 1;
    HOLDS(loaded(bad).find("checksum") != std::string::npos);
    HOLDS(drawn_crc() == crc); /* as it was */
    HOLDS(loaded(state).empty());
    HOLDS(drawn_crc() != crc);
    rewind(trace);
    play(trace, ULONG_MAX);
    HOLDS(drawn_crc() == crc);
    return true;
}

static bool check_widths() {
    out(0xD4, 0x0123, 2);
    out(0xD6, 0x0100, 2);
    out(0xD8, 0x77, 1);
    out(0xD4, 0x0023, 2);
    HOLDS(in(0xD8, 1) != 0x77);
    out(0xD4, 0x23, 1);
    out(0xD5, 0x01, 1);
    HOLDS(in(0xD8, 1) == 0x77);
    HOLDS(in(0xD8, 2) == 0xFF77);
    out(0xDA, 0x55, 1);
    out(0xD8, 0, 2); /* a word of red fills all primaries; two bytes do not */
    HOLDS(in(0xDA, 1) == 0);
    HOLDS(in(0xD9, 1) == 0xFF);
    HOLDS(in(0xD1, 1) == 0x00);
    out(0xCF, 0x1F00, 2); /* the word's high byte is control 1's */
    screen.is_blank = true;
    HOLDS(in(0xD2, 1) == 0x02);
    screen.is_blank = false;
    HOLDS(in(0xD2, 2) == 0xFF00);
    card->reset();
    draw();
    HOLDS(seen[0] == 0 && seen[(5 * WIDTH + 3) * 3] == 0xFF);
    return true;
}

static bool check(FILE *trace, unsigned long crc) {
    the_only<pc9801_slot_device>::device = &slot;
    the_only<screen_device>::device = &screen;
    static superframe_device only(machine_config(), "superframe", nullptr, 0);
    card = &only;
    card->start();
    card->reset();
    return check_picture_and_state(trace, crc) && check_widths();
}

int main(int count, char **arguments) {
    return check_machine(count, arguments, check);
}
