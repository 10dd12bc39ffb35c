/* SPDX-License-Identifier: MIT */
/* What is measured on the paper's pictures: contrasts, colours and steps within an outline. */
#ifndef SUPERFRAME_PAPER_MEASURE_H
#define SUPERFRAME_PAPER_MEASURE_H

#include "lab/paper/paper.h"

/* A mask is a photo of an outline: pixels that are not black are inside. All photos that are
 * measured together have the same size. */

/* How two pictures differ within a mask; a pixel's difference is that of its worst channel. */
struct paper_contrast {
    unsigned long pixels; /* in the mask */
    double mean;          /* LSB */
    double share;         /* of the pixels, 0..1, that differ by PAPER_SEEN or more */
};

/* A difference that counts as seen. 5 of 255 levels are 2 % of the screen's range, about the
 * smallest contrast that an eye tells. Chosen before anything was measured. */
enum { PAPER_SEEN = 5 };

struct paper_contrast paper_contrast(const struct paper_photo *mask, const struct paper_photo *a,
                                     const struct paper_photo *b);

/* The mean level of each primary within a mask, less what is within `hole` (NULL: nothing). */
struct paper_mean {
    double rgb[3];
};

struct paper_mean paper_mean(const struct paper_photo *mask, const struct paper_photo *hole,
                             const struct paper_photo *photo);

/* Returns (largest - smallest) / largest of the three: 0 is grey, 1 a pure colour; 0 for black. */
double paper_chroma(const struct paper_mean *mean);

/* A line of pixels across a smoothly shaded surface. */
struct paper_profile {
    unsigned length;   /* pixels */
    unsigned levels;   /* different levels of the primary */
    unsigned largest;  /* step between neighbours, levels */
    unsigned terraces; /* intervals of 3 pixels or more of one level */
    unsigned cliff;    /* largest step between two terraces that touch */
};

enum { PAPER_TERRACE = 3 };

/* Measures the red profile along the row on which the mask is widest. PAPER_TERRACE pixels at each
 * end are left out: there the eye sees the edge of the object. All 0 where no pixel is left. */
struct paper_profile paper_profile(const struct paper_photo *mask, const struct paper_photo *photo);

#endif
