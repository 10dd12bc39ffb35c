/* SPDX-License-Identifier: MIT */
/* Every operation of real.h in integers: one format per role; strict/real.h is the contract. */

/* Included by the real.h of fx, fx_16, fx_32, fx_m3, fx_vector and checked, where fixed_watch() is
 * defined before.
 *
 * Three conventions hold throughout:
 *
 * - Range: a 32-bit value v has |v| < 2^31, never -2^31 (FIXED_MOST in fixed_bits.h).
 * - Direction: a component of a direction, and a cosine between directions, has |v| <= 4/3. What
 *   the operations below make of directions stays within 1 + 2^-28. Sums of three products need
 *   that bound to fit in 64 bits; all other operations take any value.
 * - Rounding: to nearest, halves away from zero. So f(-a) = -f(a) wherever the formula is odd, and
 *   a mirrored scene gives a mirrored picture.
 *
 * A comment at a product gives the bound that keeps it inside 63 bits. */

#include "fixed_bits.h"
#include "fixed_exp.h"
#include "fixed_power.h"
#include "fixed_reciprocal.h"
#include "fixed_root.h"

#include <stdbool.h>
#include <stdint.h>

typedef int32_t real_length;
typedef int64_t real_area;
typedef int32_t real_unit;
typedef int32_t real_index;
typedef int32_t real_energy;
typedef int32_t real_colour;
typedef int32_t real_extinction;
typedef struct fixed_slope real_slope;
typedef int64_t real_wide; /* 46 bits of fraction */

/* The double x times `scale`, to nearest, halves away from zero, saturated; NaN gives the lower
 * end. The result is a constant where x is one. Scaling by a power of two, truncation and the
 * remainder are all exact. So compiler and CPU cannot differ, whatever the rounding mode or excess
 * precision. x is evaluated several times. */
#define FIXED_CONSTANT(type, most, x, scale)                                                       \
    ((double)(x) * (scale) >= (double)(most)                                                       \
         ? (most)                                                                                  \
         : ((double)(x) * (scale) > -(double)(most)                                                \
                ? (type)((type)((double)(x) * (scale)) +                                           \
                         ((double)(x) * (scale) - (double)(type)((double)(x) * (scale)) >= 0.5) -  \
                         ((double)(x) * (scale) - (double)(type)((double)(x) * (scale)) <= -0.5))  \
                : -(most)))

#define REAL_LENGTH(x)     FIXED_CONSTANT(int32_t, INT32_MAX, x, 1048576.0)
#define REAL_AREA(x)       FIXED_CONSTANT(int64_t, INT64_MAX, x, 1099511627776.0)
#define REAL_UNIT(x)       FIXED_CONSTANT(int32_t, INT32_MAX, x, 1073741824.0)
#define REAL_INDEX(x)      FIXED_CONSTANT(int32_t, INT32_MAX, x, 268435456.0)
#define REAL_ENERGY(x)     FIXED_CONSTANT(int32_t, INT32_MAX, x, 1073741824.0)
#define REAL_COLOUR(x)     FIXED_CONSTANT(int32_t, INT32_MAX, x, 65536.0)
#define REAL_EXTINCTION(x) FIXED_CONSTANT(int32_t, INT32_MAX, x, 268435456.0)

#define FIXED_UNIT_ONE (INT32_C(1) << 30)

#define LENGTH_FAR REAL_LENGTH(2047.0)

#define LENGTH_VALUE(a) ((double)(a) / 1048576.0)
#define UNIT_VALUE(a)   ((double)(a) / 1073741824.0)
#define ENERGY_VALUE(a) ((double)(a) / 1073741824.0)
#define COLOUR_VALUE(a) ((double)(a) / 65536.0)

/* 8 LSB. */
#define LENGTH_NOISE ((real_length)8)

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

/* ---- Lengths --------------------------------------------------------------------------------- */

static inline real_length length_add(real_length a, real_length b) {
    return fixed_added(FIXED_length_add, a, b);
}

static inline real_length length_subtract(real_length a, real_length b) {
    return fixed_subtracted(FIXED_length_subtract, a, b);
}

static inline real_length length_negate(real_length a) {
    return -a;
}

static inline bool length_less(real_length a, real_length b) {
    return a < b;
}

static inline bool length_is_zero(real_length a) {
    return a == 0;
}

static inline real_length length_along(real_length origin, real_length t, real_unit u) {
    /* 2^61 + 2^62 */
    return fixed_result(FIXED_length_along, fixed_raised(origin, 30) + fixed_times(t, u), 30);
}

