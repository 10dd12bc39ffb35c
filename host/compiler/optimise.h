/* SPDX-License-Identifier: MIT */
/* The steps that make a compiled scene cheaper to render without changing its picture. */
#ifndef SUPERFRAME_COMPILE_OPTIMISE_H
#define SUPERFRAME_COMPILE_OPTIMISE_H

#include "compiler/compiler_internal.h"
#include "compiler/tree.h"

struct optimiser {
    struct compiler *compiler;
    struct csg_tree tree;                /* of the object at work */
    unsigned uses[COMPILED_DRAFTS_MOST]; /* how often programs name each primitive */
};

/* Leaves out operations that say nothing; false if nothing is left of the tree. */
bool optimise_simplify(struct optimiser *optimiser);

/* Primitives of the tree that one primitive can stand for. Those that can't be made for lack of
 * room are left as they are. */
void optimise_fuse(struct optimiser *optimiser);

/* Cuts off what of each primitive lies outside of all that its programs let through. */
void optimise_bound(struct optimiser *optimiser);

/* Leaves out of the tables what no program names, in the order of the programs; false with the
 * failure recorded if too much is left. */
bool optimise_compact(struct compiler *compiler);

#endif
