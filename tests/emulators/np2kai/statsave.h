/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_NP2KAI_STATSAVE_H
#define SUPERFRAME_TESTS_NP2KAI_STATSAVE_H

#include "compiler.h"

enum { STATFLAG_SUCCESS = 0, STATFLAG_FAILURE = -1 };

struct state_section;
typedef struct state_section *STFLAGH;
typedef struct {
    int unused;
} SFENTRY;

int statflag_read(STFLAGH section, void *to, UINT size);
int statflag_write(STFLAGH section, const void *from, UINT size);
void statflag_seterr(STFLAGH section, const OEMCHAR *text);

#endif
