/* SPDX-License-Identifier: MIT */
/* The sets of instructions that an x86-64 CPU may have. */
#include "render/engine.h"

/* Tells whether this CPU has what gcc and clang make use of by -march=x86-64-v3. */
static bool has_avx2(void) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}

/* Tells whether this CPU has what gcc and clang make use of by -march=x86-64-v4. */
static bool has_avx512(void) {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

extern const struct instruction_set instruction_set_avx2, instruction_set_avx512;

const struct instruction_set instruction_set_avx2 = {"avx2", has_avx2};
const struct instruction_set instruction_set_avx512 = {"avx512", has_avx512};
