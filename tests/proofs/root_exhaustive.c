/* SPDX-License-Identifier: MIT */
/* Proves the integer roots and reciprocals of fixed point by trying every argument that matters. */

/* Usage: root_exhaustive [THREADS [STEP]]; STEP: every STEP-th argument only, which is a sample and
 * no proof. Exit status 0: none is wrong; 1: an argument with a wrong result, which is printed. All
 * of them take a minute on one thread; `make prove` calls it. Tried are:
 *
 * The 64-bit root, floor(sqrt(m)) for normalised arguments, 2^62 <= m: at both ends, r^2 and r^2 +
 * 2r, of the arguments of every root r, and at both ends of the arguments of every upper half h.
 * That is every m: between two such ends the table and the first steps, which look at h alone, are
 * the same; what Newton's step makes of m then never decreases, and must lie within 1 of r.
 *
 * Its shifted form, floor(sqrt(x 2^32)), for every 32-bit x.
 *
 * The reciprocal of every normalised divisor m (2^31 and above): |2^62 - m r| <= m / 2. */

#include "real.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_THREADS = 64 };

struct share {
    pthread_t thread;
    uint64_t first; /* of the 32-bit arguments 0 ... 2^32 - 1 */
    uint64_t past;
    uint64_t step;
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

static void try_normal_root(struct share *share, uint64_t m) {
    uint64_t rest;
    uint64_t root = fixed_root_of_normal(m, &rest);
    note(share, is_floor_of_root(root, m) && rest == m - root * root, m);
}

static void *try_share(void *context) {
    struct share *share = context;
    for (uint64_t i = share->first; i < share->past; i += share->step) {
        uint64_t x = i << 32;
        note(share, is_floor_of_root(fixed_root64(x), x), x);
        if (i >= UINT64_C(1) << 30) {
            try_normal_root(share, x);
            try_normal_root(share, x + UINT32_MAX);
        }
        if (i >= UINT64_C(1) << 31) {
            try_normal_root(share, i * i);
            try_normal_root(share, i * i + 2 * i);
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
    long step = argc > 2 ? strtol(argv[2], NULL, 10) : 1;
    if (threads < 1 || threads > MOST_THREADS || step < 1) {
        fprintf(stderr, "usage: %s [THREADS [STEP]], 1 to %d, from 1\n", argv[0], MOST_THREADS);
        return 2;
    }
    for (long i = 0; i < threads; i++) {
        uint64_t all = UINT64_C(1) << 32;
        shares[i].step = (uint64_t)step;
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
    printf("roots and reciprocals, %s: %llu wrong\n",
           step == 1 ? "every argument" : "a sample of the arguments", (unsigned long long)wrong);
    return wrong == 0 ? 0 : 1;
}
