/* SPDX-License-Identifier: MIT */
/* superframe compare: how far two pictures are apart. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "compare.h"
#include "png_file.h"

static bool read_picture(const char *path, struct png_image *image) {
    struct png_error error;
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        complain("%s: cannot be read: %s", path, strerror(errno));
        return false;
    }
    enum png_status status = read_png(file, image, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        complain("%s: %s; allowed is: a PNG file", path, error.message);
    }
    return status == PNG_OK;
}

static void print_words(const struct comparison *comparison, const struct options *options) {
    unsigned within = (unsigned)options->within;
    uint64_t far = comparison->pixels - comparison_within(comparison, COMPARE_FAR);
    (void)printf("pixels              %" PRIu64 "\n", comparison->pixels);
    (void)printf("largest error       %u LSB\n", comparison_largest(comparison));
    (void)printf("RMSE                %.6f LSB\n", comparison_rmse(comparison));
    (void)printf("PSNR                %.4f dB\n", comparison_psnr(comparison));
    (void)printf("within 1 LSB        %.6f %%\n", comparison_share(comparison, 1));
    if (within != 1) {
        (void)printf("within %-3u LSB      %.6f %%\n", within,
                     comparison_share(comparison, within));
    }
    (void)printf("over %d LSB          %" PRIu64 " pixels\n", COMPARE_FAR, far);
}

static void print_json(const struct comparison *comparison, const struct options *options,
                       const struct png_image *image, bool holds) {
    unsigned within = (unsigned)options->within;
    double psnr = comparison_psnr(comparison);
    uint64_t far = comparison->pixels - comparison_within(comparison, COMPARE_FAR);
    (void)printf("{\n  \"width\": %u,\n  \"height\": %u,\n  \"pixels\": %" PRIu64 ",\n",
                 image->width, image->height, comparison->pixels);
    (void)printf("  \"max_error\": %u,\n  \"rmse\": %.17g,\n", comparison_largest(comparison),
                 comparison_rmse(comparison));
    if (isfinite(psnr)) {
        (void)printf("  \"psnr\": %.17g,\n", psnr);
    } else {
        (void)printf("  \"psnr\": null,\n"); /* the pictures are equal */
    }
    (void)printf("  \"share_within_1\": %.17g,\n  \"pixels_over_8\": %" PRIu64 ",\n",
                 comparison_share(comparison, 1), far);
    (void)printf("  \"within\": %u,\n  \"share_within\": %.17g,\n  \"share\": %.17g,\n", within,
                 comparison_share(comparison, within), options->share);
    (void)printf("  \"holds\": %s\n}\n", holds ? "true" : "false");
}

static int compare(const struct options *options, const struct png_image *a,
                   const struct png_image *b) {
    struct comparison comparison;
    if (a->width != b->width || a->height != b->height) {
        return bad_input("%s is %u x %u pixels, %s is %u x %u; allowed are: pictures of one size",
                         options->operands[0], a->width, a->height, options->operands[1], b->width,
                         b->height);
    }
    compare_pictures(a->rgb, b->rgb, (size_t)a->width * a->height, &comparison);
    bool holds = comparison_holds(&comparison, (unsigned)options->within, options->share);
    if (options->json) {
        print_json(&comparison, options, a, holds);
    } else {
        print_words(&comparison, options);
    }
    if (!holds) {
        complain("%.6f %% of the pixels are within %d LSB; asked for are %g %%",
                 comparison_share(&comparison, (unsigned)options->within), options->within,
                 options->share);
    }
    return holds ? STATUS_DONE : STATUS_NOT_HELD;
}

int run_compare(const struct options *options) {
    struct png_image a, b;
    memset(&a, 0, sizeof a);
    memset(&b, 0, sizeof b);
    int status = STATUS_BAD_INPUT;
    if (read_picture(options->operands[0], &a) && read_picture(options->operands[1], &b)) {
        status = compare(options, &a, &b);
    }
    free_png(&a);
    free_png(&b);
    return status;
}
