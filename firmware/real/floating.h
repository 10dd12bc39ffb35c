/* SPDX-License-Identifier: MIT */
/* Every operation of real.h for a binary floating-point format; strict/real.h is the contract. */

/* Included by f32/real.h, f64/real.h, f128/real.h and lab/wrapped.h. Defined before are the format
 * `floating`, its square root floating_root(), and the noise of a computed t, LENGTH_NOISE.
 *
 * Errors are those of the roundings in each formula, as written: docs/numerics.md lists them. No
 * operation makes a NaN or an infinity of finite arguments that keep the contract. */

#include <stdbool.h>
#include <stdint.h>

typedef floating real_length;
typedef floating real_area;
typedef floating real_unit;
typedef floating real_index;
typedef floating real_energy;
typedef floating real_colour;
typedef floating real_extinction;
typedef floating real_slope;
typedef floating real_wide;

#define REAL_LENGTH(x)     ((floating)(x))
#define REAL_AREA(x)       ((floating)(x))
#define REAL_UNIT(x)       ((floating)(x))
#define REAL_INDEX(x)      ((floating)(x))
#define REAL_ENERGY(x)     ((floating)(x))
#define REAL_COLOUR(x)     ((floating)(x))
#define REAL_EXTINCTION(x) ((floating)(x))

#define LENGTH_VALUE(a) ((double)(a))
#define UNIT_VALUE(a)   ((double)(a))
#define ENERGY_VALUE(a) ((double)(a))
#define COLOUR_VALUE(a) ((double)(a))

#define LENGTH_FAR REAL_LENGTH(2047.0)

static inline real_length length_add(real_length a, real_length b) {
    return a + b;
}

static inline real_length length_subtract(real_length a, real_length b) {
    return a - b;
}

static inline real_length length_negate(real_length a) {
    return -a;
}

static inline bool length_less(real_length a, real_length b) {
    return a < b;
}

static inline bool length_is_zero(real_length a) {
    return !(a < 0) && !(a > 0);
}

static inline real_length length_along(real_length origin, real_length t, real_unit u) {
    return origin + t * u;
}

static inline real_length length_dot(real_length x, real_length y, real_length z, real_unit u,
                                     real_unit v, real_unit w) {
    return x * u + y * v + z * w;
}

static inline real_length length_scaled(real_length a, real_unit u) {
    return a * u;
}

static inline floating floating_clamped(floating x, floating most) {
    return x > most ? most : x < -most ? -most : x;
}

/* Returns 1 / u, bounded at 2^100: 1 / u may be infinite for a subnormal u, and 0 times infinity is
 * no number. A bounded slope still takes every length from 2^-80 up far beyond LENGTH_FAR. */
static inline real_slope slope_of(real_unit u) {
    return floating_clamped(1 / u, (floating)0x1p100);
}

/* Returns a / u for the slope of u. Needs no saturation: the largest slope leaves the product far
 * below the format's end. */
static inline real_length length_over(real_length a, real_slope slope) {
    return a * slope;
}

static inline bool length_cell_is_odd(real_length a, real_length size) {
    floating ratio = a / size;
    /* Otherwise the cells are finer than a length in fixed point: no pattern that an image could
     * show. */
    bool is_shown = ratio > -(floating)0x1p31 && ratio < (floating)0x1p31;
    floating cells = is_shown ? ratio : 0;
    int32_t cell = (int32_t)cells; /* towards zero */
    cell -= (floating)cell > cells ? 1 : 0;
    return (cell & 1) != 0;
}

static inline real_area area_product(real_length a, real_length b) {
    return a * b;
}

static inline real_area area_norm(real_length x, real_length y, real_length z) {
    return x * x + y * y + z * z;
}

static inline real_area area_add(real_area a, real_area b) {
    return a + b;
}

static inline real_area area_subtract(real_area a, real_area b) {
    return a - b;
}

static inline bool area_is_negative(real_area a) {
    return a < 0;
}

static inline real_area area_scaled(real_area a, real_unit u) {
    return a * u;
}

static inline real_length length_root(real_area a) {
    return a > 0 ? floating_root(a) : 0;
}

static inline real_length length_quotient(real_area a, real_length b) {
    return floating_clamped(a / b, (floating)2048);
}

static inline bool unit_is_zero(real_unit u) {
    return !(u < 0) && !(u > 0);
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
    return ax * bx + ay * by + az * bz;
}

static inline real_unit unit_product(real_unit a, real_unit b) {
    return a * b;
}

static inline real_unit unit_add(real_unit a, real_unit b) {
    return a + b;
}

static inline real_wide wide_component(real_unit forward, real_unit column, int16_t x,
                                       real_unit row, int16_t y, unsigned shift) {
    floating pitch = 1 / (floating)((int32_t)1 << shift);
    return forward + ((floating)x * column + (floating)y * row) * pitch;
}

static inline real_wide wide_sum(real_unit a, real_unit b) {
    return a + b;
}

static inline void unit_normalise_wide(real_wide x, real_wide y, real_wide z, real_unit *u,
                                       real_unit *v, real_unit *w) {
    floating norm = x * x + y * y + z * z;
    floating inverse = 1 / floating_root(norm > 0 ? norm : 1);
    *u = x * inverse;
    *v = y * inverse;
    *w = z * inverse;
}

static inline void unit_normalise_lengths(real_length x, real_length y, real_length z, real_unit *u,
                                          real_unit *v, real_unit *w, real_length *length) {
    floating norm = x * x + y * y + z * z;
    if (norm > 0) {
        *length = floating_root(norm);
        floating inverse = 1 / *length;
        *u = x * inverse;
        *v = y * inverse;
        *w = z * inverse;
    } else {
        *length = *u = *v = *w = 0;
    }
}

