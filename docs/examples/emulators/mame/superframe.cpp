/* SPDX-License-Identifier: MIT */
/* The SuperFrame board as a card of MAME's C-bus: words with their mask, save states, screen. */
#include "emu.h"

#include "superframe.h"

DEFINE_DEVICE_TYPE(CBUS_SUPERFRAME, superframe_device, "cbus_superframe", "Sapience SuperFrame")

superframe_device::superframe_device(const machine_config &mconfig, const char *tag,
                                     device_t *owner, u32 clock)
    : device_t(mconfig, CBUS_SUPERFRAME, tag, owner, clock), m_bus(*this, DEVICE_SELF_OWNER),
      m_screen(*this, ":screen"), m_board(), m_state() {}

/* Handlers of 16 bits, whatever the CPU's bus has: handlers of 8 bits would make two bytes of every
 * word, which is another access to this board. */
void superframe_device::device_start() {
    superframe_desc desc = superframe_default_desc(SUPERFRAME_LATER);
    superframe_init(&m_board, &desc);
    m_bus->io_space().install_readwrite_handler(
        desc.base, desc.base + SUPERFRAME_PORTS - 1,
        read16s_delegate(*this, FUNC(superframe_device::io_r)),
        write16s_delegate(*this, FUNC(superframe_device::io_w)));
    save_item(NAME(m_state));
}

void superframe_device::device_reset() {
    superframe_reset(&m_board);
}

/* ---- Ports ---------------------------------------------------------------------------------- */

/* The offset counts words. The mask says which bytes of the word are accessed. */
u16 superframe_device::io_r(offs_t offset, u16 mem_mask) {
    u16 port = u16(m_board.desc.base + offset * 2);
    bool is_blank = m_screen && m_screen->vblank();
    superframe_set_blanking(&m_board, is_blank ? SUPERFRAME_BLANKING_ON : SUPERFRAME_BLANKING_OFF);
    if (mem_mask == 0xff00) {
        return u16(superframe_read(&m_board, u16(port + 1), 1) << 8);
    }
    return u16(superframe_read(&m_board, port, mem_mask == 0x00ff ? 1 : 2));
}

void superframe_device::io_w(offs_t offset, u16 data, u16 mem_mask) {
    u16 port = u16(m_board.desc.base + offset * 2);
    if (mem_mask == 0xff00) {
        superframe_write(&m_board, u16(port + 1), data >> 8, 1);
    } else {
        superframe_write(&m_board, port, data, mem_mask == 0x00ff ? 1 : 2);
    }
}

/* ---- Save states ---------------------------------------------------------------------------- */

void superframe_device::device_pre_save() {
    superframe_save(&m_board, m_state);
}

void superframe_device::device_post_load() {
    superframe_state_status status = superframe_restore(&m_board, m_state, sizeof m_state);
    if (status != SUPERFRAME_STATE_OK) {
        throw emu_fatalerror("SuperFrame: %s", superframe_state_text(status));
    }
}

/* ---- The screen ----------------------------------------------------------------------------- */

void superframe_device::screen_update(bitmap_rgb32 &bitmap, const rectangle &cliprect) {
    int right = cliprect.right() < SUPERFRAME_WIDTH ? cliprect.right() : SUPERFRAME_WIDTH - 1;
    for (int y = cliprect.top(); y <= cliprect.bottom() && y < SUPERFRAME_HEIGHT; y++) {
        u8 rgb[SUPERFRAME_WIDTH * 3];
        u8 *pixel = rgb;
        for (int x = cliprect.left(); x <= right; x++, pixel += 3) {
            u32 value = bitmap.pix(y, x);
            pixel[0] = u8(value >> 16);
            pixel[1] = u8(value >> 8);
            pixel[2] = u8(value);
        }
        superframe_area area = {unsigned(cliprect.left()), unsigned(y),
                                unsigned(right - cliprect.left() + 1), 1};
        superframe_draw_over_area(&m_board, area, rgb, sizeof rgb);
        pixel = rgb;
        for (int x = cliprect.left(); x <= right; x++, pixel += 3) {
            bitmap.pix(y, x) = 0xff000000U | u32(pixel[0] << 16 | pixel[1] << 8 | pixel[2]);
        }
    }
}
