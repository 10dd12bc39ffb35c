/* SPDX-License-Identifier: MIT */
/* What each fuzzer is to libFuzzer, and the bytes that it is made of. A finding is a failed
 * assert(), or whatever a sanitizer finds. */
#ifndef SUPERFRAME_TESTS_FUZZ_H
#define SUPERFRAME_TESTS_FUZZ_H

#undef NDEBUG
#include <assert.h>
#include <stddef.h>
#include <stdint.h>

/* Tries one input; always returns 0. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

/* What is left of an input that is taken apart from its front. */
struct input {
    const uint8_t *bytes;
    size_t count;
};

/* Takes one byte; 0 once the input is used up. */
static inline unsigned take_byte(struct input *input) {
    if (input->count == 0) {
        return 0;
    }
    input->count--;
    return *input->bytes++;
}

/* Takes a number of two bytes, the lower one first. */
static inline unsigned take_number(struct input *input) {
    unsigned low = take_byte(input);
    return low | take_byte(input) << 8;
}

/* Takes as many bytes as are wanted and there; they lie at *bytes. */
static inline size_t take_bytes(struct input *input, size_t wanted, const uint8_t **bytes) {
    size_t count = wanted < input->count ? wanted : input->count;
    *bytes = input->bytes;
    input->bytes += count;
    input->count -= count;
    return count;
}

#endif
