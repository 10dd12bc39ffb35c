/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_NP2KAI_PCCORE_H
#define SUPERFRAME_TESTS_NP2KAI_PCCORE_H

#include "compiler.h"

typedef struct {
    int unused;
} NP2CFG;

struct core_state {
    UINT8 screenupdate;
};
extern struct core_state pcstat;

#endif
