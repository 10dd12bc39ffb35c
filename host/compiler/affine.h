/* SPDX-License-Identifier: MIT */
/* Vectors and affine maps in doubles, for the scene compiler. */
#ifndef SUPERFRAME_AFFINE_H
#define SUPERFRAME_AFFINE_H

#include <stdbool.h>

#include "scene/description.h"

double vector_dot(const double a[3], const double b[3]);
double vector_length(const double a[3]);
void vector_cross(const double a[3], const double b[3], double product[3]);

/* Returns 1 if two directions are the same to the last bit, -1 if they are opposite, else 0. */
double vector_parallel(const double a[3], const double b[3]);

/* Scales a vector to length 1; false, with the vector unchanged, if it is null. */
bool vector_normalise(double a[3]);

/* Returns the map that applies inner first and outer second. */
struct affine affine_compose(const struct affine *outer, const struct affine *inner);

void affine_point(const struct affine *map, const double point[3], double image[3]);

/* Computes the image of an axis's unit vector without translation: column `axis` of the linear
 * part. */
void affine_axis(const struct affine *map, int axis, double image[3]);

extern const struct affine affine_identity;

#endif
