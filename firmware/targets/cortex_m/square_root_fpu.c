/* SPDX-License-Identifier: MIT */
/* sqrtf() of a Cortex-M with a floating-point unit: its one instruction. */

float sqrtf(float x);

float sqrtf(float x) {
    float root;
    __asm__("vsqrt.f32 %0, %1" : "=t"(root) : "t"(x));
    return root;
}
