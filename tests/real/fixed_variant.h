/* SPDX-License-Identifier: MIT */
/* The suite of a folder of fx that has other insides: included after its real.h. */
#ifndef SUPERFRAME_FIXED_VARIANT_H
#define SUPERFRAME_FIXED_VARIANT_H

#include "fingerprint.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void the_operations_have_the_fingerprint_of_fx(void **state) {
    (void)state;
    assert_true(fingerprint_of_operations(200000) == FINGERPRINT_OF_FX);
}

static void all_reciprocals_near_powers_of_two_are_the_nearest_integer(void **state) {
    (void)state;
    for (uint32_t i = 0; i < 100000; i++) {
        const uint32_t arguments[3] = {UINT32_C(0x80000000) + i, UINT32_MAX - i,
                                       UINT32_C(0x80000000) + i * 21474};
        for (int j = 0; j < 3; j++) {
            uint32_t m = arguments[j];
            int64_t rest = (int64_t)((UINT64_C(1) << 62) - (uint64_t)fixed_reciprocal(m) * m);
            assert_true(2 * rest <= (int64_t)m && -2 * rest <= (int64_t)m);
        }
    }
}

static int32_t ended(int64_t exact) {
    return exact > INT32_MAX ? INT32_MAX : exact < -INT32_MAX ? -INT32_MAX : (int32_t)exact;
}

static void expect_results(int64_t v, unsigned shift) {
    int32_t expected = ended(fixed_rounded(v, shift));
    assert_int_equal(fixed_result_by(FIXED_length_over, v, shift), expected);
    if (shift >= 9) {
        assert_int_equal(fixed_result(FIXED_length_dot, v, shift), expected);
    }
}

/* Around the end of the format, around 255/256 and a half of it, and around 0. */
static void shifts_near_their_ends_are_exact(void **state) {
    (void)state;
    for (unsigned shift = 1; shift <= 30; shift++) {
        const int64_t end = (int64_t)1 << (31 + shift);
        const int64_t middles[4] = {end, end - end / 256, end / 2, 0};
        const int64_t eighth = shift < 3 ? 1 : (int64_t)1 << (shift - 3);
        for (int i = 0; i < 4; i++) {
            for (int j = -40; j <= 40; j++) {
                int64_t v = middles[i] + j * eighth + j % 2;
                expect_results(v, shift);
                expect_results(-v, shift);
            }
        }
    }
}

static void sums_near_their_ends_are_exact(void **state) {
    static const int32_t firsts[5] = {0, (INT32_C(1) << 29) - 4, (INT32_C(1) << 30) - 4,
                                      (INT32_C(3) << 29) - 4, INT32_MAX - 7};
    (void)state;
    for (int i = 0; i < 25 * 64; i++) {
        int32_t a = firsts[i % 5] + i / 25 % 8, b = firsts[i / 5 % 5] + i / 200;
        assert_int_equal(length_add(a, b), ended((int64_t)a + b));
        assert_int_equal(length_add(-a, b), ended((int64_t)b - a));
        assert_int_equal(length_add(-a, -b), ended(-(int64_t)a - b));
        assert_int_equal(length_subtract(a, b), ended((int64_t)a - b));
        assert_int_equal(length_subtract(a, -b), ended((int64_t)a + b));
        assert_int_equal(length_subtract(-a, b), ended(-(int64_t)a - b));
    }
}

static int run_fixed_variant(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_operations_have_the_fingerprint_of_fx),
        cmocka_unit_test(all_reciprocals_near_powers_of_two_are_the_nearest_integer),
        cmocka_unit_test(shifts_near_their_ends_are_exact),
        cmocka_unit_test(sums_near_their_ends_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
