/* SPDX-License-Identifier: MIT */
/* Proves the integer roots and reciprocals of fixed point by trying every argument that matters. */

/* Usage: root_exhaustive [THREADS]. Exit status 0: proved; 1: an argument with a wrong result,
 * which is printed. It takes half a minute on two threads.
 *
 *   the 32-bit root     floor(sqrt(x 2^32)) for every 32-bit x: root^2 <= x 2^32 < (root + 1)^2;
 *   the 64-bit root     at both ends, r^2 and r^2 + 2r, of the arguments of every root r of a
 *                       normalised argument (2^62 and above): where the floor changes;
 *   the reciprocal      of every normalised divisor m (2^31 and above): |2^62 - m r| <= m / 2. */

#include "real.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_THREADS = 64 };

struct share {
    pthread_t thread;
    uint64_t first; /* of the 32-bit arguments 0 ... 2^32 - 1 */
    uint64_t past;
    uint64_t wrong;
    uint64_t example; /* the first wrong argument */
};

static void note(struct share *share, bool right, uint64_t argument) {
    if (!right) {
        if (share->wrong == 0) {
            share->example = argument;
        }
        share->wrong++;
    }
}

/* (root + 1)^2 is root^2 + 2 root + 1, formed such that nothing wraps. */
static bool is_floor_of_root(uint64_t root, uint64_t x) {
    return root * root <= x && x - root * root <= 2 * root;
}

static void *try_share(void *context) {
    struct share *share = context;
    for (uint64_t i = share->first; i < share->past; i++) {
        uint64_t x = i << 32;
        note(share, is_floor_of_root(fixed_root64(x), x), x);
        if (i >= UINT64_C(1) << 31) {
            uint64_t rest;
            bool right = fixed_root_of_normal(i * i, &rest) == i && rest == 0;
            note(share, right, i * i);
            right = fixed_root_of_normal(i * i + 2 * i, &rest) == i && rest == 2 * i;
            note(share, right, i * i + 2 * i);
            uint64_t product = fixed_reciprocal((uint32_t)i) * i;
            uint64_t one = UINT64_C(1) << 62;
            note(share, 2 * (product > one ? product - one : one - product) <= i, i);
        }
    }
    return NULL;
}

int main(int argc, char **argv) {
    static struct share shares[MOST_THREADS];
    long threads = argc > 1 ? strtol(argv[1], NULL, 10) : 2;
    if (threads < 1 || threads > MOST_THREADS) {
        fprintf(stderr, "usage: %s [THREADS], 1 to %d\n", argv[0], MOST_THREADS);
        return 2;
    }
    for (long i = 0; i < threads; i++) {
        uint64_t all = UINT64_C(1) << 32;
        shares[i].first = all / (uint64_t)threads * (uint64_t)i;
        shares[i].past = i + 1 == threads ? all : all / (uint64_t)threads * (uint64_t)(i + 1);
        if (pthread_create(&shares[i].thread, NULL, try_share, &shares[i]) != 0) {
            fprintf(stderr, "%s: no thread could be started\n", argv[0]);
            return 1;
        }
    }
    uint64_t wrong = 0;
    for (long i = 0; i < threads; i++) {
        pthread_join(shares[i].thread, NULL);
        if (shares[i].wrong > 0) {
            printf("wrong for the argument %llX\n", (unsigned long long)shares[i].example);
        }
        wrong += shares[i].wrong;
    }
    printf("4294967296 32-bit roots, 4294967296 ends of 64-bit roots and 2147483648 reciprocals "
           "tried: %llu wrong\n",
           (unsigned long long)wrong);
    return wrong == 0 ? 0 : 1;
}
