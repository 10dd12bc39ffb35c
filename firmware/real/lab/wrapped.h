/* SPDX-License-Identifier: MIT */
/* Every operation of real.h in double. Each result goes through a hook; strict/real.h is the
 * contract. */

/* Included by count/real.h and q16/q16.h. Both define before:
 *
 *   WRAP_VALUE(kind, x)         what becomes of a result of 32 bits in fx.
 *   WRAP_AREA(kind, x)          what becomes of an area.
 *   WRAP_PLAIN(kind, x)         what becomes of anything else, of a test's answer too.
 *   wrap_power(base, exponent)  base^exponent, before the hook.
 *
 * `kind` is an enum wrap_kind. For tests and measurements only: no image that is shipped is built
 * from this file. */

#include "../floating.h"

static inline real_length wrapped_length_add(real_length a, real_length b) {
    return WRAP_VALUE(WRAP_ADD, length_add(a, b));
}

static inline real_length wrapped_length_subtract(real_length a, real_length b) {
    return WRAP_VALUE(WRAP_ADD, length_subtract(a, b));
}

static inline real_length wrapped_length_negate(real_length a) {
    return WRAP_VALUE(WRAP_TEST, length_negate(a));
}

static inline bool wrapped_length_less(real_length a, real_length b) {
    return WRAP_PLAIN(WRAP_TEST, length_less(a, b));
}

static inline bool wrapped_length_is_zero(real_length a) {
    return WRAP_PLAIN(WRAP_TEST, length_is_zero(a));
}

static inline real_length wrapped_length_along(real_length origin, real_length t, real_unit u) {
    return WRAP_VALUE(WRAP_PRODUCT, length_along(origin, t, u));
}

static inline real_length wrapped_length_dot(real_length x, real_length y, real_length z,
                                             real_unit u, real_unit v, real_unit w) {
    return WRAP_VALUE(WRAP_DOT, length_dot(x, y, z, u, v, w));
}

static inline real_length wrapped_length_scaled(real_length a, real_unit u) {
    return WRAP_VALUE(WRAP_PRODUCT, length_scaled(a, u));
}

static inline real_slope wrapped_slope_of(real_unit u) {
    return WRAP_PLAIN(WRAP_SLOPE, slope_of(u));
}

static inline real_length wrapped_length_over(real_length a, real_slope slope) {
    return WRAP_VALUE(WRAP_OVER, length_over(a, slope));
}

static inline bool wrapped_length_cell_is_odd(real_length a, real_length size) {
    return WRAP_PLAIN(WRAP_CELL, length_cell_is_odd(a, size));
}

static inline real_area wrapped_area_product(real_length a, real_length b) {
    return WRAP_AREA(WRAP_PRODUCT, area_product(a, b));
}

static inline real_area wrapped_area_norm(real_length x, real_length y, real_length z) {
    return WRAP_AREA(WRAP_DOT, area_norm(x, y, z));
}

static inline real_area wrapped_area_add(real_area a, real_area b) {
    return WRAP_AREA(WRAP_ADD, area_add(a, b));
}

static inline real_area wrapped_area_subtract(real_area a, real_area b) {
    return WRAP_AREA(WRAP_ADD, area_subtract(a, b));
}

static inline bool wrapped_area_is_negative(real_area a) {
    return WRAP_PLAIN(WRAP_TEST, area_is_negative(a));
}

static inline real_area wrapped_area_scaled(real_area a, real_unit u) {
    return WRAP_AREA(WRAP_PRODUCT, area_scaled(a, u));
}

static inline real_length wrapped_length_root(real_area a) {
    return WRAP_VALUE(WRAP_ROOT, length_root(a));
}

static inline real_length wrapped_length_quotient(real_area a, real_length b) {
    return WRAP_VALUE(WRAP_QUOTIENT, length_quotient(a, b));
}

static inline bool wrapped_unit_is_zero(real_unit u) {
    return WRAP_PLAIN(WRAP_TEST, unit_is_zero(u));
}

static inline bool wrapped_unit_is_negative(real_unit u) {
    return WRAP_PLAIN(WRAP_TEST, unit_is_negative(u));
}

static inline real_unit wrapped_unit_negate(real_unit u) {
    return WRAP_VALUE(WRAP_TEST, unit_negate(u));
}

static inline bool wrapped_unit_less(real_unit a, real_unit b) {
    return WRAP_PLAIN(WRAP_TEST, unit_less(a, b));
}

