/* SPDX-License-Identifier: MIT */
/* Holds the cores of fixed point to their definitions bit for bit: root, reciprocal, power of two.
 */

/* It names its arithmetic itself, whatever the include path says. `root_exhaustive` tries every
 * argument of root and reciprocal; here are their ends and a sample. */
#include "real/fx/real.h"

#include "fingerprint.h"

#include <quadmath.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

enum { RANDOM_ROUNDS = 1000000 };

static uint64_t random_state = UINT64_C(0x9E3779B97F4A7C15);

static uint64_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

static void hold_root(uint64_t x) {
    uint64_t root = fixed_root64(x);
    if (root * root > x || x - root * root > 2 * root) {
        fail_msg("the root of %llX is not %llX", (unsigned long long)x, (unsigned long long)root);
    }
}

static void the_root_is_the_floor_at_every_edge(void **state) {
    (void)state;
    hold_root(0);
    hold_root(UINT64_MAX);
    for (unsigned bit = 0; bit < 64; bit++) {
        for (uint64_t step = 0; step < 5; step++) {
            hold_root((UINT64_C(1) << bit) + step);
            hold_root((UINT64_C(1) << bit) - 1 - step % 2);
        }
    }
    for (long i = 0; i < RANDOM_ROUNDS; i++) {
        uint64_t random = random_bits();
        uint64_t root = (random >> 32) >> (random % 32);
        root = i % 16 == 0 ? UINT32_MAX - (random & 0xFFFF) : root;
        hold_root(root * root);
        hold_root(root * root + 2 * root);
        hold_root(random);
    }
}

static void the_nearest_root_rounds_up_past_the_half_only(void **state) {
    (void)state;
    for (uint64_t root = 1; root < 70000; root++) {
        assert_int_equal(fixed_nearest_root64(root * root + root), root);
        assert_int_equal(fixed_nearest_root64(root * root + root + 1), root + 1);
    }
}

static void hold_reciprocal(uint64_t m) {
    uint64_t product = fixed_reciprocal((uint32_t)m) * m;
    uint64_t one = UINT64_C(1) << 62;
    if (2 * (product > one ? product - one : one - product) > m) {
        fail_msg("the reciprocal of %llX is off", (unsigned long long)m);
    }
}

static void the_reciprocal_is_the_nearest_integer(void **state) {
    (void)state;
    for (uint64_t top = 0x8000; top <= 0xFFFF; top++) { /* where the estimate's divisor changes */
        for (uint64_t step = 0; step < 4; step++) {
            hold_reciprocal((top << 16) + step);
            hold_reciprocal((top << 16) + 0x8000 + step);
            hold_reciprocal((top << 16) + 0x7FFF - step);
            hold_reciprocal((top << 16) + 0xFFFF - step);
        }
    }
    for (long i = 0; i < RANDOM_ROUNDS; i++) {
        hold_reciprocal((random_bits() >> 33) | (UINT64_C(1) << 31));
    }
}

static void leading_zeros_are_counted(void **state) {
    (void)state;
    for (unsigned bit = 0; bit < 64; bit++) {
        uint64_t x = UINT64_C(1) << bit;
        assert_int_equal(fixed_leading_zeros64(x), 63 - bit);
        assert_int_equal(fixed_leading_zeros64(x + (x - 1)), 63 - bit);
    }
}

/* Exact at 0 and within 1.9 of its last bits elsewhere: half an LSB of an energy. */
static void the_power_of_half_is_right_in_its_last_bits(void **state) {
    (void)state;
    assert_true(fixed_power_of_half(0) == UINT64_C(1) << 32);
    for (long i = 0; i < RANDOM_ROUNDS / 8; i++) {
        uint32_t f = (uint32_t)(random_bits() >> 20);
        __float128 want = 0x1p32 * exp2q(-(__float128)f * 0x1p-32);
        __float128 error = (__float128)fixed_power_of_half(f) - want;
        if (error > 1.9 || error < -1.9) {
            fail_msg("2^-%lX is off by %f", (unsigned long)f, (double)error);
        }
    }
}

static void a_power_of_more_than_one_is_one(void **state) {
    (void)state;
    assert_int_equal(energy_power(REAL_ENERGY(1.5), 3), REAL_ENERGY(1));
    assert_int_equal(energy_power(REAL_ENERGY(-0.5), 3), 0);
}

static void the_operations_have_kept_their_fingerprint(void **state) {
    (void)state;
    assert_true(fingerprint_of_operations(200000) == FINGERPRINT_OF_FX);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_root_is_the_floor_at_every_edge),
        cmocka_unit_test(the_nearest_root_rounds_up_past_the_half_only),
        cmocka_unit_test(the_reciprocal_is_the_nearest_integer),
        cmocka_unit_test(leading_zeros_are_counted),
        cmocka_unit_test(the_power_of_half_is_right_in_its_last_bits),
        cmocka_unit_test(a_power_of_more_than_one_is_one),
        cmocka_unit_test(the_operations_have_kept_their_fingerprint),
    };
    return cmocka_run_group_tests_name("cores of fixed point", tests, NULL, NULL);
}
