/* SPDX-License-Identifier: MIT */
/* The contract of every arithmetic: what each operation means, for any number format. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#include <stdbool.h>
#include <stdint.h>

/* The renderer is written against this file. Here each role is a pointer to a struct that does not
 * exist. So the compiler rejects raw arithmetic and the mixing of roles. Nothing is defined, and
 * `make strict` only compiles. The other directories give the same names to numbers. A comment at
 * each role says what the role holds, and its format in fx (fixed point). The float images have
 * float, double or __float128 for all roles.
 *
 * In fx every result is rounded to nearest, halves away from zero, and saturated at the format's
 * ends, never wrapped. The ends are symmetric: -2^31 is no value, so a negation never overflows.
 * The errors below are those of fx, and LSB is the last bit of the result's fixed-point format. A
 * float image has the roundings of its formula instead, and saturates only where it says so:
 * docs/numerics.md has a table.
 *
 * Lengths are in the scaled unit of the compiled scene. What is solid lies within +-512; what was
 * unbounded is cut at +-1024. The sums of three products (length_dot, unit_dot) take components of
 * directions, which are at most 4/3. All other operations take any value of the format. */

#define REAL_NAME strict

typedef struct strict_length *real_length;         /* position, distance, size: Q11.20 */
typedef struct strict_area *real_area;             /* square of a length: Q23.40 in 64 bits */
typedef struct strict_unit *real_unit;             /* component of a direction, cosine: Q1.30 */
typedef struct strict_index *real_index;           /* index of refraction, ratio: Q3.28 */
typedef struct strict_energy *real_energy;         /* reflectance, weight, cos^g: Q1.30 */
typedef struct strict_colour *real_colour;         /* intensity in levels, 255 = white: Q15.16 */
typedef struct strict_extinction *real_extinction; /* absorption per unit of length: Q3.28 */
typedef struct strict_slope *real_slope; /* reciprocal of a unit: 32-bit mantissa, shift */
typedef struct strict_wide *real_wide;   /* component before normalising: 64 bits, Q17.46 */

/* ---- Constants: usable in static initialisers; the argument is a double in the range given. -- */

#define REAL_LENGTH(x)     ((real_length)0)     /* |x| < 2048 */
#define REAL_AREA(x)       ((real_area)0)       /* |x| < 2^22 */
#define REAL_UNIT(x)       ((real_unit)0)       /* |x| <= 1 */
#define REAL_INDEX(x)      ((real_index)0)      /* |x| < 8 */
#define REAL_ENERGY(x)     ((real_energy)0)     /* |x| < 2 */
#define REAL_COLOUR(x)     ((real_colour)0)     /* |x| < 32768 levels */
#define REAL_EXTINCTION(x) ((real_extinction)0) /* 0 <= x < 8 per scaled unit */

/* ---- Values as doubles, for a host that looks on: never in a rendering. ---------------------- */

#define LENGTH_VALUE(a) ((a) ? 1.0 : 0.0)
#define UNIT_VALUE(a)   ((a) ? 1.0 : 0.0)
#define ENERGY_VALUE(a) ((a) ? 1.0 : 0.0)
#define COLOUR_VALUE(a) ((a) ? 1.0 : 0.0)

/* No crossing lies here or beyond: t is compared with LENGTH_FAR, and saturates above it. */
#define LENGTH_FAR REAL_LENGTH(2047.0)

/* The noise of a computed t: a chord shorter than this at a ray's very start is rounding. 8 LSB. */
#define LENGTH_NOISE REAL_LENGTH(0.0)

/* The smallest t of a ray's first crossing: 0, because rays snap to the surface that they start on.
 * q16_epsilon has another, to measure what an absolute epsilon does instead. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

/* ---- Lengths --------------------------------------------------------------------------------- */

/* Returns a + b, a - b or -a: exact where the result fits. */
real_length length_add(real_length a, real_length b);
real_length length_subtract(real_length a, real_length b);
real_length length_negate(real_length a);

/* Tells whether a < b, and length_is_zero() whether a is 0. */
bool length_less(real_length a, real_length b);
bool length_is_zero(real_length a);

