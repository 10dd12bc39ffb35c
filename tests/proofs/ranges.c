/* SPDX-License-Identifier: MIT */
/* Calls every operation of fixed point with all that strict/real.h allows; Frama-C reads it. */

/* tests/proofs/ranges.sh has Eva read it; it is never run. An interval stands for all of its values
 * at once, so that an alarm that is not raised is a proof for all of them. There are two mains,
 * because the second takes what the first proves as given. What the contracts of root and
 * reciprocal promise is proved by trial: tests/proofs/root_exhaustive.c. */

#include "__fc_builtin.h"

#include <stdint.h>

#include "real.h"

/*@ requires m >= 0x80000000;
    assigns \result \from m;
    ensures 0x40000000 < \result <= 0x80000000; */
static inline uint32_t fixed_reciprocal(uint32_t m);

/*@ requires m >= 0x4000000000000000 && \valid(rest);
    assigns *rest \from m;
    assigns \result \from m;
    ensures \initialized(rest) && 0 <= *rest <= 2 * \result;
    ensures \result >= 0x80000000; */
static inline uint32_t fixed_root_of_normal(uint64_t m, uint64_t *rest);

/*@ requires norm > 0 && \valid(length);
    assigns *length \from norm;
    assigns \result \from norm;
    ensures \initialized(length);
    ensures 0x40000000 <= \result.mantissa <= 0x7FFFFFFF;
    ensures 1 <= \result.shift <= 32; */
static inline struct fixed_slope fixed_slope_of_norm(uint64_t norm, uint32_t *length);

/*@ requires x < 0xFFFFFFFF00000000;
    assigns \result \from x; */
static inline uint32_t fixed_nearest_root64(uint64_t x);

/*@ requires -2147483647 <= a;
    assigns \result \from a;
    behavior positive: assumes a >= 0; ensures \result == a;
    behavior negative: assumes a < 0; ensures \result == -a;
    complete behaviors; disjoint behaviors; */
static inline uint32_t fixed_magnitude(int32_t a);

/*@ assigns \result \from a;
    behavior positive: assumes a >= 0; ensures \result == a;
    behavior negative: assumes a < 0; ensures \result == -a;
    complete behaviors; disjoint behaviors; */
static inline uint64_t fixed_magnitude64(int64_t a);

static int32_t between(int32_t least, int32_t most) {
    return (int32_t)Frama_C_long_interval(least, most);
}

static int32_t value(void) {
    return between(-INT32_MAX, INT32_MAX);
}

static int32_t positive(void) {
    return between(1, INT32_MAX);
}

static int32_t negative(void) {
    return between(-INT32_MAX, -1);
}

/* A component of a direction: at most 4/3. */
static int32_t direction(void) {
    return between(-1431655765, 1431655765);
}

/* -2^63 too, which the sum of two areas may be. */
static int64_t any_area(void) {
    return Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
}

/* Every result of 32 bits is one of the format: -2^31 is none. */
static void is_value(int32_t result) {
    //@ assert -2147483647 <= result;
}

static void lengths(void) {
    is_value(length_add(value(), value()));
    is_value(length_subtract(value(), value()));
    is_value(length_negate(value()));
    is_value(length_along(value(), value(), value()));
    is_value(length_dot(value(), value(), value(), direction(), direction(), direction()));
    is_value(length_scaled(value(), value()));
    (void)length_less(value(), value());
    (void)length_is_zero(value());
    (void)length_cell_is_odd(value(), positive());
    is_value(length_root(any_area()));
}

static void areas(void) {
    (void)area_product(value(), value());
    (void)area_norm(value(), value(), value());
    (void)area_add(any_area(), any_area());
    (void)area_subtract(any_area(), any_area());
    (void)area_scaled(any_area(), value());
    (void)area_is_negative(any_area());
}

/* What divides, by the powers of two that it may lie between: u is positive. */
static void quotients_by(int32_t u) {
    is_value(length_over(value(), slope_of(u)));
    is_value(length_over(value(), slope_of(-u)));
    is_value(length_quotient(any_area(), u));
    is_value(length_quotient(any_area(), -u));
    is_value(energy_ratio(value(), u));
    is_value(energy_ratio(value(), -u));
    is_value(colour_faded(value(), u, between(-30, 30)));
}

