/* SPDX-License-Identifier: MIT */
/* Path signatures: for each pixel a hash of the decisions in its tree of rays. */
#ifndef SUPERFRAME_SIGNATURES_H
#define SUPERFRAME_SIGNATURES_H

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>

#include "render/arithmetic.h"

/* Two arithmetics that come to the same primitives and faces in the same order have the same
 * signature. Distances and weights do not count. The file: a line "superframe signatures 1 WIDTH
 * HEIGHT", then the signatures row by row, 64 bits each, least byte first. A pixel that was not
 * rendered has 0, and no other has. */
struct signatures {
    unsigned width, height;
    uint64_t *of_pixel; /* width * height */
};

/* What is to be signed: rows first_row .. last_row - 1. */
struct signature_job {
    const struct arithmetic *arithmetic;
    const struct compiled_scene *scene;
    unsigned first_row, last_row, jobs;
    const volatile sig_atomic_t *stop; /* not zero: the rest stays 0; NULL: goes to the end */
};

/* Follows each pixel's tree again and signs the pixel. Returns false with *error filled where the
 * arithmetic can't hold the scene, or memory is out. */
bool signatures_make(const struct signature_job *job, struct signatures *signatures,
                     struct scene_error *error);

/* Writes signatures to a file; false where writing failed, and errno says why. */
bool signatures_write(const struct signatures *signatures, FILE *file);

/* Reads signatures from a file. Returns NULL, or what is wrong with the file. */
const char *signatures_read(FILE *file, struct signatures *signatures);

/* Tells whether a file that was just opened begins as signatures do. The first byte decides, and is
 * left to be read: the file may be a pipe. */
bool signatures_begin(FILE *file);

/* Frees signatures; harmless where the structure is all zero. */
void signatures_free(struct signatures *signatures);

/* What signatures tell of two pictures. */
struct signature_comparison {
    uint64_t pixels, flips;     /* flips: pixels whose signatures differ */
    unsigned drift, flip_error; /* the largest error where they agree, where they differ; LSB */
    uint64_t drifted;           /* pixels that agree and are still more than 1 LSB apart */
};

/* Compares signatures of one size, and with them the pictures a and b. A picture's rows have
 * `width` dots of R, G, B bytes; a pixel is `dots` dots wide and high. a and b NULL: signatures
 * alone. */
void signatures_compare(const struct signatures *one, const struct signatures *other,
                        const uint8_t *a, const uint8_t *b, unsigned width, unsigned dots,
                        struct signature_comparison *comparison);

#endif