static inline real_length length_dot(real_length x, real_length y, real_length z, real_unit u,
                                     real_unit v, real_unit w) {
    /* 3 (2^31 - 1) 4/3 2^30 = 2^63 - 2^32: room for the half that rounds */
    return fixed_result(FIXED_length_dot, fixed_times(x, u) + fixed_times(y, v) + fixed_times(z, w),
                        30);
}

static inline real_length length_scaled(real_length a, real_unit u) {
    return fixed_result(FIXED_length_scaled, fixed_times(a, u), 30);
}

static inline real_slope slope_of(real_unit u) {
    uint32_t magnitude = fixed_magnitude(u);
    unsigned zeros = fixed_leading_zeros(magnitude);
    real_slope slope = fixed_slope_of(magnitude << zeros, zeros);
    if (u < 0) {
        slope.mantissa = -slope.mantissa;
    }
    return slope;
}

/* Returns a / u for the slope of u, with an error <= 1/2 LSB + |a/u| 2^-31. The result is monotonic
 * in a, because product, rounding and saturation are. */
static inline real_length length_over(real_length a, real_slope slope) {
    return fixed_over(FIXED_length_over, a, slope);
}

/* Tells whether floor(a / size) is odd. For a < 0 that floor is -1 - floor((-1 - a) / size), and
 * -1 - a is ~a. */
static inline bool length_cell_is_odd(real_length a, real_length size) {
    uint32_t magnitude = (uint32_t)(a < 0 ? ~a : a);
    uint32_t cell = magnitude / (uint32_t)size;
    return ((cell & 1) != 0) != (a < 0);
}

/* ---- Areas ----------------------------------------------------------------------------------- */

static inline real_area area_product(real_length a, real_length b) {
    int64_t product = fixed_times(a, b);
    fixed_watch(FIXED_area_product, product, false);
    return product;
}

static inline uint64_t fixed_norm(int32_t x, int32_t y, int32_t z) {
    /* 3 * 2^62 < 2^64 */
    return (uint64_t)fixed_times(x, x) + (uint64_t)fixed_times(y, y) + (uint64_t)fixed_times(z, z);
}

/* Returns x^2 + y^2 + z^2. Saturates at 2^23, which takes a component above 1672. */
static inline real_area area_norm(real_length x, real_length y, real_length z) {
    uint64_t norm = fixed_norm(x, y, z);
    bool saturated = norm > (uint64_t)INT64_MAX;
    int64_t result = saturated ? INT64_MAX : (int64_t)norm;
    fixed_watch(FIXED_area_norm, result, saturated);
    return result;
}

/* Returns a sum or difference that was formed modulo 2^64. Where the result wrapped, which
 * `saturated` says, returns the end on the side of a. */
static inline int64_t fixed_wrapped64(enum fixed_operation operation, uint64_t wrapped, int64_t a,
                                      bool saturated) {
    int64_t result = !saturated ? (int64_t)wrapped : a < 0 ? -INT64_MAX : INT64_MAX;
    fixed_watch(operation, result, saturated);
    return result;
}

static inline real_area area_add(real_area a, real_area b) {
    uint64_t sum = (uint64_t)a + (uint64_t)b;
    /* The sum wrapped where its sign is neither that of a nor that of b. */
    return fixed_wrapped64(FIXED_area_add, sum, a, (((int64_t)sum ^ a) & ((int64_t)sum ^ b)) < 0);
}

static inline real_area area_subtract(real_area a, real_area b) {
    uint64_t difference = (uint64_t)a - (uint64_t)b;
    return fixed_wrapped64(FIXED_area_subtract, difference, a,
                           ((a ^ b) & ((int64_t)difference ^ a)) < 0);
}

static inline bool area_is_negative(real_area a) {
    return a < 0;
}

static inline real_area area_scaled(real_area a, real_unit u) {
    uint64_t area = fixed_magnitude64(a);
    uint32_t factor = fixed_magnitude(u);
    /* 4 * 2^31 (2^31 - 1) = 2^64 - 2^33, and 2^33 is more than the low half adds. */
    uint64_t high = 4 * (fixed_times_unsigned((uint32_t)(area >> 32), factor));
    uint64_t low = (fixed_times_unsigned((uint32_t)area, factor) + (UINT64_C(1) << 29)) >> 30;
    bool saturated = high + low > (uint64_t)INT64_MAX;
    int64_t scaled = saturated ? INT64_MAX : (int64_t)(high + low);
    fixed_watch(FIXED_area_scaled, scaled, saturated);
    return (a < 0) == (u < 0) ? scaled : -scaled;
}

