/* SPDX-License-Identifier: MIT */
/* Points and directions, in whatever arithmetic the image has. */
#ifndef SUPERFRAME_VECTOR_H
#define SUPERFRAME_VECTOR_H

#include "real.h"

/* A position, or the difference of two, in scaled units. */
struct point {
    real_length x, y, z;
};

/* A vector of length 1. */
struct direction {
    real_unit x, y, z;
};

/* A share for each primary. */
struct energies {
    real_energy red, green, blue;
};

/* An intensity in levels for each primary. */
struct colours {
    real_colour red, green, blue;
};

static inline struct point point_subtract(struct point a, struct point b) {
    struct point difference = {length_subtract(a.x, b.x), length_subtract(a.y, b.y),
                               length_subtract(a.z, b.z)};
    return difference;
}

/* Returns origin + t * direction. */
static inline struct point point_along(struct point origin, real_length t, struct direction d) {
    struct point there = {length_along(origin.x, t, d.x), length_along(origin.y, t, d.y),
                          length_along(origin.z, t, d.z)};
    return there;
}

/* Returns the position of p measured along d. */
static inline real_length point_dot(struct point p, struct direction d) {
    return length_dot(p.x, p.y, p.z, d.x, d.y, d.z);
}

/* Returns the square of the distance from the origin. */
static inline real_area point_norm(struct point p) {
    return area_norm(p.x, p.y, p.z);
}

static inline real_unit direction_dot(struct direction a, struct direction b) {
    return unit_dot(a.x, a.y, a.z, b.x, b.y, b.z);
}

static inline struct direction direction_negate(struct direction d) {
    struct direction back = {unit_negate(d.x), unit_negate(d.y), unit_negate(d.z)};
    return back;
}

static inline struct colours colours_add(struct colours a, struct colours b) {
    struct colours sum = {colour_add(a.red, b.red), colour_add(a.green, b.green),
                          colour_add(a.blue, b.blue)};
    return sum;
}

/* Multiplies each primary by its own share. */
static inline struct colours colours_weighed(struct colours a, struct energies share) {
    struct colours part = {colour_scaled(a.red, share.red), colour_scaled(a.green, share.green),
                           colour_scaled(a.blue, share.blue)};
    return part;
}

/* Rounds a colour to steps of 2^-16 level. Sums of such colours are exact up to 256 levels. */
static inline struct colours colours_in_steps(struct colours a) {
    struct colours rounded = {colour_of_steps(colour_steps(a.red)),
                              colour_of_steps(colour_steps(a.green)),
                              colour_of_steps(colour_steps(a.blue))};
    return rounded;
}

/* Multiplies all primaries by one share. */
static inline struct colours colours_scaled(struct colours a, real_energy share) {
    struct energies same = {share, share, share};
    return colours_weighed(a, same);
}

static inline struct energies energies_product(struct energies a, struct energies b) {
    struct energies product = {energy_product(a.red, b.red), energy_product(a.green, b.green),
                               energy_product(a.blue, b.blue)};
    return product;
}

static inline struct energies energies_scaled(struct energies a, real_energy share) {
    struct energies same = {share, share, share};
    return energies_product(a, same);
}

/* Returns the largest of the three shares, the one that is compared with the threshold. */
static inline real_energy energies_largest(struct energies a) {
    real_energy most = energy_less(a.red, a.green) ? a.green : a.red;
    return energy_less(most, a.blue) ? a.blue : most;
}

#endif
