/* SPDX-License-Identifier: MIT */
/* Relations: the table. Coordinates that a relation changes are rounded anew: f64 alone holds such
 * pictures to the last level. */
#include <stdarg.h>
#include <stdio.h>

#include "relation.h"

const struct relation relations[] = {
    {"membership", IN_ALL, MAP_SAME, NULL, NULL, NULL, false, false, 1},
    {"streams", IN_ALL, MAP_SAME, check_streams, NULL, NULL, false, false, 1},
    {"lists", IN_ALL, MAP_SAME, check_lists, NULL, NULL, false, false, 1},
    {"jobs", IN_ALL, MAP_SAME, check_jobs, NULL, NULL, false, false, 4},
    {"proved", IN_ALL, MAP_SAME, check_proved, NULL, NULL, false, false, 2},
    {"f128", IN_F64, MAP_SAME, NULL, NULL, NULL, false, true, 1},
    {"mirror", IN_F64, MAP_MIRRORED, NULL, NULL, rewrite_mirror, false, false, 1},
    {"move", IN_F64, MAP_SAME, NULL, NULL, rewrite_move, false, false, 1},
    {"scale", IN_F64, MAP_SAME, NULL, NULL, rewrite_scale, false, false, 1},
    {"turn", IN_F64, MAP_SAME, NULL, prepare_turn, rewrite_turn, false, false, 1},
    {"roll", IN_F64, MAP_ROLLED, NULL, NULL, rewrite_roll, false, false, 1},
    {"object-order", IN_ALL, MAP_SAME, NULL, NULL, rewrite_object_order, false, false, 1},
    {"child-order", IN_ALL, MAP_SAME, NULL, NULL, rewrite_child_order, false, false, 1},
    {"de-morgan", IN_F64, MAP_SAME, NULL, NULL, rewrite_de_morgan, false, false, 1},
    {"split", IN_F64, MAP_SAME, NULL, NULL, rewrite_split, false, false, 1},
    {"halves", IN_F64, MAP_SAME, NULL, NULL, rewrite_halves, false, false, 1},
    {"cutter", IN_F64, MAP_SAME, NULL, prepare_cutter, rewrite_cutter, false, false, 1},
    {"alone", IN_ALL, MAP_SAME, NULL, NULL, rewrite_alone, false, false, 1},
    {"beyond", IN_ALL, MAP_SAME, NULL, NULL, rewrite_beyond, false, false, 1},
    {"empty", IN_ALL, MAP_SAME, NULL, NULL, rewrite_empty, false, false, 1},
    {"ghost", IN_ALL, MAP_SAME, NULL, NULL, rewrite_ghost, true, false, 1},
    {"as-part", IN_ALL, MAP_SAME, NULL, NULL, rewrite_as_part, false, false, 1},
    {"written-out", IN_ALL, MAP_SAME, NULL, NULL, rewrite_written_out, false, false, 1},
    {"light", IN_ALL, MAP_SAME, NULL, NULL, rewrite_light, false, false, 1},
    {"ends", IN_F64, MAP_SAME, NULL, NULL, rewrite_ends, false, false, 1},
    {"leaves", IN_F64, MAP_SAME, NULL, NULL, rewrite_leaves, false, false, 1},
    {"placements", IN_F64, MAP_SAME, NULL, NULL, rewrite_placements, false, false, 1},
    {"forms", IN_F64, MAP_SAME, NULL, NULL, rewrite_forms, false, false, 1},
};

const int relation_count = sizeof relations / sizeof relations[0];

const struct arithmetic *relation_arithmetic(int number) {
    static const struct arithmetic *const arithmetics[RELATION_ARITHMETICS] = {
        &arithmetic_f64, &arithmetic_f32, &arithmetic_fx};
    return arithmetics[number];
}

void result_fail(struct trial_result *result, enum fault fault, const char *format, ...) {
    va_list arguments;
    if (result->fault != FAULT_NONE) {
        return;
    }
    result->fault = fault;
    va_start(arguments, format);
    (void)vsnprintf(result->text, sizeof result->text, format, arguments);
    va_end(arguments);
}
