/* SPDX-License-Identifier: MIT */
/* The steps that make a compiled scene cheaper to render without changing its picture. */
#ifndef SUPERFRAME_COMPILE_OPTIMISE_H
#define SUPERFRAME_COMPILE_OPTIMISE_H

#include "compiler/compiler_internal.h"
#include "compiler/tree.h"

struct optimiser {
    struct compiler *compiler;
    struct csg_tree tree; /* of the object at work */
    unsigned *uses;       /* how often the file's programs name each primitive */
};

/* Leaves out operations that change nothing. Returns false if nothing is left of the tree. */
bool optimise_simplify(struct optimiser *optimiser);

/* Replaces primitives of the tree by one primitive that can stand for them. Primitives stay as they
 * are where there is no room for the new one. */
void optimise_fuse(struct optimiser *optimiser);

/* Cuts off the part of each primitive that lies outside of all that the primitive's programs let
 * through. Returns false with the failure recorded. */
bool optimise_bound(struct optimiser *optimiser);

/* Leaves out of the tables what no program names, and orders the rest as the programs do. Returns
 * false with the failure recorded. */
bool optimise_compact(struct compiler *compiler);

#endif
