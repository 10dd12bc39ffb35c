/* SPDX-License-Identifier: MIT */
/* What the emulated board uses of ctype.h, for a target without a C library. */
#ifndef SUPERFRAME_TARGETS_WASM_CTYPE_H
#define SUPERFRAME_TARGETS_WASM_CTYPE_H

int tolower(int letter);

#endif
