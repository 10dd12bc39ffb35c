/* SPDX-License-Identifier: MIT */
/* Tries the power of two that absorption is made of at every one of its 2^32 arguments. */

/* Usage: exponential_exhaustive [THREADS [STEP]]; STEP, a power of two to 2^16: every STEP-th
 * argument only, which is a sample and no proof. Prints the largest error; exit status 0: it is
 * within the 1.9 that fixed_exp.h states, 1: it is not.
 *
 * The reference is 2^-f in 64 bits of fraction. It starts from libquadmath's value at every 2^16th
 * argument and is carried from one argument to the next by one product, each of which loses less
 * than 2^-62: after 2^16 of them it is within 2^-45, a thousandth of what is measured. */

#include "real.h"

#include <pthread.h>
#include <quadmath.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_THREADS = 64 };

#define RUN       (UINT64_C(1) << 16)
#define ARGUMENTS (UINT64_C(1) << 32)

struct share {
    pthread_t thread;
    uint64_t first;
    uint64_t past;
    uint64_t step;
    int64_t largest; /* in 2^-64 */
    uint64_t argument;
};

/* a b / 2^64, less than 3 too small. */
static uint64_t product_of_fractions(uint64_t a, uint64_t b) {
    uint64_t a_high = a >> 32;
    uint64_t b_high = b >> 32;
    uint64_t a_low = a & UINT32_MAX;
    uint64_t b_low = b & UINT32_MAX;
    return a_high * b_high + ((a_high * b_low) >> 32) + ((a_low * b_high) >> 32);
}

/* 2^-(f / 2^32) in 64 bits of fraction; f > 0. */
static uint64_t power_of_half(uint64_t f) {
    return (uint64_t)(exp2q(-(__float128)f * 0x1p-32) * 0x1p64);
}

static void *try_share(void *context) {
    struct share *share = context;
    uint64_t factor = power_of_half(share->step);
    for (uint64_t run = share->first; run < share->past; run += RUN) {
        uint64_t f = run > 0 ? run : share->step; /* at 0 it is 1, which is no fraction */
        uint64_t exact = power_of_half(f);
        for (; f < run + RUN; f += share->step) {
            /* 2^-f is at least 1/2: what is near 2^32 in 32 bits of fraction wraps in 64. */
            uint64_t found = fixed_power_of_half((uint32_t)f) << 32;
            int64_t error = (int64_t)(found - exact);
            error = error < 0 ? -error : error;
            if (error > share->largest) {
                share->largest = error;
                share->argument = f;
            }
            exact = product_of_fractions(exact, factor);
        }
    }
    return NULL;
}

int main(int argc, char **argv) {
    static struct share shares[MOST_THREADS];
    long threads = argc > 1 ? strtol(argv[1], NULL, 10) : 2;
    long step = argc > 2 ? strtol(argv[2], NULL, 10) : 1;
    if (threads < 1 || threads > MOST_THREADS || step < 1 || step > 65536 || 65536 % step != 0) {
        fprintf(stderr, "usage: %s [THREADS [STEP]], 1 to %d, a power of two to 65536\n", argv[0],
                MOST_THREADS);
        return 2;
    }
    uint64_t each = ARGUMENTS / RUN / (uint64_t)threads * RUN;
    for (long i = 0; i < threads; i++) {
        shares[i].step = (uint64_t)step;
        shares[i].first = each * (uint64_t)i;
        shares[i].past = i + 1 == threads ? ARGUMENTS : each * (uint64_t)(i + 1);
        if (pthread_create(&shares[i].thread, NULL, try_share, &shares[i]) != 0) {
            fprintf(stderr, "%s: no thread could be started\n", argv[0]);
            return 1;
        }
    }
    struct share worst = {0};
    for (long i = 0; i < threads; i++) {
        pthread_join(shares[i].thread, NULL);
        worst = shares[i].largest > worst.largest ? shares[i] : worst;
    }
    double largest = (double)worst.largest * 0x1p-32;
    bool right = largest <= 1.9 && fixed_power_of_half(0) == ARGUMENTS;
    printf("powers of a half, %s: off by %.4f of 2^-32 at most (at %08llX); 1.9 is stated%s\n",
           step == 1 ? "every argument" : "a sample of the arguments", largest,
           (unsigned long long)worst.argument, right ? "" : ", WRONG");
    return right ? 0 : 1;
}
