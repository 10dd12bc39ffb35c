/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_NP2KAI_SCRNMNG_H
#define SUPERFRAME_TESTS_NP2KAI_SCRNMNG_H

#include "compiler.h"

typedef struct {
    UINT8 *ptr;
    int xalign, yalign; /* bytes to the next pixel, and to the next line */
    int width, height;
    UINT bpp;
} SCRNSURF;

#endif
