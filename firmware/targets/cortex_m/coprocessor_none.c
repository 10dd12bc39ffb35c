/* SPDX-License-Identifier: MIT */
/* A Cortex-M without a floating-point unit. */
#include "coprocessor.h"

void coprocessor_enable(void) {}
