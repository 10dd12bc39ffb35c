/* SPDX-License-Identifier: MIT */
/* Square roots for targets without a mathematical library: bit by bit, as small libraries have. */
#include <stdint.h>

/* Weak: a target with the instruction brings its own (targets.sh). */
__attribute__((weak)) float sqrtf(float x);
__attribute__((weak)) double sqrt(double x);

/* Of positive normal numbers: the exponent is halved, the significand's root found by trial. */
float sqrtf(float x) {
    union {
        float value;
        uint32_t bits;
    } word = {x};
    uint32_t bits = word.bits;
    int32_t exponent = (int32_t)(bits >> 23) - 127;
    uint32_t rest = (bits & 0x7FFFFF) | 0x800000;
    rest <<= 1 + (exponent & 1);
    uint32_t root = 0, tried = 0;
    for (uint32_t bit = UINT32_C(1) << 24; bit != 0; bit >>= 1) {
        uint32_t trial = tried + bit;
        if (trial <= rest) {
            tried = trial + bit;
            rest -= trial;
            root += bit;
        }
        rest <<= 1;
    }
    root += root & 1;
    word.bits = (root >> 1) + ((uint32_t)((exponent >> 1) + 126) << 23);
    return word.value;
}

double sqrt(double x) {
    union {
        double value;
        uint64_t bits;
    } word = {x};
    uint64_t bits = word.bits;
    int32_t exponent = (int32_t)(bits >> 52) - 1023;
    uint64_t rest = (bits & UINT64_C(0xFFFFFFFFFFFFF)) | UINT64_C(0x10000000000000);
    rest <<= 1 + (exponent & 1);
    uint64_t root = 0, tried = 0;
    for (uint64_t bit = UINT64_C(1) << 53; bit != 0; bit >>= 1) {
        uint64_t trial = tried + bit;
        if (trial <= rest) {
            tried = trial + bit;
            rest -= trial;
            root += bit;
        }
        rest <<= 1;
    }
    root += root & 1;
    word.bits = (root >> 1) + ((uint64_t)((exponent >> 1) + 1022) << 52);
    return word.value;
}
