/* SPDX-License-Identifier: MIT */
/* The measured cost of operations, and the machines of the predictions. */
#include "stats/cost_model.h"

#include <stddef.h>

/* Columns: add, test, product, dot, slope, over, root, quotient, normalise, refract, power,
 * transmit, cell. `make cost-operations` made the table. */
/* clang-format off */
const double cost_operations[COST_EVENTS][COST_KINDS] = {
    [COST_RAY] = {4.66, 8.98, 7.26, 0.14, 3.14, 1.33, 0.01, 0.00, 1.15, 0.00, 0.06, 0.00, 0.00},
    [COST_SHADOW_RAY] = {1.49, 9.90, 0.26, 0.00, 3.00, 2.75, 0.00, 0.00, 0.43, 0.00, 0.00, 0.00, 0.00},
    [COST_NODE] = {8.74, 14.29, 19.37, 2.26, 0.00, 0.00, 0.08, 1.43, 0.00, 1.16, 0.33, 0.00, 0.00},
    [COST_BOX] = {4.17, 6.11, 0.40, 0.05, 0.05, 4.24, 0.00, 0.01, 0.03, 0.00, 0.03, 0.00, 0.00},
    [COST_TURNED_BOX] = {4.41, 12.36, 0.28, 5.94, 2.99, 4.51, 0.00, 0.00, 0.03, 0.00, 0.03, 0.00, 0.00},
    [COST_BALL] = {6.33, 1.85, 3.27, 2.02, 0.03, 0.05, 0.99, 0.05, 0.10, 0.00, 0.01, 0.00, 0.00},
    [COST_PLANE] = {0.98, 3.31, 0.00, 2.00, 0.97, 0.98, 0.00, 0.00, 0.01, 0.00, 0.00, 0.00, 0.00},
    [COST_QUADRIC] = {5.57, 2.92, 5.07, 2.26, 0.14, 0.18, 0.10, 0.14, 0.11, 0.00, 0.01, 0.00, 0.00},
};

/* `make cost-instructions` printed the instructions. The overhead is what tests/cost/whole.sh
 * counted of fig3, 8 x 5 pixels, less the operations. It was counted in one arithmetic of each
 * target (m0, m3, i386: fx; m4f, i387: f32), for x86_64 in each. */
const struct cost_code cost_codes[] = {
    {"m0", "fx", {18.0, 5.6, 83.0, 165.5, 202.2, 61.4, 303.1, 313.9, 656.9, 500.2, 393.9, 215.5, 40.6}, 181},
    {"m0", "f32", {63.6, 38.5, 195.9, 514.9, 456.4, 119.5, 300.9, 456.6, 1538.6, 946.4, 1266.5, 3107.0, 561.9}, 181},
    {"m0", "f64", {125.2, 59.5, 433.9, 1176.5, 720.5, 295.0, 1886.9, 726.2, 4553.8, 3289.1, 3085.5, 9404.0, 855.5}, 181},
    {"m3", "fx", {7.0, 6.0, 19.0, 21.0, 33.6, 13.9, 76.0, 70.5, 138.9, 105.0, 82.9, 37.9, 7.0}, 381},
    {"m3", "f32", {51.8, 39.0, 88.0, 214.8, 212.9, 33.0, 274.9, 201.4, 733.5, 555.9, 380.0, 1198.4, 290.8}, 381},
    {"m3", "f64", {64.5, 45.0, 117.2, 289.1, 609.6, 50.0, 955.0, 546.9, 1975.0, 1343.2, 566.0, 4165.4, 706.1}, 381},
    {"m4f", "fx", {15.0, 6.0, 25.0, 28.0, 52.6, 15.1, 96.0, 89.9, 159.9, 120.5, 84.6, 37.8, 7.0}, 541},
    {"m4f", "f32", {2.0, 6.0, 7.0, 14.0, 8.0, 1.0, 7.0, 9.0, 23.0, 18.0, 40.0, 66.0, 19.0}, 541},
    {"m4f", "f64", {64.5, 45.0, 117.2, 289.1, 610.6, 50.0, 958.0, 548.9, 1977.0, 1345.2, 578.0, 4178.9, 709.1}, 541},
    {"i386", "fx", {13.0, 3.0, 43.0, 46.0, 70.5, 24.8, 131.4, 111.1, 251.2, 176.1, 97.9, 71.6, 9.4}, 517},
    {"i387", "f32", {3.0, 5.0, 6.0, 11.0, 16.0, 3.0, 11.0, 14.0, 53.0, 26.0, 88.5, 114.9, 30.0}, 856},
    {"i387", "f64", {5.0, 5.0, 8.0, 13.0, 17.0, 5.0, 11.0, 15.0, 53.0, 26.0, 88.5, 177.6, 31.0}, 856},
    {"x86_64", "fx", {12.0, 3.0, 23.0, 30.0, 64.0, 17.0, 96.4, 87.4, 163.8, 122.5, 71.2, 37.9, 9.0}, 459},
    {"x86_64", "f32", {1.0, 3.0, 4.0, 11.0, 7.0, 1.0, 6.0, 7.0, 32.0, 19.0, 39.0, 63.5, 13.0}, 597},
    {"x86_64", "f64", {1.0, 3.0, 4.0, 11.0, 7.0, 1.0, 6.0, 7.0, 32.0, 20.0, 39.0, 98.9, 13.0}, 621},
    {NULL, NULL, {0}, 0}};
/* clang-format on */

/* Clocks an instruction: "assumed" is a mean over the manuals' timings of the instructions that
 * compilers make, as no machine was at hand. "scaled" is what 16-bit code takes for one instruction
 * of the 386's. */
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
     "88-91, FSQRT 122-129, between integer instructions of 4.5)",
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
     "SMULL 1, load 2, VADD and VMUL 1, VDIV and VSQRT 14); port: a store of 2",
     2, 1.3, 1.5, 1.3, "m4f", "m4f"},
    {"x86_64", "x86-64 at 3 GHz, one core", 3000,
     "assumed: 0.5, two instructions a clock; the ports of such a machine are a program", 0, 0.5,
     0.5, 0.5, "x86_64", "x86_64"},
    {NULL, NULL, 0, NULL, 0, 0, 0, 0, NULL, NULL}};
