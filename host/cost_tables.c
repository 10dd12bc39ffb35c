/* SPDX-License-Identifier: MIT */
/* What operations cost, as it was measured, and the machines of the predictions. */
#include "cost_model.h"

#include <stddef.h>

/* Columns: add, test, product, dot, slope, over, root, quotient, normalise, refract, power,
 * transmit, cell. Made by `make cost-operations`. */
/* clang-format off */
const double cost_operations[COST_EVENTS][COST_KINDS] = {
    [COST_RAY] = {3.32, 7.04, 7.02, 0.06, 3.02, 0.23, 0.00, 0.00, 1.13, 0.00, 0.06, 0.00, 0.00},
    [COST_SHADOW_RAY] = {0.00, 4.19, 0.00, 0.00, 2.95, 0.02, 0.00, 0.00, 0.49, 0.00, 0.00, 0.00, 0.00},
    [COST_NODE] = {13.72, 22.62, 19.21, 3.53, 0.00, 0.00, 0.22, 1.64, 0.00, 1.07, 0.33, 0.00, 0.00},
    [COST_BOX] = {6.14, 8.27, 0.41, 0.01, 0.00, 6.01, 0.00, 0.04, 0.04, 0.01, 0.01, 0.00, 0.00},
    [COST_TURNED_BOX] = {9.06, 14.27, 0.33, 6.02, 3.00, 5.95, 0.00, 0.02, 0.02, 0.01, 0.02, 0.00, 0.00},
    [COST_BALL] = {6.12, 2.20, 3.52, 2.03, 0.00, 0.00, 1.00, 0.01, 0.05, 0.01, 0.03, 0.00, 0.00},
    [COST_PLANE] = {1.02, 3.35, 0.05, 2.00, 0.99, 0.99, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00, 0.00},
    [COST_QUADRIC] = {10.19, 3.25, 16.50, 9.03, 0.02, 0.02, 0.02, 0.04, 0.04, 0.01, 0.03, 0.00, 0.00},
};

/* The instructions by `make cost-instructions`; the overhead is what tests/cost/whole.sh counted of
 * fig3, 8 x 5 pixels, less the operations, in one arithmetic of each target (m0, m3, i386: fx;
 * m4f, i387: f32); none was left on m0. Of x86_64: what callgrind counts
 * of 24 x 15 pixels less 8 x 5. */
const struct cost_code cost_codes[] = {
    {"m0", "fx", {18.0, 5.7, 137.9, 218.4, 243.1, 60.1, 247.1, 371.4, 675.8, 504.1, 384.9, 251.6, 38.9}, 0},
    {"m0", "f32", {64.8, 38.4, 260.4, 578.0, 479.1, 120.5, 266.8, 458.5, 1542.5, 964.9, 1232.5, 2975.0, 564.6}, 0},
    {"m0", "f64", {127.0, 59.4, 499.7, 1244.2, 737.6, 297.0, 1852.8, 737.9, 4561.1, 3304.1, 3051.4, 9083.0, 853.2}, 0},
    {"m3", "fx", {15.0, 6.0, 28.0, 31.0, 58.8, 15.6, 97.0, 108.7, 167.0, 122.5, 79.0, 41.4, 7.0}, 633},
    {"m3", "f32", {52.0, 39.0, 91.3, 221.0, 209.7, 34.0, 271.9, 221.5, 733.6, 555.1, 377.0, 1150.6, 288.6}, 633},
    {"m3", "f64", {65.3, 45.0, 120.6, 298.1, 595.8, 52.5, 952.0, 650.5, 1975.9, 1343.0, 563.0, 4040.8, 695.4}, 633},
    {"m4f", "fx", {15.0, 6.0, 28.0, 31.0, 58.8, 15.2, 97.0, 108.7, 167.9, 122.5, 83.0, 41.4, 7.0}, 541},
    {"m4f", "f32", {2.0, 6.0, 10.0, 17.0, 8.0, 1.0, 4.0, 10.8, 24.0, 18.0, 37.0, 63.1, 15.0}, 541},
    {"m4f", "f64", {65.3, 45.0, 119.6, 298.1, 595.8, 52.5, 955.0, 650.7, 1977.9, 1345.0, 575.0, 4057.2, 698.4}, 541},
    {"i386", "fx", {13.0, 3.0, 45.0, 47.0, 78.6, 25.9, 130.4, 145.4, 257.2, 174.1, 98.0, 77.9, 9.3}, 934},
    {"i387", "f32", {3.0, 5.0, 8.0, 13.0, 14.0, 3.0, 10.0, 16.6, 53.0, 27.0, 87.5, 109.0, 30.0}, 874},
    {"i387", "f64", {5.0, 5.0, 10.0, 15.0, 21.0, 5.0, 10.0, 23.4, 53.0, 27.0, 87.5, 168.8, 31.0}, 874},
    {"x86_64", "fx", {8.0, 3.0, 22.0, 31.0, 60.4, 10.5, 84.4, 93.3, 152.0, 117.5, 71.5, 40.4, 9.0}, 497},
    {"x86_64", "f32", {1.0, 3.0, 10.0, 18.0, 7.0, 1.0, 0.0, 8.8, 32.0, 19.0, 33.0, 60.1, 13.0}, 574},
    {"x86_64", "f64", {1.0, 3.0, 10.0, 18.0, 7.0, 1.0, 0.0, 8.8, 32.0, 20.0, 33.0, 94.6, 13.0}, 608},
    {NULL, NULL, {0}, 0}};
