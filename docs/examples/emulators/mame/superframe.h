/* SPDX-License-Identifier: MIT */
/* The SuperFrame board as a card of MAME's C-bus. docs/emulators.md says what to add besides. */
#ifndef MAME_BUS_CBUS_SUPERFRAME_H
#define MAME_BUS_CBUS_SUPERFRAME_H

#pragma once

#include "bus/cbus/pc9801_cbus.h"
#include "screen.h"

#include "superframe_board.h"

class superframe_device : public device_t {
  public:
    superframe_device(const machine_config &mconfig, const char *tag, device_t *owner, u32 clock);

    /* Draws the board over what the machine's screen_update() has drawn. */
    void screen_update(bitmap_rgb32 &bitmap, const rectangle &cliprect);

  protected:
    virtual void device_start() override;
    virtual void device_reset() override;
    virtual void device_pre_save() override;
    virtual void device_post_load() override;

  private:
    u16 io_r(offs_t offset, u16 mem_mask);
    void io_w(offs_t offset, u16 data, u16 mem_mask);

    required_device<pc9801_slot_device> m_bus;
    optional_device<screen_device> m_screen;
    superframe m_board;
    u8 m_state[SUPERFRAME_STATE_BYTES];
};

DECLARE_DEVICE_TYPE(CBUS_SUPERFRAME, superframe_device)

#endif