/* Returns origin + t * u: a coordinate of the point at t along a direction. Error <= 1/2 LSB. */
real_length length_along(real_length origin, real_length t, real_unit u);

/* Returns x*u + y*v + z*w, one rounding: a position measured along a direction.
 * Error <= 1/2 LSB. */
real_length length_dot(real_length x, real_length y, real_length z, real_unit u, real_unit v,
                       real_unit w);

/* Returns a * u. Error <= 1/2 LSB. */
real_length length_scaled(real_length a, real_unit u);

/* Returns 1 / u with a relative error of 2^-31, exact for a power of two above 1 LSB. u must not be
 * zero (unit_is_zero). */
real_slope slope_of(real_unit u);

/* Returns a / u for the slope of u. Never decreases where a increases (u > 0). Error <= 1/2
 * LSB + |a/u| 2^-31. Saturates beyond LENGTH_FAR in fixed point. A float image goes on, to where
 * its slopes end: never to an infinity. */
real_length length_over(real_length a, real_slope slope);

/* Tells whether floor(a / size) is odd: the cell of a pattern. size > 0. Exact in fx; a float image
 * takes the floor of the rounded quotient. */
bool length_cell_is_odd(real_length a, real_length size);

/* ---- Areas ----------------------------------------------------------------------------------- */

/* Returns a * b. Exact. */
real_area area_product(real_length a, real_length b);

/* Returns x^2 + y^2 + z^2. Exact where each is at most 1672; saturates. */
real_area area_norm(real_length x, real_length y, real_length z);

/* Returns a + b or a - b: exact, saturated. */
real_area area_add(real_area a, real_area b);
real_area area_subtract(real_area a, real_area b);

/* Tells whether a < 0. */
bool area_is_negative(real_area a);

/* Returns a * u. Error <= 1/2 LSB of Q23.40; saturates where |u| > 1. */
real_area area_scaled(real_area a, real_unit u);

/* Returns the square root, or 0 for a negative argument. Error <= 1/2 LSB of a length. */
real_length length_root(real_area a);

/* Returns a / b; b must not be zero (length_is_zero). Error <= 1 LSB + |a/b| 2^-30; saturates. */
real_length length_quotient(real_area a, real_length b);

/* ---- Directions and cosines ------------------------------------------------------------------ */

bool unit_is_zero(real_unit u);
bool unit_is_negative(real_unit u);
real_unit unit_negate(real_unit u);

/* Tells whether a < b. */
bool unit_less(real_unit a, real_unit b);

/* Returns the cosine between two directions, one rounding. Error <= 1/2 LSB. */
real_unit unit_dot(real_unit ax, real_unit ay, real_unit az, real_unit bx, real_unit by,
                   real_unit bz);

/* Returns a * b. Error <= 1/2 LSB. */
real_unit unit_product(real_unit a, real_unit b);

/* Returns a + b, for sums that stay within +-1.99. */
real_unit unit_add(real_unit a, real_unit b);

/* Returns forward + (x * column + y * row) / 2^shift: one component of a camera's ray. column and
 * row are half the pixel pitch, scaled up by 2^shift. |x|, |y| <= 1280, 0 <= shift <= 16. */
real_wide wide_component(real_unit forward, real_unit column, int16_t x, real_unit row, int16_t y,
                         unsigned shift);

/* Returns a + b of two directions' components, without loss. */
real_wide wide_sum(real_unit a, real_unit b);

/* Writes the direction of (x, y, z), or (0, 0, 0) for a null vector. Error <= 2 LSB a component. */
void unit_normalise_wide(real_wide x, real_wide y, real_wide z, real_unit *u, real_unit *v,
                         real_unit *w);

/* Writes the direction of (x, y, z) and its length. A null vector gives the direction (0, 0, 0) and
 * length 0. Errors <= 2 LSB a component (of the vector as given) and 1/2 LSB of the length. */
void unit_normalise_lengths(real_length x, real_length y, real_length z, real_unit *u, real_unit *v,
                            real_unit *w, real_length *length);

/* Returns d + 2 c n: a component of the mirror direction, with c = -d.n. Error <= 1/2 LSB. */
real_unit unit_mirrored(real_unit d, real_unit c, real_unit n);