static inline real_length length_root(real_area a) {
    return a <= 0 ? 0 : fixed_saturated(FIXED_length_root, fixed_nearest_root64((uint64_t)a));
}

/* Returns A / B of the raw values, by the reciprocal of B's 32 leading bits. */
static inline real_length length_quotient(real_area a, real_length b) {
    uint64_t area = fixed_magnitude64(a);
    uint32_t divisor = fixed_magnitude(b);
    unsigned zeros = fixed_leading_zeros(divisor);
    uint32_t r = fixed_reciprocal(divisor << zeros); /* 2^62 / (B 2^zeros), at most 2^31 */
    /* (A r) / 2^32 < 2^62: what the low half drops is below one. */
    uint64_t quotient = fixed_times_unsigned((uint32_t)(area >> 32), r) +
                        (fixed_times_unsigned((uint32_t)area, r) >> 32);
    /* Both paths are computed without a branch, so that a compiler's vectors may take them. */
    bool few = zeros < 30;
    int64_t lowered = (int64_t)(((quotient >> (few ? 29 - zeros : 0)) + 1) >> 1);
    int64_t raised = quotient > INT32_MAX ? (int64_t)1 << 32 : (int64_t)(quotient << (zeros == 31));
    int64_t shifted = few ? lowered : raised;
    return fixed_saturated(FIXED_length_quotient, (a < 0) != (b < 0) ? -shifted : shifted);
}

/* ---- Directions and cosines ------------------------------------------------------------------ */

static inline bool unit_is_zero(real_unit u) {
    return u == 0;
}

static inline bool unit_is_negative(real_unit u) {
    return u < 0;
}

static inline real_unit unit_negate(real_unit u) {
    return -u;
}

static inline bool unit_less(real_unit a, real_unit b) {
    return a < b;
}

static inline real_unit unit_dot(real_unit ax, real_unit ay, real_unit az, real_unit bx,
                                 real_unit by, real_unit bz) {
    /* 3 * (4/3 2^30)^2 = 5.4 2^60 */
    return fixed_result(FIXED_unit_dot,
                        fixed_times(ax, bx) + fixed_times(ay, by) + fixed_times(az, bz), 30);
}

static inline real_unit unit_product(real_unit a, real_unit b) {
    return fixed_result(FIXED_unit_product, fixed_times(a, b), 30);
}

static inline real_unit unit_add(real_unit a, real_unit b) {
    return fixed_added(FIXED_unit_add, a, b);
}

static inline real_wide wide_component(real_unit forward, real_unit column, int16_t x,
                                       real_unit row, int16_t y, unsigned shift) {
    /* Without loss: 2^47 + (2 * 2^15 * 2^31) 2^16 = 2^63 at the very ends of int16_t; 2^58.4 for
     * the coordinates of a picture. */
    return fixed_raised(forward, 16) +
           (fixed_times(column, x) + fixed_times(row, y)) * ((int64_t)1 << (16 - shift));
}

static inline real_wide wide_sum(real_unit a, real_unit b) {
    return fixed_raised(a, 16) + fixed_raised(b, 16);
}

/* Returns the slope that gives (x, y, z) length 1, for norm = x^2 + y^2 + z^2 > 0. The relative
 * error is 2^-31 + 2^-32. *length is the root of the norm, to nearest. */
static inline struct fixed_slope fixed_slope_of_norm(uint64_t norm, uint32_t *length) {
    uint64_t rest;
    unsigned half = fixed_leading_zeros64(norm) / 2;
    uint32_t root = fixed_root_of_normal(norm << (2 * half), &rest);
    uint32_t floor = root >> half;
    *length = floor + (norm - fixed_times_unsigned(floor, floor) > floor);
    if (rest > root && root < UINT32_MAX) {
        root++;
    }
    return fixed_slope_of(root, half);
}

/* Returns a wide component without its `shift` lowest bits, to nearest, in 31 bits and a sign.
 * 0 <= shift; with shift = 0 the component must fit already. */
static inline int32_t fixed_narrowed(int64_t a, unsigned shift) {
    if (shift > 0) {
        a = fixed_rounded(a, shift);
        /* A result that was rounded up to 2^31 goes back to 2^31 - 1. That costs 1 LSB at most, as
         * little as any other error. */
        a = a > FIXED_MOST ? FIXED_MOST : a < -FIXED_MOST ? -FIXED_MOST : a;
    }
    return (int32_t)a;
}

