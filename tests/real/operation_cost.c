/* SPDX-License-Identifier: MIT */
/* The hot operations of fixed point as functions of their own, for operation_cost.sh to count. */
#include "real.h"

real_length along(real_length origin, real_length t, real_unit u);
real_length dot(const real_length *p, const real_unit *d);
real_slope slope(real_unit u);
real_length over(real_length a, real_slope s);
real_length root(real_area a);
real_length quotient(real_area a, real_length b);
bool refracted(real_unit c, real_index eta, real_unit *result);
void normalise(const real_length *p, real_unit *d, real_length *length);
real_unit bent(real_unit d, real_index eta, real_index bend, real_unit n);
real_unit mirrored(real_unit d, real_unit c, real_unit n);
real_energy transmitted(real_extinction extinction, real_length way);
bool cell_is_odd(real_length a, real_length size);

real_length along(real_length origin, real_length t, real_unit u) {
    return length_along(origin, t, u);
}

real_length dot(const real_length *p, const real_unit *d) {
    return length_dot(p[0], p[1], p[2], d[0], d[1], d[2]);
}

real_slope slope(real_unit u) {
    return slope_of(u);
}

real_length over(real_length a, real_slope s) {
    return length_over(a, s);
}

real_length root(real_area a) {
    return length_root(a);
}

real_length quotient(real_area a, real_length b) {
    return length_quotient(a, b);
}

bool refracted(real_unit c, real_index eta, real_unit *result) {
    return unit_refracted_cosine(c, eta, result);
}

void normalise(const real_length *p, real_unit *d, real_length *length) {
    unit_normalise_lengths(p[0], p[1], p[2], &d[0], &d[1], &d[2], length);
}

real_unit bent(real_unit d, real_index eta, real_index bend, real_unit n) {
    return unit_bent(d, eta, bend, n);
}

real_unit mirrored(real_unit d, real_unit c, real_unit n) {
    return unit_mirrored(d, c, n);
}

real_energy transmitted(real_extinction extinction, real_length way) {
    return energy_transmitted(extinction, way);
}

bool cell_is_odd(real_length a, real_length size) {
    return length_cell_is_odd(a, size);
}
