/* SPDX-License-Identifier: MIT */
/* What is measured on the paper's pictures: contrasts, colours and steps within an outline. */
#include "lab/paper/measure.h"

#include <stdlib.h>
#include <string.h>

static bool is_inside(const struct paper_photo *mask, unsigned x, unsigned y) {
    const uint8_t *pixel = paper_pixel(mask, x, y);
    return pixel[0] + pixel[1] + pixel[2] > 0;
}

static unsigned difference(const uint8_t *a, const uint8_t *b) {
    int worst = 0;
    for (int i = 0; i < 3; i++) {
        int step = abs(a[i] - b[i]);
        worst = step > worst ? step : worst;
    }
    return (unsigned)worst;
}

struct paper_contrast paper_contrast(const struct paper_photo *mask, const struct paper_photo *a,
                                     const struct paper_photo *b) {
    struct paper_contrast contrast = {0, 0, 0};
    unsigned long sum = 0, seen = 0;
    for (unsigned y = 0; y < mask->height; y++) {
        for (unsigned x = 0; x < mask->width; x++) {
            if (is_inside(mask, x, y)) {
                unsigned step = difference(paper_pixel(a, x, y), paper_pixel(b, x, y));
                contrast.pixels++;
                sum += step;
                seen += step >= PAPER_SEEN;
            }
        }
    }
    if (contrast.pixels > 0) {
        contrast.mean = (double)sum / (double)contrast.pixels;
        contrast.share = (double)seen / (double)contrast.pixels;
    }
    return contrast;
}

struct paper_mean paper_mean(const struct paper_photo *mask, const struct paper_photo *hole,
                             const struct paper_photo *photo) {
    struct paper_mean mean = {{0, 0, 0}};
    unsigned long pixels = 0;
    for (unsigned y = 0; y < mask->height; y++) {
        for (unsigned x = 0; x < mask->width; x++) {
            if (is_inside(mask, x, y) && (hole == NULL || !is_inside(hole, x, y))) {
                pixels++;
                for (int i = 0; i < 3; i++) {
                    mean.rgb[i] += paper_pixel(photo, x, y)[i];
                }
            }
        }
    }
    for (int i = 0; i < 3 && pixels > 0; i++) {
        mean.rgb[i] /= (double)pixels;
    }
    return mean;
}

double paper_chroma(const struct paper_mean *mean) {
    double least = mean->rgb[0], most = mean->rgb[0];
    for (int i = 1; i < 3; i++) {
        least = mean->rgb[i] < least ? mean->rgb[i] : least;
        most = mean->rgb[i] > most ? mean->rgb[i] : most;
    }
    return most > 0 ? (most - least) / most : 0;
}

/* Finds the mask's widest row. Its pixels are *first .. *end - 1, none where the mask is empty. */
static unsigned widest_row(const struct paper_photo *mask, unsigned *first, unsigned *end) {
    unsigned row = 0;
    *first = *end = 0;
    for (unsigned y = 0; y < mask->height; y++) {
        unsigned left = mask->width, right = 0;
        for (unsigned x = 0; x < mask->width; x++) {
            if (is_inside(mask, x, y)) {
                left = x < left ? x : left;
                right = x + 1;
            }
        }
        if (right > left && right - left > *end - *first) {
            row = y;
            *first = left;
            *end = right;
        }
    }
    return row;
}

/* Finds intervals of one level in the line, and the steps between those that touch. */
static void find_terraces(const uint8_t *line, unsigned length, struct paper_profile *profile) {
    bool was_terrace = false;
    for (unsigned start = 0, end; start < length; start = end) {
        for (end = start; end < length && line[end] == line[start]; end++) {
        }
        bool is_terrace = end - start >= PAPER_TERRACE;
        profile->terraces += is_terrace;
        if (is_terrace && was_terrace) {
            unsigned step = (unsigned)abs(line[start] - line[start - 1]);
            profile->cliff = step > profile->cliff ? step : profile->cliff;
        }
        was_terrace = is_terrace;
    }
}

struct paper_profile paper_profile(const struct paper_photo *mask,
                                   const struct paper_photo *photo) {
    struct paper_profile profile = {0};
    uint8_t line[PICTURE_WIDTH];
    bool seen[256];
    unsigned first, end, row = widest_row(mask, &first, &end);
    if (end - first <= 2 * PAPER_TERRACE) {
        return profile;
    }
    memset(seen, 0, sizeof seen);
    for (unsigned x = first + PAPER_TERRACE; x < end - PAPER_TERRACE; x++) {
        uint8_t level = paper_pixel(photo, x, row)[0];
        unsigned step = profile.length > 0 ? (unsigned)abs(level - line[profile.length - 1]) : 0;
        profile.largest = step > profile.largest ? step : profile.largest;
        profile.levels += !seen[level];
        seen[level] = true;
        line[profile.length++] = level;
    }
    find_terraces(line, profile.length, &profile);
    return profile;
}