static inline void unit_normalise_wide(real_wide x, real_wide y, real_wide z, real_unit *u,
                                       real_unit *v, real_unit *w) {
    uint64_t most = fixed_magnitude64(x) | fixed_magnitude64(y) | fixed_magnitude64(z);
    unsigned zeros = fixed_leading_zeros64(most | 1);
    unsigned shift = zeros < 33 ? 33 - zeros : 0;
    int32_t a = fixed_narrowed(x, shift);
    int32_t b = fixed_narrowed(y, shift);
    int32_t c = fixed_narrowed(z, shift);
    uint64_t norm = fixed_norm(a, b, c);
    uint32_t length;
    struct fixed_slope slope = fixed_slope_of_norm(norm > 0 ? norm : 1, &length);
    *u = fixed_over(FIXED_unit_normalise_wide, a, slope);
    *v = fixed_over(FIXED_unit_normalise_wide, b, slope);
    *w = fixed_over(FIXED_unit_normalise_wide, c, slope);
}

static inline void unit_normalise_lengths(real_length x, real_length y, real_length z, real_unit *u,
                                          real_unit *v, real_unit *w, real_length *length) {
    uint64_t norm = fixed_norm(x, y, z);
    if (norm == 0) {
        *u = *v = *w = 0;
        *length = 0;
        return;
    }
    uint32_t root;
    struct fixed_slope slope = fixed_slope_of_norm(norm, &root);
    *u = fixed_near(fixed_times(x, slope.mantissa), slope.shift);
    *v = fixed_near(fixed_times(y, slope.mantissa), slope.shift);
    *w = fixed_near(fixed_times(z, slope.mantissa), slope.shift);
    *length = fixed_saturated(FIXED_unit_normalise_lengths, root);
}

static inline real_unit unit_mirrored(real_unit d, real_unit c, real_unit n) {
    /* d + 2cn, halved: 2^60 + 2^62 */
    return fixed_result(FIXED_unit_mirrored, fixed_raised(d, 29) + fixed_times(c, n), 29);
}

/* Returns a * factor / 2^32, truncated. The result fits where a * factor < 2^96. */
static inline uint64_t fixed_product_high(uint64_t a, uint32_t factor) {
    return fixed_times_unsigned((uint32_t)(a >> 32), factor) +
           (fixed_times_unsigned((uint32_t)a, factor) >> 32);
}

static inline bool unit_refracted_cosine(real_unit c, real_index eta, real_unit *refracted) {
    /* A cosine of two rounded directions may exceed 1 by an LSB or two. */
    uint32_t cosine = c > FIXED_UNIT_ONE ? FIXED_UNIT_ONE : c > 0 ? (uint32_t)c : 0;
    uint32_t one = FIXED_UNIT_ONE;
    uint32_t ratio = (uint32_t)eta;
    uint64_t square = fixed_times_unsigned(one - cosine, one + cosine); /* sin^2 2^60, exact */
    /* eta^2 sin^2 in 52 bits of fraction, below 2^58; each step loses less than 8 LSB of those. */
    uint64_t bent = fixed_product_high(fixed_product_high(square, ratio), ratio);
    if (bent > UINT64_C(1) << 52) {
        return false;
    }
    *refracted = fixed_saturated(FIXED_unit_refracted_cosine,
                                 fixed_nearest_root64(((UINT64_C(1) << 52) - bent) << 8));
    return true;
}

static inline real_index index_bend(real_index eta, real_unit c, real_unit refracted) {
    /* 2^62 + 2^59 */
    return fixed_result(FIXED_index_bend, fixed_times(eta, c) - fixed_raised(refracted, 28), 30);
}

static inline real_unit unit_bent(real_unit d, real_index eta, real_index bend, real_unit n) {
    /* 2 (2^31 - 1)^2 = 2^63 - 2^33 + 2: room for the half that rounds */
    return fixed_result(FIXED_unit_bent, fixed_times(d, eta) + fixed_times(bend, n), 28);
}

/* ---- Indices of refraction ------------------------------------------------------------------- */

static inline real_index index_product(real_index a, real_index b) {
    return fixed_result(FIXED_index_product, fixed_times(a, b), 28);
}

static inline real_index index_scaled(real_index a, real_unit u) {
    return fixed_result(FIXED_index_scaled, fixed_times(a, u), 30);
}

static inline real_index index_of_unit(real_unit u) {
    return fixed_near(u, 2);
}

