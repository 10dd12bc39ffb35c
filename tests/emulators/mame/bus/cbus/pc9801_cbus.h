/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_MAME_CBUS_H
#define SUPERFRAME_TESTS_MAME_CBUS_H

#include "emu.h"

class pc9801_slot_device {
  public:
    address_space io;
    address_space &io_space() {
        return io;
    }
};

#endif
