/* SPDX-License-Identifier: MIT */
/* Holds a picture and the statistics that POV-Ray made of an exported scene against our own. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/numbers.h"
#include "png_file.h"
#include "render/arithmetic.h"
#include "scene/load.h"

/* usage: pov_check SCENE WxH N THRESHOLD MODEL HIGHLIGHT THEIRS.png THEIR-LOG
 * (MODEL: simple or fresnel; HIGHLIGHT: phong or blinn)
 * Exit status: 0 they agree, 1 they don't, 2 something could not be read. */

enum { WITHIN = 2 }; /* levels that a pixel may differ */

static const double share_least = 99.9; /* per cent of all pixels, those on edges included */
static const double count_most = 1;     /* per cent that a count may differ */

/* Rays by kind, as POV-Ray counts them: those that depth or threshold end at once as well. */
struct counts {
    uint64_t rays[3]; /* by enum observed_kind */
};

struct comparison {
    uint64_t pixels, apart; /* apart: by more than WITHIN */
    int most;               /* levels */
};

static void count_node(void *context, const struct observed_node *node) {
    struct counts *counts = context;
    counts->rays[node->kind]++;
}

static void count_end(void *context, const struct observed_end *end) {
    struct counts *counts = context;
    if (end->why != OBSERVED_NOTHING) {
        counts->rays[end->kind]++;
    }
}

static void *fail(const char *what, const char *reason) {
    (void)fprintf(stderr, "pov_check: %s: %s\n", what, reason);
    return NULL;
}

static struct compiled_scene *load(char **arguments) {
    struct scene_error error;
    struct scene_overrides overrides;
    uint64_t width, height, depth;
    memset(&overrides, 0, sizeof overrides);
    if (!value_pair(arguments[2], 'x', 1, 640, 400, &width, &height) ||
        !value_whole(arguments[3], 0, SCENE_DEPTH_MOST, &depth) ||
        !value_real(arguments[4], 0, 1, &overrides.threshold)) {
        return fail(arguments[1], "not WxH, N and THRESHOLD behind it");
    }
    overrides.has_model = true;
    overrides.model = strcmp(arguments[5], "simple") == 0 ? MODEL_SIMPLE : MODEL_FRESNEL;
    overrides.has_highlight = true;
    overrides.highlight = strcmp(arguments[6], "blinn") == 0 ? HIGHLIGHT_BLINN : HIGHLIGHT_PHONG;
    overrides.has_size = overrides.has_depth = overrides.has_threshold = true;
    overrides.width = (int)width;
    overrides.height = (int)height;
    overrides.depth = (int)depth;
    struct compiled_scene *compiled = load_compiled_scene(arguments[1], &overrides, &error);
    return compiled != NULL ? compiled : fail("scene", error.text);
}

/* Our picture in f64, and the rays that it took; NULL on failure. */
static uint8_t *render(const struct compiled_scene *compiled, struct counts *counts) {
    struct scene_error error;
    struct render_counts ignored;
    const struct pixel_observer observer = {counts, count_node, count_end};
    const struct arithmetic *arithmetic = arithmetic_for(&arithmetic_f64, compiled);
    struct scene *scene = arithmetic->load(compiled, &error);
    uint8_t *rgb = calloc((size_t)compiled->width * compiled->height, 3);
    if (scene == NULL || rgb == NULL) {
        const char *why = scene == NULL ? error.text : "out of memory";
        free(scene);
        free(rgb);
        return fail("scene", why);
    }
    memset(&ignored, 0, sizeof ignored);
    for (uint16_t y = 0; y < compiled->height; y++) {
        for (uint16_t x = 0; x < compiled->width; x++) {
            double level[3];
            uint8_t *pixel = rgb + ((size_t)y * compiled->width + x) * 3;
            arithmetic->pixel(scene, x, y, level, &ignored, &observer);
            for (int i = 0; i < 3; i++) {
                pixel[i] = (uint8_t)floor(fmin(fmax(level[i], 0), 255) + 0.5);
            }
        }
    }
    free(scene);
    return rgb;
}

