/* SPDX-License-Identifier: MIT */
/* The arithmetic q16_epsilon: Q16.16 in every role, with an absolute epsilon of 2^-10. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME q16_epsilon

/* A crossing nearer than 2^-10 scaled units is taken for the surface that the ray starts on. */
#define LENGTH_EPSILON REAL_LENGTH(0.0009765625)

#include "../q16/q16.h"

#endif
