/* SPDX-License-Identifier: MIT */
/* Path signatures: for each pixel a hash of the decisions in its tree of rays. */
#include "render/signatures.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"

enum { SIDE_MOST = 16384, HEAD_SIZE = 64, BYTES = 8 };

static const char magic[] = "superframe signatures 1 ";

/* ---- Making --------------------------------------------------------------------------------- */

/* The number that FNV-1a begins with. */
static const uint64_t no_hash = UINT64_C(0xCBF29CE484222325);

/* Adds the bytes of one number, the least one first, to an FNV-1a hash. */
static void hash_number(uint64_t *hash, uint32_t number) {
    for (int i = 0; i < 4; i++) {
        *hash = (*hash ^ (number & 0xFF)) * UINT64_C(0x100000001B3);
        number >>= 8;
    }
}

static void sign_node(void *context, const struct observed_node *node) {
    uint64_t *hash = context;
    if (node->number == 1) {
        *hash = no_hash; /* the pixel begins, or begins again */
    }
    hash_number(hash, node->parent);
    hash_number(hash, (uint32_t)node->kind << 8 | node->channel);
    hash_number(hash, (uint32_t)node->primitive << 16 | (uint32_t)node->face << 8 | node->leaving);
}

/* Ignores what ends a branch: a threshold that is met by a hair changes nothing to see. */
static void pass_end(void *context, const struct observed_end *end) {
    (void)context;
    (void)end;
}

struct signing {
    const struct arithmetic *arithmetic;
    const struct scene *scene;
    struct signatures *signatures;
};

static void sign_row(void *context, unsigned y) {
    const struct signing *signing = context;
    unsigned width = signing->signatures->width;
    for (unsigned x = 0; x < width; x++) {
        uint64_t hash = no_hash;
        const struct pixel_observer observer = {&hash, sign_node, pass_end};
        struct render_counts counts;
        double intensity[3];
        memset(&counts, 0, sizeof counts);
        signing->arithmetic->pixel(signing->scene, (uint16_t)x, (uint16_t)y, intensity, &counts,
                                   &observer);
        signing->signatures->of_pixel[(size_t)y * width + x] = hash != 0 ? hash : 1;
    }
}

bool signatures_make(const struct signature_job *job, struct signatures *signatures,
                     struct scene_error *error) {
    struct estimate estimate;
    struct render_counts counts = {0};
    const struct arithmetic *arithmetic = arithmetic_for(job->arithmetic, job->scene);
    struct scene *scene = arithmetic->load(job->scene, error);
    if (scene == NULL) {
        return false;
    }
    signatures->width = job->scene->width;
    signatures->height = job->scene->height;
    signatures->of_pixel =
        calloc((size_t)signatures->width * signatures->height, sizeof *signatures->of_pixel);
    if (signatures->of_pixel == NULL) {
        (void)snprintf(error->text, sizeof error->text, "out of memory");
        free(scene);
        return false;
    }
    arithmetic->learn(scene, &estimate, &counts);
    struct signing signing = {arithmetic, scene, signatures};
    parallel_for(job->first_row, job->last_row, job->jobs, sign_row, &signing, job->stop);
    free(scene);
    return true;
}

/* ---- Files ---------------------------------------------------------------------------------- */

bool signatures_write(const struct signatures *signatures, FILE *file) {
    size_t count = (size_t)signatures->width * signatures->height;
    (void)fprintf(file, "%s%u %u\n", magic, signatures->width, signatures->height);
    for (size_t i = 0; i < count; i++) {
        uint8_t bytes[BYTES];
        for (int j = 0; j < BYTES; j++) {
            bytes[j] = (uint8_t)(signatures->of_pixel[i] >> 8 * j);
        }
        if (fwrite(bytes, 1, BYTES, file) != BYTES) {
            return false;
        }
    }
    return ferror(file) == 0;
}

/* Reads a side, a number of one to five digits from 1 to SIDE_MOST, and the letter behind it. */
static bool read_side(const char **text, char end, unsigned *side) {
    unsigned digits = 0;
    *side = 0;
    for (; **text >= '0' && **text <= '9' && digits < 5; ++*text, digits++) {
        *side = *side * 10 + (unsigned)(**text - '0');
    }
    return digits > 0 && *(*text)++ == end && *side >= 1 && *side <= SIDE_MOST;
}

const char *signatures_read(FILE *file, struct signatures *signatures) {
    char head[HEAD_SIZE];
    memset(signatures, 0, sizeof *signatures);
    const char *text = head + sizeof magic - 1;
    if (fgets(head, sizeof head, file) == NULL || strncmp(head, magic, sizeof magic - 1) != 0) {
        return "is no file of signatures; allowed is: what render --signatures wrote";
    }
    if (!read_side(&text, ' ', &signatures->width) ||
        !read_side(&text, '\n', &signatures->height)) {
        return "its first line is damaged; allowed is: a width and a height of 1..16384";
    }
    size_t count = (size_t)signatures->width * signatures->height;
    signatures->of_pixel = calloc(count, sizeof *signatures->of_pixel);
    if (signatures->of_pixel == NULL) {
        return "out of memory";
    }
    for (size_t i = 0; i < count; i++) {
        uint8_t bytes[BYTES];
        if (fread(bytes, 1, BYTES, file) != BYTES) {
            return "ends too early";
        }
        for (int j = 0; j < BYTES; j++) {
            signatures->of_pixel[i] |= (uint64_t)bytes[j] << 8 * j;
        }
    }
    return fgetc(file) == EOF ? NULL : "goes on behind its last signature";
}

bool signatures_begin(FILE *file) {
    int first = getc(file);
    return ungetc(first, file) == magic[0];
}

void signatures_free(struct signatures *signatures) {
    free(signatures->of_pixel);
    memset(signatures, 0, sizeof *signatures);
}

/* ---- Comparing ------------------------------------------------------------------------------ */

/* Returns the largest difference of a channel between two pictures at one pixel, in its first
 * dot. */
static unsigned pixel_error(const uint8_t *a, const uint8_t *b, size_t at) {
    unsigned worst = 0;
    for (size_t i = at; i < at + 3; i++) {
        unsigned off = a[i] > b[i] ? (unsigned)(a[i] - b[i]) : (unsigned)(b[i] - a[i]);
        worst = off > worst ? off : worst;
    }
    return worst;
}

void signatures_compare(const struct signatures *one, const struct signatures *other,
                        const uint8_t *a, const uint8_t *b, unsigned width, unsigned dots,
                        struct signature_comparison *comparison) {
    memset(comparison, 0, sizeof *comparison);
    for (unsigned y = 0; y < one->height; y++) {
        for (unsigned x = 0; x < one->width; x++) {
            size_t i = (size_t)y * one->width + x;
            size_t at = 3 * ((size_t)y * dots * width + (size_t)x * dots);
            unsigned error = a != NULL ? pixel_error(a, b, at) : 0;
            comparison->pixels++;
            if (one->of_pixel[i] != other->of_pixel[i]) {
                comparison->flips++;
                comparison->flip_error =
                    error > comparison->flip_error ? error : comparison->flip_error;
            } else {
                comparison->drift = error > comparison->drift ? error : comparison->drift;
                comparison->drifted += error > 1;
            }
        }
    }
}
