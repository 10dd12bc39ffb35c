/* SPDX-License-Identifier: MIT */
/* One solid in other words. */
#ifndef SUPERFRAME_RELATIONS_WORDING_H
#define SUPERFRAME_RELATIONS_WORDING_H

#include "syntax.h"

/* Swaps `from` and `to` of a solid that both ends of the axis describe; false for all others. */
bool wording_ends(struct syntax_solid *solid);

/* Writes a leaf as another kind, or with other numbers and a placement; false for operations. */
bool wording_leaf(struct syntax_solid *solid, uint64_t *random);

#endif
