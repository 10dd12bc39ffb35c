/* SPDX-License-Identifier: MIT */
/* What the emulated board uses of string.h, for a target without a C library. */
#ifndef SUPERFRAME_TARGETS_WASM_STRING_H
#define SUPERFRAME_TARGETS_WASM_STRING_H

#include <stddef.h>

void *memcpy(void *to, const void *from, size_t count);
void *memset(void *to, int value, size_t count);
int strcmp(const char *a, const char *b);

#endif