/* Applies Snell's law in cosines: *refracted = sqrt(1 - eta^2 (1 - c^2)). Returns false, and writes
 * nothing, where there is no such root (total internal reflection). eta = n1 / n2 > 0; 0 <= c <= 1,
 * and a c beyond counts as the end in fx. The radicand is formed in 64 bits, to 2^-48.
 * Error <= 0.51 LSB where the result is above 2^-8. */
bool unit_refracted_cosine(real_unit c, real_index eta, real_unit *refracted);

/* Returns eta * c - refracted: the share of the normal in the refracted direction.
 * Error <= 1/2 LSB. */
real_index index_bend(real_index eta, real_unit c, real_unit refracted);

/* Returns eta * d + bend * n: a component of the refracted direction, one rounding.
 * Error <= 1/2 LSB. */
real_unit unit_bent(real_unit d, real_index eta, real_index bend, real_unit n);

/* ---- Indices of refraction ------------------------------------------------------------------- */

/* Returns a * b. Error <= 1/2 LSB. */
real_index index_product(real_index a, real_index b);

/* Returns a * u. Error <= 1/2 LSB. */
real_index index_scaled(real_index a, real_unit u);

/* Returns u as an index. Error <= 1/2 LSB. */
real_index index_of_unit(real_unit u);

real_index index_add(real_index a, real_index b);
real_index index_subtract(real_index a, real_index b);

/* ---- Energies -------------------------------------------------------------------------------- */

/* Returns a * b. Error <= 1/2 LSB. */
real_energy energy_product(real_energy a, real_energy b);

/* Returns a + b: exact, saturated. */
real_energy energy_add(real_energy a, real_energy b);

/* Returns 1 - a. Exact. */
real_energy energy_complement(real_energy a);

/* Tells whether a < b, and energy_is_zero() whether a is 0. */
bool energy_less(real_energy a, real_energy b);
bool energy_is_zero(real_energy a);

/* Returns the cosine as an energy, clamped to 0..1. Exact. */
real_energy energy_of_cosine(real_unit cosine);

/* Returns part / whole, |part| <= |whole|, or 0 where whole is 0. Error <= 1 LSB. */
real_energy energy_ratio(real_index part, real_index whole);

/* Returns (a^2 + b^2) / 2, one rounding. Error <= 1/2 LSB. */
real_energy energy_mean_square(real_energy a, real_energy b);

/* Returns base^exponent for 0 <= base <= 1; x^0 = 1. Error <= 1 LSB + relative 2^-32 exponent. */
real_energy energy_power(real_energy base, uint16_t exponent);

/* Returns exp(-extinction * way), way >= 0 (Lambert-Bouguer, Table 1 (d)). Error <= 1.1 LSB. */
real_energy energy_transmitted(real_extinction extinction, real_length way);

/* ---- Colours --------------------------------------------------------------------------------- */

/* Returns a + b: exact, saturated. */
real_colour colour_add(real_colour a, real_colour b);

/* Returns a * share. Error <= 1/2 LSB. */
real_colour colour_scaled(real_colour a, real_energy share);

/* Returns a * light / 255: a surface's colour under a coloured light. Error <= 1/2 LSB + 2^-20. */
real_colour colour_lit(real_colour a, real_colour light);

/* Returns a / (distance / 2^exponent), where 2^exponent scaled units make one of the scene file's.
 * Error <= 1/2 LSB + relative 2^-31; |exponent| <= 30. At a distance of 0 or less an a above 0
 * saturates, and any other a stays. */
real_colour colour_faded(real_colour a, real_length distance, int exponent);

/* Returns the intensity in steps of 2^-16 level, to nearest, saturated at +-(2^31 - 1). A float
 * image saturates at +-(2^31 - 128). colour_of_steps() is the inverse. Both, and energy_steps(),
 * are for sums over many pixels, which are formed in integers in every arithmetic. */
int32_t colour_steps(real_colour a);
real_colour colour_of_steps(int32_t steps);

/* Returns the share in steps of 2^-30, to nearest, saturated. */
int32_t energy_steps(real_energy a);

/* Returns the level 0..255 to send to the board: rounded to nearest, clamped. */
uint8_t colour_level(real_colour a);

#endif
