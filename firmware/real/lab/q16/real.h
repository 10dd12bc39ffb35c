/* SPDX-License-Identifier: MIT */
/* The arithmetic q16: Q16.16 in every role, with rays that snap to surfaces. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME q16

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

#include "q16.h"

#endif
