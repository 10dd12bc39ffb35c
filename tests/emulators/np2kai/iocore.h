/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_NP2KAI_IOCORE_H
#define SUPERFRAME_TESTS_NP2KAI_IOCORE_H

#include "compiler.h"

#define IOOUTCALL
#define IOINPCALL

typedef void(IOOUTCALL *IOOUT)(UINT port, REG8 value);
typedef REG8(IOINPCALL *IOINP)(UINT port);

struct gdc_state {
    UINT8 vsync; /* bit 5: in the blanking */
};
extern struct gdc_state gdc;

BRESULT iocore_attachout(UINT port, IOOUT function);
BRESULT iocore_attachinp(UINT port, IOINP function);

#endif
