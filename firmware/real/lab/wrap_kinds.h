/* SPDX-License-Identifier: MIT */
/* The kinds of operations that wrapped.h tells apart: those of one kind cost about the same. */
#ifndef SUPERFRAME_WRAP_KINDS_H
#define SUPERFRAME_WRAP_KINDS_H

enum wrap_kind {
    WRAP_ADD,       /* a sum or a difference */
    WRAP_TEST,      /* a comparison, a sign, a negation */
    WRAP_PRODUCT,   /* one or two products, one rounding */
    WRAP_DOT,       /* three products */
    WRAP_SLOPE,     /* the reciprocal of a direction's component */
    WRAP_OVER,      /* a length times such a reciprocal */
    WRAP_ROOT,      /* a square root */
    WRAP_QUOTIENT,  /* a division */
    WRAP_NORMALISE, /* a vector made 1 long */
    WRAP_REFRACT,   /* the cosine of the angle of refraction */
    WRAP_POWER,     /* cos^g */
    WRAP_TRANSMIT,  /* an exponential */
    WRAP_CELL,      /* the cell of a pattern */
    WRAP_KINDS,
    WRAP_PART = WRAP_KINDS /* a further result of one operation: not counted */
};

#endif
