/* SPDX-License-Identifier: MIT */
/* The arithmetic fx, the same bits, for hosts with vectors of 64-bit numbers. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME fx

#include "../estimate_float.h"
#include "../fixed_unwatched.h"
#include "../leading_zeros_counted.h"
#include "../product_whole.h"
#include "../registers_64.h"
#include "../room_unasked.h"

#include "../fixed.h"

#endif
