/* SPDX-License-Identifier: MIT */
/* The stream engines of an x86-64 host: the CPU is asked what it has. */
#include "render/engines.h"

extern const struct stream_engine stream_f32_plain, stream_f32_avx2, stream_f32_avx512;
extern const struct stream_engine stream_f64_plain, stream_f64_avx2, stream_f64_avx512;

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

extern const struct stream_engine stream_fx_plain, stream_fx_avx2, stream_fx_avx512;

const struct engine_choice engine_choices[] = {
    {"f32", &stream_f32_plain, NULL},        {"f32", &stream_f32_avx2, has_avx2},
    {"f32", &stream_f32_avx512, has_avx512}, {"f64", &stream_f64_plain, NULL},
    {"f64", &stream_f64_avx2, has_avx2},     {"f64", &stream_f64_avx512, has_avx512},
    {"fx", &stream_fx_plain, NULL},          {"fx", &stream_fx_avx2, has_avx2},
    {"fx", &stream_fx_avx512, has_avx512},   {NULL, NULL, NULL}};