static inline real_unit wrapped_unit_dot(real_unit ax, real_unit ay, real_unit az, real_unit bx,
                                         real_unit by, real_unit bz) {
    return WRAP_VALUE(WRAP_DOT, unit_dot(ax, ay, az, bx, by, bz));
}

static inline real_unit wrapped_unit_product(real_unit a, real_unit b) {
    return WRAP_VALUE(WRAP_PRODUCT, unit_product(a, b));
}

static inline real_unit wrapped_unit_add(real_unit a, real_unit b) {
    return WRAP_VALUE(WRAP_ADD, unit_add(a, b));
}

static inline real_wide wrapped_wide_component(real_unit forward, real_unit column, int16_t x,
                                               real_unit row, int16_t y, unsigned shift) {
    return WRAP_PLAIN(WRAP_PRODUCT, wide_component(forward, column, x, row, y, shift));
}

static inline real_wide wrapped_wide_sum(real_unit a, real_unit b) {
    return WRAP_PLAIN(WRAP_ADD, wide_sum(a, b));
}

static inline real_unit wrapped_unit_mirrored(real_unit d, real_unit c, real_unit n) {
    return WRAP_VALUE(WRAP_PRODUCT, unit_mirrored(d, c, n));
}

static inline real_index wrapped_index_bend(real_index eta, real_unit c, real_unit refracted) {
    return WRAP_VALUE(WRAP_PRODUCT, index_bend(eta, c, refracted));
}

static inline real_unit wrapped_unit_bent(real_unit d, real_index eta, real_index bend,
                                          real_unit n) {
    return WRAP_VALUE(WRAP_PRODUCT, unit_bent(d, eta, bend, n));
}

static inline real_index wrapped_index_product(real_index a, real_index b) {
    return WRAP_VALUE(WRAP_PRODUCT, index_product(a, b));
}

static inline real_index wrapped_index_scaled(real_index a, real_unit u) {
    return WRAP_VALUE(WRAP_PRODUCT, index_scaled(a, u));
}

static inline real_index wrapped_index_of_unit(real_unit u) {
    return WRAP_VALUE(WRAP_TEST, index_of_unit(u));
}

static inline real_index wrapped_index_add(real_index a, real_index b) {
    return WRAP_VALUE(WRAP_ADD, index_add(a, b));
}

static inline real_index wrapped_index_subtract(real_index a, real_index b) {
    return WRAP_VALUE(WRAP_ADD, index_subtract(a, b));
}

static inline real_energy wrapped_energy_product(real_energy a, real_energy b) {
    return WRAP_VALUE(WRAP_PRODUCT, energy_product(a, b));
}

static inline real_energy wrapped_energy_add(real_energy a, real_energy b) {
    return WRAP_VALUE(WRAP_ADD, energy_add(a, b));
}

static inline real_energy wrapped_energy_complement(real_energy a) {
    return WRAP_VALUE(WRAP_ADD, energy_complement(a));
}

static inline bool wrapped_energy_less(real_energy a, real_energy b) {
    return WRAP_PLAIN(WRAP_TEST, energy_less(a, b));
}

static inline bool wrapped_energy_is_zero(real_energy a) {
    return WRAP_PLAIN(WRAP_TEST, energy_is_zero(a));
}

static inline real_energy wrapped_energy_of_cosine(real_unit cosine) {
    return WRAP_VALUE(WRAP_TEST, energy_of_cosine(cosine));
}

static inline real_energy wrapped_energy_ratio(real_index part, real_index whole) {
    return WRAP_VALUE(WRAP_QUOTIENT, energy_ratio(part, whole));
}

static inline real_energy wrapped_energy_mean_square(real_energy a, real_energy b) {
    return WRAP_VALUE(WRAP_PRODUCT, energy_mean_square(a, b));
}

static inline real_energy wrapped_energy_transmitted(real_extinction extinction, real_length way) {
    return WRAP_VALUE(WRAP_TRANSMIT, energy_transmitted(extinction, way));
}

static inline real_colour wrapped_colour_add(real_colour a, real_colour b) {
    return WRAP_VALUE(WRAP_ADD, colour_add(a, b));
}

static inline real_colour wrapped_colour_scaled(real_colour a, real_energy share) {
    return WRAP_VALUE(WRAP_PRODUCT, colour_scaled(a, share));
}

