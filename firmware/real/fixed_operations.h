/* SPDX-License-Identifier: MIT */
/* The operations of fixed.h by name, for the hook that may watch their results. */
#ifndef SUPERFRAME_FIXED_OPERATIONS_H
#define SUPERFRAME_FIXED_OPERATIONS_H

/* Every operation that hands its result to fixed_watch(). */
#define FIXED_OPERATIONS(X)                                                                        \
    X(length_add)                                                                                  \
    X(length_subtract)                                                                             \
    X(length_along)                                                                                \
    X(length_dot)                                                                                  \
    X(length_scaled)                                                                               \
    X(length_over)                                                                                 \
    X(length_root)                                                                                 \
    X(length_quotient)                                                                             \
    X(area_product)                                                                                \
    X(area_norm)                                                                                   \
    X(area_add)                                                                                    \
    X(area_subtract)                                                                               \
    X(area_scaled)                                                                                 \
    X(unit_dot)                                                                                    \
    X(unit_product)                                                                                \
    X(unit_add)                                                                                    \
    X(unit_normalise_wide)                                                                         \
    X(unit_normalise_lengths)                                                                      \
    X(unit_mirrored)                                                                               \
    X(unit_refracted_cosine)                                                                       \
    X(unit_bent)                                                                                   \
    X(index_bend)                                                                                  \
    X(index_product)                                                                               \
    X(index_scaled)                                                                                \
    X(index_add)                                                                                   \
    X(index_subtract)                                                                              \
    X(energy_product)                                                                              \
    X(energy_add)                                                                                  \
    X(energy_complement)                                                                           \
    X(energy_ratio)                                                                                \
    X(energy_mean_square)                                                                          \
    X(colour_add)                                                                                  \
    X(colour_scaled)                                                                               \
    X(colour_lit)                                                                                  \
    X(colour_faded)

#define FIXED_OPERATION_CONSTANT(name) FIXED_##name,

enum fixed_operation { FIXED_OPERATIONS(FIXED_OPERATION_CONSTANT) FIXED_OPERATION_COUNT };

#endif