static inline real_index index_add(real_index a, real_index b) {
    return fixed_added(FIXED_index_add, a, b);
}

static inline real_index index_subtract(real_index a, real_index b) {
    return fixed_subtracted(FIXED_index_subtract, a, b);
}

/* ---- Energies -------------------------------------------------------------------------------- */

static inline real_energy energy_product(real_energy a, real_energy b) {
    return fixed_result(FIXED_energy_product, fixed_times(a, b), 30);
}

static inline real_energy energy_add(real_energy a, real_energy b) {
    return fixed_added(FIXED_energy_add, a, b);
}

static inline real_energy energy_complement(real_energy a) {
    return fixed_subtracted(FIXED_energy_complement, FIXED_UNIT_ONE, a);
}

static inline bool energy_less(real_energy a, real_energy b) {
    return a < b;
}

static inline bool energy_is_zero(real_energy a) {
    return a == 0;
}

static inline real_energy energy_of_cosine(real_unit cosine) {
    return cosine > FIXED_UNIT_ONE ? FIXED_UNIT_ONE : cosine > 0 ? cosine : 0;
}

/* Divides by the slope of `whole`. A quotient of two numbers of one format, such as two indices or
 * two lengths, is 2^30 part / whole. */
static inline real_energy energy_ratio(real_index part, real_index whole) {
    if (whole == 0) {
        return 0;
    }
    return fixed_over(FIXED_energy_ratio, part, slope_of(whole));
}

static inline real_energy energy_mean_square(real_energy a, real_energy b) {
    /* 2 (2^31 - 1)^2 = 2^63 - 2^33 + 2: room for the half that rounds */
    return fixed_result(FIXED_energy_mean_square, fixed_times(a, a) + fixed_times(b, b), 31);
}

static inline real_energy energy_transmitted(real_extinction extinction, real_length way) {
    return extinction <= 0 || way <= 0 ? FIXED_UNIT_ONE
                                       : fixed_exponential((uint64_t)fixed_times(extinction, way));
}

/* ---- Colours --------------------------------------------------------------------------------- */

static inline real_colour colour_add(real_colour a, real_colour b) {
    return fixed_added(FIXED_colour_add, a, b);
}

static inline real_colour colour_scaled(real_colour a, real_energy share) {
    return fixed_result(FIXED_colour_scaled, fixed_times(a, share), 30);
}

/* Multiplies by 1/255 = (1 + 2^-8) (1 + 2^-16) (1 + 2^-32) / 2^8, which is short by a relative
 * 2^-64. */
static inline real_colour colour_lit(real_colour a, real_colour light) {
    uint64_t product = fixed_magnitude64(fixed_times(a, light)); /* < 2^62 */
    product += product >> 8;
    product += product >> 16;
    product += product >> 32;
    product = (product + (UINT64_C(1) << 23)) >> 24;
    bool saturated = product > FIXED_MOST;
    int32_t lit = saturated ? FIXED_MOST : (int32_t)product;
    fixed_watch(FIXED_colour_lit, (int64_t)product, saturated);
    return (a < 0) == (light < 0) ? lit : -lit;
}

static inline real_colour colour_faded(real_colour a, real_length distance, int exponent) {
    if (distance <= 0) {
        return a > 0 ? FIXED_MOST : a;
    }
    real_slope slope = slope_of(distance);
    int64_t product = fixed_times(a, slope.mantissa);
    int shift = (int)slope.shift + 10 - exponent; /* -19 ... 72 */
    if (shift > 62) {
        return 0; /* |product| < 2^62 */
    }
    if (shift > 0) {
        return fixed_saturated(FIXED_colour_faded, fixed_rounded(product, (unsigned)shift));
    }
    /* What is past the end before the shift stays past the end after it. */
    int64_t most = product > FIXED_MOST    ? FIXED_MOST
                   : product < -FIXED_MOST ? -FIXED_MOST
                                           : product;
    return fixed_saturated(FIXED_colour_faded, most * ((int64_t)1 << -shift));
}

static inline int32_t colour_steps(real_colour a) {
    return a;
}

static inline real_colour colour_of_steps(int32_t steps) {
    return steps;
}

static inline int32_t energy_steps(real_energy a) {
    return a;
}

static inline uint8_t colour_level(real_colour a) {
    if (a <= 0) {
        return 0;
    }
    uint32_t level = ((uint32_t)a + UINT32_C(0x8000)) >> 16;
    return level > 255 ? 255 : (uint8_t)level;
}