static inline real_colour wrapped_colour_lit(real_colour a, real_colour light) {
    return WRAP_VALUE(WRAP_PRODUCT, colour_lit(a, light));
}

static inline real_colour wrapped_colour_faded(real_colour a, real_length distance, int exponent) {
    return WRAP_VALUE(WRAP_QUOTIENT, colour_faded(a, distance, exponent));
}

static inline real_energy wrapped_energy_power(real_energy base, uint16_t exponent) {
    return WRAP_VALUE(WRAP_POWER, wrap_power(base, exponent));
}

static inline void wrapped_unit_normalise_wide(real_wide x, real_wide y, real_wide z, real_unit *u,
                                               real_unit *v, real_unit *w) {
    unit_normalise_wide(x, y, z, u, v, w);
    *u = WRAP_VALUE(WRAP_NORMALISE, *u);
    *v = WRAP_VALUE(WRAP_PART, *v);
    *w = WRAP_VALUE(WRAP_PART, *w);
}

static inline void wrapped_unit_normalise_lengths(real_length x, real_length y, real_length z,
                                                  real_unit *u, real_unit *v, real_unit *w,
                                                  real_length *length) {
    unit_normalise_lengths(x, y, z, u, v, w, length);
    *u = WRAP_VALUE(WRAP_NORMALISE, *u);
    *v = WRAP_VALUE(WRAP_PART, *v);
    *w = WRAP_VALUE(WRAP_PART, *w);
    *length = WRAP_VALUE(WRAP_PART, *length);
}

static inline bool wrapped_unit_refracted_cosine(real_unit c, real_index eta,
                                                 real_unit *refracted) {
    bool passes = WRAP_PLAIN(WRAP_REFRACT, unit_refracted_cosine(c, eta, refracted));
    if (passes) {
        *refracted = WRAP_VALUE(WRAP_PART, *refracted);
    }
    return passes;
}

/* From here on the names mean the wrapped operations. */

#define length_add             wrapped_length_add
#define length_subtract        wrapped_length_subtract
#define length_negate          wrapped_length_negate
#define length_less            wrapped_length_less
#define length_is_zero         wrapped_length_is_zero
#define length_along           wrapped_length_along
#define length_dot             wrapped_length_dot
#define length_scaled          wrapped_length_scaled
#define slope_of               wrapped_slope_of
#define length_over            wrapped_length_over
#define length_cell_is_odd     wrapped_length_cell_is_odd
#define area_product           wrapped_area_product
#define area_norm              wrapped_area_norm
#define area_add               wrapped_area_add
#define area_subtract          wrapped_area_subtract
#define area_is_negative       wrapped_area_is_negative
#define area_scaled            wrapped_area_scaled
#define length_root            wrapped_length_root
#define length_quotient        wrapped_length_quotient
#define unit_is_zero           wrapped_unit_is_zero
#define unit_is_negative       wrapped_unit_is_negative
#define unit_negate            wrapped_unit_negate
#define unit_less              wrapped_unit_less
#define unit_dot               wrapped_unit_dot
#define unit_product           wrapped_unit_product
#define unit_add               wrapped_unit_add
#define wide_component         wrapped_wide_component
#define wide_sum               wrapped_wide_sum
#define unit_mirrored          wrapped_unit_mirrored
#define index_bend             wrapped_index_bend
#define unit_bent              wrapped_unit_bent
#define index_product          wrapped_index_product
#define index_scaled           wrapped_index_scaled
#define index_of_unit          wrapped_index_of_unit
#define index_add              wrapped_index_add
#define index_subtract         wrapped_index_subtract
#define energy_product         wrapped_energy_product
#define energy_add             wrapped_energy_add
#define energy_complement      wrapped_energy_complement
#define energy_less            wrapped_energy_less
#define energy_is_zero         wrapped_energy_is_zero
#define energy_of_cosine       wrapped_energy_of_cosine
#define energy_ratio           wrapped_energy_ratio
#define energy_mean_square     wrapped_energy_mean_square
#define energy_transmitted     wrapped_energy_transmitted
#define colour_add             wrapped_colour_add
#define colour_scaled          wrapped_colour_scaled
#define colour_lit             wrapped_colour_lit
#define colour_faded           wrapped_colour_faded
#define energy_power           wrapped_energy_power
#define unit_normalise_wide    wrapped_unit_normalise_wide
#define unit_normalise_lengths wrapped_unit_normalise_lengths
#define unit_refracted_cosine  wrapped_unit_refracted_cosine