/* clang-format on */

/* Clocks an instruction: "assumed" is a mean over the manuals' timings of the instructions that
 * compilers make, for no machine was at hand; "scaled" is what 16-bit code takes for one
 * instruction of the 386's. */
const struct cost_target cost_targets[] = {
    {"8086", "PC-9801, 8086 at 5 MHz", 5,
     "scaled: 2.5 instructions of 12 clocks, and four MUL of 118-133 for one product in 12 "
     "instructions (8086 Family User's Manual, 1979, Table 2-21); port: 8 clocks (same)",
     8, 72, 0, 0, "i386", "i387"},
    {"v30", "PC-9801VM2, V30 at 10 MHz", 10,
     "scaled: 2.5 instructions of 5 clocks, and four MULU of 29-30 (NEC uPD70116 data sheet); "
     "port: 8 clocks",
     8, 22, 0, 0, "i386", "i387"},
    {"286", "PC-9801VX2, 80286 at 8 MHz", 8,
     "scaled: 2.5 instructions of 4 clocks, and four MUL of 21 (iAPX 286 Programmer's Reference "
     "Manual, appendix B); port: 3 clocks",
     3, 17, 0, 0, "i386", "i387"},
    {"386", "PC-9801RA2, 80386 at 16 MHz", 16,
     "assumed: 4.5 (Intel 80386 Programmer's Reference Manual, chapter 17: register 2, load 4, "
     "store 2, IMUL 9-38, taken jump 7 and more); port: 11 clocks",
     11, 4.5, 0, 0, "i386", "i387"},
    {"387", "the same with an 80387 at 16 MHz", 16,
     "assumed: 17 for x87 code (Intel 387 data sheet: FLD 14-25, FADD 23-34, FMUL 29-57, FDIV "
     "88-91, "
     "FSQRT 122-129, between integer instructions of 4.5)",
     11, 4.5, 17, 17, "i386", "i387"},
    {"m0", "Cortex-M0 at 48 MHz", 48,
     "assumed: 1.5 (Cortex-M0 Technical Reference Manual, Table 3-1: ALU 1, load and store 2, "
     "taken branch 3, MULS 1); port: a store of 2",
     2, 1.5, 1.5, 1.5, "m0", "m0"},
    {"m3", "Cortex-M3 at 72 MHz", 72,
     "assumed: 1.4 (Cortex-M3 Technical Reference Manual, Table 18-1: ALU 1, load 2, SMULL 3-5, "
     "UDIV 2-12, taken branch 2-4); port: a store of 2",
     2, 1.4, 1.4, 1.4, "m3", "m3"},
    {"m4f", "Cortex-M4F at 168 MHz", 168,
     "assumed: 1.3; f32 1.5 (Cortex-M4 Technical Reference Manual, Tables 3-1 and 7-1: ALU 1, "
     "SMULL "
     "1, load 2, VADD and VMUL 1, VDIV and VSQRT 14); port: a store of 2",
     2, 1.3, 1.5, 1.3, "m4f", "m4f"},
    {"x86_64", "x86-64 at 3 GHz, one core", 3000,
     "assumed: 0.5, two instructions a clock; the ports of such a machine are a program", 0, 0.5,
     0.5, 0.5, "x86_64", "x86_64"},
    {NULL, NULL, 0, NULL, 0, 0, 0, 0, NULL, NULL}};
