/* SPDX-License-Identifier: MIT */
/* One operation of an arithmetic, many times: a program whose instructions are counted. */
#include "real.h"

#include "real/lab/wrap_kinds.h"

/* Built by tests/cost/instructions.sh with KIND, one of enum wrap_kind or WRAP_KINDS for none, and
 * ROUNDS; no library but the compiler's own, and no system but the call that ends it. */

/* The number of rounds picks the operands by its low bits: on a Cortex-M0 a remainder is a division
 * by a library. */
enum { ARGUMENTS = 8, MORE = 2 };

/* Of the sizes that a rendering meets. */
static const real_length lengths[ARGUMENTS + MORE] = {
    REAL_LENGTH(1.25),    REAL_LENGTH(-3.7),   REAL_LENGTH(250.125), REAL_LENGTH(0.03),
    REAL_LENGTH(-77.31),  REAL_LENGTH(12.875), REAL_LENGTH(-0.5),    REAL_LENGTH(401.9),
    REAL_LENGTH(33.0625), REAL_LENGTH(-9.4)};
static const real_unit units[ARGUMENTS + MORE] = {
    REAL_UNIT(0.25), REAL_UNIT(-0.71), REAL_UNIT(0.93), REAL_UNIT(0.013), REAL_UNIT(-0.4),
    REAL_UNIT(0.66), REAL_UNIT(-0.98), REAL_UNIT(0.1),  REAL_UNIT(0.37),  REAL_UNIT(-0.22)};
static const real_area areas[ARGUMENTS] = {REAL_AREA(2.5),  REAL_AREA(77.1),   REAL_AREA(60000.5),
                                           REAL_AREA(0.01), REAL_AREA(1234.5), REAL_AREA(9.75),
                                           REAL_AREA(0.3),  REAL_AREA(3000.25)};

volatile real_length length_result;
volatile real_unit unit_result;
volatile int truth_result;
real_slope slope_result;
volatile real_energy share = REAL_ENERGY(0.97);
volatile real_extinction extinction = REAL_EXTINCTION(0.02);
volatile real_index eta = REAL_INDEX(0.6667);

void run(void);

void run(void) {
    real_slope slope = slope_of(units[3]);
    for (unsigned i = 0; i < ROUNDS; i++) {
        const real_length *p = &lengths[i % ARGUMENTS];
        const real_unit *u = &units[i * 5 % ARGUMENTS];
        real_unit d[3];
        real_length length;
        switch ((int)KIND) {
        case WRAP_ADD:
            length_result = length_add(p[0], p[1]);
            break;
        case WRAP_TEST:
            truth_result = length_less(p[0], p[1]);
            break;
        case WRAP_PRODUCT:
            length_result = length_along(p[0], p[1], u[0]);
            break;
        case WRAP_DOT:
            length_result = length_dot(p[0], p[1], p[2], u[0], u[1], u[2]);
            break;
        case WRAP_SLOPE:
            slope_result = slope_of(u[0]);
            __asm__ volatile("" : : : "memory");
            break;
        case WRAP_OVER:
            length_result = length_over(p[0], slope);
            break;
        case WRAP_ROOT:
            length_result = length_root(areas[i % ARGUMENTS]);
            break;
        case WRAP_QUOTIENT:
            length_result = length_quotient(areas[i % ARGUMENTS], p[0]);
            break;
        case WRAP_NORMALISE:
            unit_normalise_lengths(p[0], p[1], p[2], &d[0], &d[1], &d[2], &length);
            unit_result = d[0];
            unit_result = d[1];
            unit_result = d[2];
            break;
        case WRAP_REFRACT:
            d[0] = units[0];
            truth_result = unit_refracted_cosine(u[0], eta, &d[0]);
            unit_result = d[0];
            break;
        case WRAP_POWER:
            unit_result = energy_power(share, (uint16_t)(60 + i % 8));
            break;
        case WRAP_TRANSMIT:
            unit_result = energy_transmitted(extinction, p[0]);
            break;
        case WRAP_CELL:
            truth_result = length_cell_is_odd(p[0], lengths[0]);
            break;
        default:
            length_result = p[0]; /* what the loop itself takes */
            break;
        }
    }
}
