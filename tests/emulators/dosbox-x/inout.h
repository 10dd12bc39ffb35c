/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_DOSBOX_INOUT_H
#define SUPERFRAME_TESTS_DOSBOX_INOUT_H

#include "dosbox.h"

enum { IO_MB = 1, IO_MW = 2, IO_MD = 4 };

typedef Bitu IO_ReadHandler(Bitu port, Bitu iolen);
typedef void IO_WriteHandler(Bitu port, Bitu value, Bitu iolen);

struct IO_ReadHandleObject {
    void Install(Bitu port, IO_ReadHandler *handler, Bitu mask, Bitu range = 1);
};

struct IO_WriteHandleObject {
    void Install(Bitu port, IO_WriteHandler *handler, Bitu mask, Bitu range = 1);
};

#endif
