/* SPDX-License-Identifier: MIT */
/* The arithmetic fx, the same bits, for CPUs of 32 bits. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME fx

#include "../estimate_division.h"
#include "../fixed_unwatched.h"
#include "../leading_zeros_counted.h"
#include "../product_whole.h"
#include "../registers_32.h"
#include "../room_unasked.h"
#include "../root_table.h"

#include "../fixed.h"

#endif
