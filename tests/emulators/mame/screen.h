/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_MAME_SCREEN_H
#define SUPERFRAME_TESTS_MAME_SCREEN_H

class screen_device {
  public:
    bool is_blank = false;
    bool vblank() const {
        return is_blank;
    }
};

#endif
