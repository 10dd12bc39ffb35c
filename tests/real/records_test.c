/* SPDX-License-Identifier: MIT */
/* The arithmetic checked records what each operation did, and computes nothing else than fx. */

/* It names its arithmetic itself, whatever the include path says. */
#include "real/lab/checked/record.c"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

static int clear(void **state) {
    (void)state;
    memset(fixed_records, 0, sizeof fixed_records);
    return 0;
}

static void a_result_that_fits_leaves_its_magnitude_and_no_saturation(void **state) {
    (void)state;
    assert_int_equal(length_add(REAL_LENGTH(-3), REAL_LENGTH(1)), REAL_LENGTH(-2));
    assert_int_equal(length_add(REAL_LENGTH(0.5), REAL_LENGTH(1)), REAL_LENGTH(1.5));
    const struct fixed_record *record = &fixed_records[FIXED_length_add];
    assert_int_equal(record->calls, 2);
    assert_int_equal(record->saturations, 0);
    assert_int_equal(record->largest, REAL_LENGTH(2));
}

static void a_saturation_is_counted_with_what_it_would_have_been(void **state) {
    (void)state;
    assert_int_equal(length_add(REAL_LENGTH(2000), REAL_LENGTH(1000)), INT32_MAX);
    assert_int_equal(length_add(REAL_LENGTH(-2000), REAL_LENGTH(-2000)), -INT32_MAX);
    const struct fixed_record *record = &fixed_records[FIXED_length_add];
    assert_int_equal(record->saturations, 2);
    assert_int_equal(record->largest, UINT64_C(4000) << 20);
}

static void saturated_areas_are_counted(void **state) {
    (void)state;
    real_length far = REAL_LENGTH(2047.9);
    real_area most = area_norm(far, far, far);
    assert_true(most == INT64_MAX);
    assert_true(area_add(most, most) == INT64_MAX);
    assert_true(area_subtract(-most, most) == -INT64_MAX);
    assert_true(area_scaled(most, REAL_UNIT(1.5)) == INT64_MAX);
    assert_int_equal(fixed_records[FIXED_area_norm].saturations, 1);
    assert_int_equal(fixed_records[FIXED_area_add].saturations, 1);
    assert_int_equal(fixed_records[FIXED_area_subtract].saturations, 1);
    assert_int_equal(fixed_records[FIXED_area_scaled].saturations, 1);
}

/* One call of each: an operation that forgot to report would never be seen to saturate. */
static void every_operation_is_recorded_under_its_own_name(void **state) {
    (void)state;
    real_length one = REAL_LENGTH(1), length;
    real_area area = REAL_AREA(1);
    real_unit half = REAL_UNIT(0.5), u, v, w;
    real_index index = REAL_INDEX(1.5);
    real_energy energy = REAL_ENERGY(0.5);
    real_colour colour = REAL_COLOUR(100);
#define EXPECT(name, calls_made, expression)                                                       \
    do {                                                                                           \
        (void)(expression);                                                                        \
        assert_string_equal(fixed_record_names[FIXED_##name], #name);                              \
        assert_int_equal(fixed_records[FIXED_##name].calls, calls_made);                           \
        assert_true(fixed_records[FIXED_##name].largest > 0);                                      \
    } while (0)
    EXPECT(length_add, 1, length_add(one, one));
    EXPECT(length_subtract, 1, length_subtract(one, -one));
    EXPECT(length_along, 1, length_along(one, one, half));
    EXPECT(length_dot, 1, length_dot(one, one, one, half, half, half));
    EXPECT(length_scaled, 1, length_scaled(one, half));
    EXPECT(length_over, 1, length_over(one, slope_of(half)));
    EXPECT(length_root, 1, length_root(area));
    EXPECT(length_quotient, 1, length_quotient(area, one));
    EXPECT(area_product, 1, area_product(one, one));
    EXPECT(area_norm, 1, area_norm(one, one, one));
    EXPECT(area_add, 1, area_add(area, area));
    EXPECT(area_subtract, 1, area_subtract(area, -area));
    EXPECT(area_scaled, 1, area_scaled(area, half));
    EXPECT(unit_dot, 1, unit_dot(half, half, half, half, half, half));
    EXPECT(unit_product, 1, unit_product(half, half));
    EXPECT(unit_add, 1, unit_add(half, half));
    unit_normalise_wide(wide_sum(half, half), wide_sum(half, 0), wide_sum(half, 0), &u, &v, &w);
    EXPECT(unit_normalise_wide, 3, u);
    unit_normalise_lengths(one, one, one, &u, &v, &w, &length);
    EXPECT(unit_normalise_lengths, 1, u);
    EXPECT(unit_mirrored, 1, unit_mirrored(half, half, half));
    EXPECT(unit_refracted_cosine, 1, unit_refracted_cosine(REAL_UNIT(0.9), index, &u));
    EXPECT(unit_bent, 1, unit_bent(half, index, index, half));
    EXPECT(index_bend, 1, index_bend(index, half, -half));
    EXPECT(index_product, 1, index_product(index, index));
    EXPECT(index_scaled, 1, index_scaled(index, half));
    EXPECT(index_add, 1, index_add(index, index));
    EXPECT(index_subtract, 1, index_subtract(index, -index));
    EXPECT(energy_product, 1, energy_product(energy, energy));
    EXPECT(energy_add, 1, energy_add(energy, energy));
    EXPECT(energy_complement, 1, energy_complement(energy));
    EXPECT(energy_ratio, 1, energy_ratio(REAL_INDEX(1), index));
    EXPECT(energy_mean_square, 1, energy_mean_square(energy, energy));
    EXPECT(colour_add, 1, colour_add(colour, colour));
    EXPECT(colour_scaled, 1, colour_scaled(colour, energy));
    EXPECT(colour_lit, 1, colour_lit(colour, colour));
    EXPECT(colour_faded, 1, colour_faded(colour, one, 0));
    for (int i = 0; i < FIXED_OPERATION_COUNT; i++) {
        assert_true(fixed_records[i].calls > 0);
        assert_int_equal(fixed_records[i].saturations, 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_result_that_fits_leaves_its_magnitude_and_no_saturation, clear),
        cmocka_unit_test_setup(a_saturation_is_counted_with_what_it_would_have_been, clear),
        cmocka_unit_test_setup(saturated_areas_are_counted, clear),
        cmocka_unit_test_setup(every_operation_is_recorded_under_its_own_name, clear),
    };
    return cmocka_run_group_tests_name("records of checked", tests, NULL, NULL);
}
