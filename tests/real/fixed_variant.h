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

static int run_fixed_variant(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_operations_have_the_fingerprint_of_fx),
        cmocka_unit_test(all_reciprocals_near_powers_of_two_are_the_nearest_integer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
