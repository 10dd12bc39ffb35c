/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_NP2KAI_SCRNDRAW_H
#define SUPERFRAME_TESTS_NP2KAI_SCRNDRAW_H

#include "compiler.h"

enum { SURFACE_HEIGHT = 480 };

extern UINT8 renewal_line[SURFACE_HEIGHT]; /* bit 7: the line is to be drawn */

#endif