static void quotients(void) {
    //@ loop unroll 31;
    for (unsigned bits = 0; bits < 31; bits++) {
        int32_t least = (int32_t)1 << bits;
        quotients_by(between(least, least + (least - 1)));
    }
    is_value(energy_ratio(value(), 0));
    is_value(colour_faded(value(), 0, between(-30, 30)));
    is_value(colour_faded(value(), negative(), between(-30, 30)));
}

static void directions(void) {
    real_unit u;
    real_unit v;
    real_unit w;
    real_length length;
    is_value(
        unit_dot(direction(), direction(), direction(), direction(), direction(), direction()));
    is_value(unit_product(value(), value()));
    is_value(unit_add(value(), value()));
    is_value(unit_negate(value()));
    is_value(unit_mirrored(value(), value(), value()));
    is_value(unit_bent(value(), value(), value(), value()));
    if (unit_refracted_cosine(value(), positive(), &u)) {
        is_value(u);
    }
    (void)unit_is_zero(value());
    (void)unit_is_negative(value());
    (void)unit_less(value(), value());
    unit_normalise_lengths(value(), value(), value(), &u, &v, &w, &length);
    is_value(length);
}

/* One of the three lies between two powers of two, of either sign; the others are as large at most.
 */
static void normalise_wide(int64_t least, int64_t most) {
    real_unit u;
    real_unit v;
    real_unit w;
    int64_t any = Frama_C_long_long_interval(-most, most);
    int64_t other = Frama_C_long_long_interval(-most, most);
    int64_t large = Frama_C_long_long_interval(least, most);
    unit_normalise_wide(large, any, other, &u, &v, &w);
    is_value(u);
    unit_normalise_wide(-large, any, other, &u, &v, &w);
    is_value(v);
    unit_normalise_wide(any, large, other, &u, &v, &w);
    is_value(w);
    unit_normalise_wide(any, -large, other, &u, &v, &w);
    unit_normalise_wide(any, other, large, &u, &v, &w);
    unit_normalise_wide(any, other, -large, &u, &v, &w);
}

/* A camera's ray for the coordinates of a picture, and sums of two directions. */
static void wides(void) {
    int16_t x = (int16_t)between(-1280, 1280);
    int16_t y = (int16_t)between(-1280, 1280);
    real_wide wide = wide_component(value(), value(), x, value(), y, (unsigned)between(0, 16));
    real_wide sum = wide_sum(value(), value());
    //@ assert -(1LL << 59) < wide < (1LL << 59);
    //@ assert -(1LL << 59) < sum < (1LL << 59);
    //@ loop unroll 59;
    for (unsigned bits = 0; bits < 59; bits++) {
        int64_t least = (int64_t)1 << bits;
        normalise_wide(least, least + (least - 1));
    }
    real_unit null[3];
    unit_normalise_wide(0, 0, 0, &null[0], &null[1], &null[2]);
    is_value(null[0]);
}

static void energies(void) {
    is_value(index_bend(value(), value(), value()));
    is_value(index_product(value(), value()));
    is_value(index_scaled(value(), value()));
    is_value(index_of_unit(value()));
    is_value(index_add(value(), value()));
    is_value(index_subtract(value(), value()));
    is_value(energy_product(value(), value()));
    is_value(energy_add(value(), value()));
    is_value(energy_complement(value()));
    is_value(energy_of_cosine(value()));
    is_value(energy_mean_square(value(), value()));
    is_value(energy_power(value(), (uint16_t)between(0, UINT16_MAX)));
    is_value(energy_transmitted(value(), value()));
    is_value(energy_steps(value()));
    (void)energy_less(value(), value());
    (void)energy_is_zero(value());
}

static void colours(void) {
    is_value(colour_add(value(), value()));
    is_value(colour_scaled(value(), value()));
    is_value(colour_lit(value(), value()));
    is_value(colour_steps(value()));
    is_value(colour_of_steps(value()));
    (void)colour_level(value());
}

void operations(void) {
    lengths();
    areas();
    quotients();
    directions();
    wides();
    energies();
    colours();
}

/* A norm lies between two powers of two, and so do what it is made of. */
void kernels(void) {
    //@ loop unroll 64;
    for (unsigned bits = 0; bits < 64; bits++) {
        uint64_t least = (uint64_t)1 << bits;
        uint64_t most = bits < 63 ? least + (least - 1) : 0xFFFFFFFEFFFFFFFF;
        uint64_t norm = Frama_C_unsigned_long_long_interval(least, most);
        uint32_t length;
        (void)fixed_slope_of_norm(norm, &length);
        (void)fixed_nearest_root64(norm);
    }
    (void)fixed_nearest_root64(0);
}