static inline real_unit unit_mirrored(real_unit d, real_unit c, real_unit n) {
    return d + 2 * c * n;
}

static inline bool unit_refracted_cosine(real_unit c, real_index eta, real_unit *refracted) {
    floating k = 1 - eta * eta * ((1 - c) * (1 + c));
    if (!(k >= 0)) {
        return false;
    }
    *refracted = floating_root(k);
    return true;
}

static inline real_index index_bend(real_index eta, real_unit c, real_unit refracted) {
    return eta * c - refracted;
}

static inline real_unit unit_bent(real_unit d, real_index eta, real_index bend, real_unit n) {
    return eta * d + bend * n;
}

static inline real_index index_product(real_index a, real_index b) {
    return a * b;
}

static inline real_index index_scaled(real_index a, real_unit u) {
    return a * u;
}

static inline real_index index_of_unit(real_unit u) {
    return u;
}

static inline real_index index_add(real_index a, real_index b) {
    return a + b;
}

static inline real_index index_subtract(real_index a, real_index b) {
    return a - b;
}

static inline real_energy energy_product(real_energy a, real_energy b) {
    return a * b;
}

static inline real_energy energy_add(real_energy a, real_energy b) {
    return a + b;
}

static inline real_energy energy_complement(real_energy a) {
    return 1 - a;
}

static inline bool energy_less(real_energy a, real_energy b) {
    return a < b;
}

static inline bool energy_is_zero(real_energy a) {
    return !(a < 0) && !(a > 0);
}

static inline real_energy energy_of_cosine(real_unit cosine) {
    return cosine > 1 ? 1 : cosine > 0 ? cosine : 0;
}

static inline real_energy energy_ratio(real_index part, real_index whole) {
    return unit_is_zero(whole) ? 0 : part / whole;
}

static inline real_energy energy_mean_square(real_energy a, real_energy b) {
    return (a * a + b * b) / 2;
}

typedef floating real_power;
#define POWER_ONE ((floating)1)

static inline real_power power_of(real_energy base) {
    return base;
}

static inline real_power power_product(real_power a, real_power b) {
    return a * b;
}

static inline real_energy energy_of_power(real_power power) {
    return power;
}

static inline real_energy energy_power(real_energy base, uint16_t exponent) {
    floating result = 1;
    for (floating square = base; exponent != 0; exponent >>= 1) {
        if (exponent & 1) {
            result *= square;
        }
        square *= square;
    }
    return result;
}

/* Returns exp(-x), x = extinction * way, as 2^-whole * 2^-rest with |rest| <= 1/2. The rest's
 * Taylor series has as many terms as the format resolves. (The terms fall below 2^-120 before the
 * bound of the loop.) */
static inline real_energy energy_transmitted(real_extinction extinction, real_length way) {
    /* log2(e) and ln(2) as sums of two doubles: 106 bits, enough for __float128's results here. */
    const floating log2_e = (floating)1.4426950408889634 + (floating)2.0355273740931033e-17;
    const floating ln_2 = (floating)0.6931471805599453 + (floating)2.3190468138462996e-17;
    floating doublings = extinction * way * log2_e;
    if (!(doublings > 0)) {
        return 1;
    }
    if (doublings > 120) {
        return 0;
    }
    int32_t whole = (int32_t)(doublings + (floating)0.5);
    floating x = ((floating)whole - doublings) * ln_2;
    floating term = 1;
    floating sum = 1;
    for (int n = 1; n < 40; n++) {
        floating before = sum;
        term = term * x / (floating)n;
        sum += term;
        if (!(sum < before) && !(sum > before)) {
            break;
        }
    }
    for (; whole > 0; whole--) {
        sum /= 2;
    }
    return sum;
}

/* Returns the end of the fixed-point image's colours. */
static inline floating colour_most(void) {
    return (floating)32767.99;
}

static inline real_colour colour_add(real_colour a, real_colour b) {
    return floating_clamped(a + b, colour_most());
}

static inline real_colour colour_scaled(real_colour a, real_energy share) {
    return a * share;
}

static inline real_colour colour_lit(real_colour a, real_colour light) {
    return a * (light / 255);
}

static inline real_colour colour_faded(real_colour a, real_length distance, int exponent) {
    floating unit = 1;
    for (; exponent > 0; exponent--) {
        unit *= 2;
    }
    for (; exponent < 0; exponent++) {
        unit /= 2;
    }
    if (!(distance > 0)) {
        return a > 0 ? colour_most() : a;
    }
    /* In this order 0 stays 0 at any distance. */
    return floating_clamped(a * unit / distance, colour_most());
}

/* Rounds x to an integer, halves away from zero, saturated at +-(2^31 - 128). Adding a half is
 * itself rounded: a number just below a half goes up to one. In f32 the magnitude of an odd integer
 * between 2^23 and 2^24 goes up by one. */
static inline int32_t floating_steps(floating x) {
    x = floating_clamped(x, (floating)2147483520.0);
    return (int32_t)(x < 0 ? x - (floating)0.5 : x + (floating)0.5);
}

static inline int32_t colour_steps(real_colour a) {
    return floating_steps(a * 65536);
}

static inline real_colour colour_of_steps(int32_t steps) {
    return (floating)steps / 65536;
}

static inline int32_t energy_steps(real_energy a) {
    return floating_steps(a * 1073741824);
}

/* Returns the level to nearest. Adding a half first would round a number just below a half up to
 * one. */
static inline uint8_t colour_level(real_colour a) {
    if (!(a > 0)) {
        return 0;
    }
    if (a >= 255) {
        return 255;
    }
    uint8_t level = (uint8_t)a;
    return a - (floating)level >= (floating)0.5 ? (uint8_t)(level + 1) : level;
}