static int difference(const uint8_t *a, const uint8_t *b) {
    int most = 0;
    for (int i = 0; i < 3; i++) {
        int apart = abs(a[i] - b[i]);
        most = apart > most ? apart : most;
    }
    return most;
}

static bool picture_agrees(const struct compiled_scene *compiled, const uint8_t *ours,
                           const struct png_image *theirs) {
    struct comparison result = {(uint64_t)compiled->width * compiled->height, 0, 0};
    for (size_t i = 0; i < result.pixels; i++) {
        int apart = difference(ours + 3 * i, theirs->rgb + 3 * i);
        result.apart += apart > WITHIN;
        result.most = apart > result.most ? apart : result.most;
    }
    double share = 100 - 100.0 * (double)result.apart / (double)result.pixels;
    (void)printf("  pictures: %.4f %% of the pixels within %d LSB; %" PRIu64 " of %" PRIu64
                 " are not; the largest difference is %d\n",
                 share, WITHIN, result.apart, result.pixels, result.most);
    return share >= share_least;
}

/* The number behind a label at the start of one of POV-Ray's lines; 0 where it does not say it. */
static bool read_statistics(const char *path, uint64_t *reflected, uint64_t *refracted) {
    char line[256];
    bool has_rays = false;
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        return fail(path, "can't be read") != NULL;
    }
    *reflected = *refracted = 0;
    while (fgets(line, sizeof line, file) != NULL) {
        has_rays = has_rays || strncmp(line, "Rays:", 5) == 0;
        if (strncmp(line, "Reflected Rays:", 15) == 0) {
            *reflected = strtoull(line + 15, NULL, 10);
        } else if (strncmp(line, "Refracted Rays:", 15) == 0) {
            *refracted = strtoull(line + 15, NULL, 10);
        }
    }
    (void)fclose(file);
    return has_rays || fail(path, "has no statistics of POV-Ray's") != NULL;
}

static bool count_agrees(const char *kind, uint64_t ours, uint64_t theirs) {
    double apart = 100 * fabs((double)ours - (double)theirs) / fmax((double)theirs, 1);
    (void)printf("  %s rays: ours %" PRIu64 ", POV-Ray's %" PRIu64 ", %.4f %% apart\n", kind, ours,
                 theirs, apart);
    return apart <= count_most;
}

/* Their picture, of our size; false with the reason printed. */
static bool read_picture(const char *path, const struct compiled_scene *compiled,
                         struct png_image *picture) {
    struct png_error error;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return fail(path, "can't be opened") != NULL;
    }
    enum png_status status = read_png(file, picture, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        return fail(path, error.message) != NULL;
    }
    if (picture->width != compiled->width || picture->height != compiled->height) {
        free_png(picture);
        return fail(path, "is of another size") != NULL;
    }
    return true;
}

static int check(const struct compiled_scene *compiled, const char *picture, const char *log) {
    struct png_image theirs;
    struct counts counts = {{0, 0, 0}};
    uint64_t reflected, refracted;
    if (!read_statistics(log, &reflected, &refracted) ||
        !read_picture(picture, compiled, &theirs)) {
        return 2;
    }
    int status = 2;
    uint8_t *ours = render(compiled, &counts);
    if (ours != NULL) {
        bool good = picture_agrees(compiled, ours, &theirs);
        good = count_agrees("reflected", counts.rays[OBSERVED_REFLECTED], reflected) && good;
        good = count_agrees("refracted", counts.rays[OBSERVED_REFRACTED], refracted) && good;
        status = good ? 0 : 1;
    }
    free(ours);
    free_png(&theirs);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 9) {
        fail("usage", "pov_check SCENE WxH N THRESHOLD MODEL HIGHLIGHT THEIRS.png THEIR-LOG");
        return 2;
    }
    struct compiled_scene *compiled = load(argv);
    int status = compiled == NULL ? 2 : check(compiled, argv[7], argv[8]);
    compiled_scene_free(compiled);
    return status;
}
