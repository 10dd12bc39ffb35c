/* SPDX-License-Identifier: MIT */
/* The paper's claims, each measured by a function of its own. */
#ifndef SUPERFRAME_PAPER_CLAIMS_H
#define SUPERFRAME_PAPER_CLAIMS_H

#include "lab/paper/paper.h"

/* Fills in what was measured, the verdict and why, for the claim of that number. Returns an exit
 * status. While planning all numbers are 0, and what is written is thrown away. The criteria were
 * set before measuring. */
int paper_claim_depth(struct paper *paper, struct paper_claim *claim);      /* 1 */
int paper_claim_nested(struct paper *paper, struct paper_claim *claim);     /* 2 */
int paper_claim_cover(struct paper *paper, struct paper_claim *claim);      /* 3 */
int paper_claim_formula(struct paper *paper, struct paper_claim *claim);    /* 4 */
int paper_claim_size(struct paper *paper, struct paper_claim *claim);       /* 5 */
int paper_claim_visibility(struct paper *paper, struct paper_claim *claim); /* 6 */
int paper_claim_bands(struct paper *paper, struct paper_claim *claim);      /* 7 */
int paper_claim_threshold(struct paper *paper, struct paper_claim *claim);  /* 8 */
int paper_claim_exposures(struct paper *paper, struct paper_claim *claim);  /* 9 */

#endif
