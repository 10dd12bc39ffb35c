/* SPDX-License-Identifier: MIT */
/* The features that an image of the firmware holds: here all, with sets as bits. The include path
 * chooses the file. */
#ifndef SUPERFRAME_FEATURE_SET_H
#define SUPERFRAME_FEATURE_SET_H

#include "features/all.h"

enum { FEATURE_PRIMITIVE_WORDS = 2 /* 32 primitives a word */ };

#include "sets/bits/primitive_set.h"

#endif
