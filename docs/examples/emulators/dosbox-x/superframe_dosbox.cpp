/* SPDX-License-Identifier: MIT */
/* The SuperFrame board in DOSBox-X: ports by width, screen by line, a component of the save state.
 */
#include "dosbox.h"
#include "inout.h"
#include "pic.h"
#include "vga.h"

#include "superframe_board.h"
#include "superframe_dosbox.h"

#include <cstring>
#include <istream>
#include <ostream>
#include <vector>

namespace {

struct superframe board;

/* ---- Ports ---------------------------------------------------------------------------------- */

Bitu read_board(Bitu port, Bitu iolen) {
    bool is_blank = PIC_FullIndex() - vga.draw.delay.framestart >= vga.draw.delay.vdend;
    superframe_set_blanking(&board, is_blank ? SUPERFRAME_BLANKING_ON : SUPERFRAME_BLANKING_OFF);
    return superframe_read(&board, (uint16_t)port, (unsigned)iolen);
}

void write_board(Bitu port, Bitu value, Bitu iolen) {
    superframe_write(&board, (uint16_t)port, (uint32_t)value, (unsigned)iolen);
}

IO_ReadHandleObject byte_reads, word_reads[SUPERFRAME_PORTS / 2];
IO_WriteHandleObject byte_writes, word_writes[SUPERFRAME_PORTS / 2];

/* Takes bytes at every port and words at the even ones. DOSBox-X makes two bytes of a word at an
 * odd port, and two words of four bytes, the low one first: each reaches its own device. */
void take_ports() {
    Bitu base = board.desc.base;
    byte_reads.Install(base, read_board, IO_MB, SUPERFRAME_PORTS);
    byte_writes.Install(base, write_board, IO_MB, SUPERFRAME_PORTS);
    for (unsigned i = 0; i < SUPERFRAME_PORTS / 2; i++) {
        word_reads[i].Install(base + i * 2, read_board, IO_MW);
        word_writes[i].Install(base + i * 2, write_board, IO_MW);
    }
}

/* ---- The save state ------------------------------------------------------------------------- */

class Component : public SaveState::Component {
  public:
    void getBytes(std::ostream &stream) override {
        std::vector<uint8_t> bytes(SUPERFRAME_STATE_BYTES);
        superframe_save(&board, bytes.data());
        stream.write(reinterpret_cast<const char *>(bytes.data()), SUPERFRAME_STATE_BYTES);
    }

    void setBytes(std::istream &stream) override {
        std::vector<uint8_t> bytes(SUPERFRAME_STATE_BYTES);
        stream.read(reinterpret_cast<char *>(bytes.data()), SUPERFRAME_STATE_BYTES);
        size_t count = (size_t)stream.gcount();
        enum superframe_state_status status = superframe_restore(&board, bytes.data(), count);
        if (status != SUPERFRAME_STATE_OK) {
            throw SaveState::Error(superframe_state_text(status));
        }
    }
};

Component component;

} // namespace

void SUPERFRAME_Start() {
    struct superframe_desc desc = superframe_default_desc(SUPERFRAME_LATER);
    (void)superframe_init(&board, &desc);
    take_ports();
    SaveState::instance().registerComponent("SuperFrame", component);
}

void SUPERFRAME_Reset() {
    superframe_reset(&board);
}

/* ---- The screen ----------------------------------------------------------------------------- */

/* The line may be DOSBox-X's own memory, which has to stay as it is: a copy is drawn over. */
uint8_t *SUPERFRAME_DrawLine(uint8_t *line, unsigned y) {
    static uint32_t pixels[SUPERFRAME_WIDTH];
    uint8_t rgb[SUPERFRAME_WIDTH * 3];
    std::memcpy(pixels, line, sizeof pixels);
    for (unsigned x = 0; x < SUPERFRAME_WIDTH; x++) {
        rgb[x * 3] = (uint8_t)(pixels[x] >> GFX_Rshift);
        rgb[x * 3 + 1] = (uint8_t)(pixels[x] >> GFX_Gshift);
        rgb[x * 3 + 2] = (uint8_t)(pixels[x] >> GFX_Bshift);
    }
    superframe_draw_over_line(&board, y, rgb);
    for (unsigned x = 0; x < SUPERFRAME_WIDTH; x++) {
        pixels[x] = (uint32_t)rgb[x * 3] << GFX_Rshift | (uint32_t)rgb[x * 3 + 1] << GFX_Gshift |
                    (uint32_t)rgb[x * 3 + 2] << GFX_Bshift | GFX_Amask;
    }
    return reinterpret_cast<uint8_t *>(pixels);
}
