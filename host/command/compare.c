/* SPDX-License-Identifier: MIT */
/* superframe compare: how far two pictures are apart, and why. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/output.h"
#include "board_ports.h"
#include "command/command.h"
#include "picture/ciede2000.h"
#include "picture/compare.h"
#include "picture/error_map.h"
#include "picture/sink.h"
#include "picture/ssim.h"
#include "png_file.h"
#include "render/render.h"
#include "render/signatures.h"

enum { OPERANDS_MOST = 3 };

/* Holds the options that `compare` alone takes. */
struct compare_options {
    struct options common;
    unsigned within;        /* LSB, 0..255 */
    double share;           /* per cent, 0..100 */
    const char *difference; /* NULL: no picture of it */
    const char *signatures; /* the first file; NULL: none */
};

/* A file that is read; all NULL: no file was given. */
struct operand {
    const char *path;
    FILE *file;
};

/* Two of everything that is compared; all zero where no such files are given. */
struct compared {
    const struct compare_options *options;
    struct operand pictures[2], signature_files[2];
    struct png_image image[2];
    struct signatures signatures[2];
    struct comparison comparison;
    struct colour_differences colours;
    double similarity; /* NaN: the pictures are too small */
    struct signature_comparison paths;
    bool holds;
};

static bool open_operand(struct operand *operand, const char *path) {
    operand->path = path;
    operand->file = fopen(path, "rb");
    if (operand->file == NULL) {
        complain("%s: cannot be read: %s", path, strerror(errno));
    }
    return operand->file != NULL;
}

static void close_operand(struct operand *operand) {
    if (operand->file != NULL) {
        (void)fclose(operand->file);
    }
    operand->file = NULL;
}

static bool read_picture(const struct operand *operand, struct png_image *image) {
    struct png_error error;
    enum png_status status = read_png(operand->file, image, &error);
    if (status != PNG_OK) {
        complain("%s: %s; allowed is: a PNG file", operand->path, error.message);
    }
    return status == PNG_OK;
}

static bool read_signatures(const struct operand *operand, struct signatures *signatures) {
    const char *wrong = signatures_read(operand->file, signatures);
    if (wrong != NULL) {
        complain("%s: %s", operand->path, wrong);
    }
    return wrong == NULL;
}

static const char lacks_picture[] =
    "compare: B.png is missing; usage: superframe compare A.png B.png";

/* Checks that no operand is missing or too many, as far as the number of operands tells. */
static int check_count(const struct compare_options *options) {
    if (options->signatures == NULL && options->common.operand_count == 1) {
        return bad_input("%s", lacks_picture);
    }
    if (options->signatures == NULL && options->common.operand_count == OPERANDS_MOST) {
        return bad_input("compare: \"%s\" is one too many; allowed are: A.png B.png, with "
                         "--signatures A.sig B.sig or without",
                         options->common.operands[OPERANDS_MOST - 1]);
    }
    return STATUS_DONE;
}

/* Tells pictures from signatures. With --signatures A.sig the other file of signatures stands among
 * the operands, at any place. That file is the one that begins as signatures do, the only operand,
 * or else the third. */
static int sort_operands(struct compared *all, const struct operand *operands, int count) {
    int pictures = 0;
    for (int i = 0; i < count; i++) {
        if (all->signature_files[0].path != NULL && all->signature_files[1].path == NULL &&
            (count == 1 || pictures == 2 || signatures_begin(operands[i].file))) {
            all->signature_files[1] = operands[i];
        } else {
            all->pictures[pictures++] = operands[i];
        }
    }
    if (all->signature_files[0].path != NULL && all->signature_files[1].path == NULL) {
        return bad_input("compare: B.sig is missing; usage: --signatures A.sig B.sig");
    }
    if (pictures == 1) {
        return bad_input("%s", lacks_picture);
    }
    if (pictures == 0 && all->options->difference != NULL) {
        return bad_input("compare: --difference goes with two pictures only");
    }
    return STATUS_DONE;
}

static int read_all(struct compared *all) {
    for (int i = 0; i < 2; i++) {
        if ((all->pictures[i].path != NULL && !read_picture(&all->pictures[i], &all->image[i])) ||
            (all->signature_files[i].path != NULL &&
             !read_signatures(&all->signature_files[i], &all->signatures[i]))) {
            return STATUS_BAD_INPUT;
        }
    }
    const struct png_image *a = &all->image[0], *b = &all->image[1];
    if (a->width != b->width || a->height != b->height) {
        return bad_input("%s is %u x %u pixels, %s is %u x %u; allowed are: pictures of one size",
                         all->pictures[0].path, a->width, a->height, all->pictures[1].path,
                         b->width, b->height);
    }
    const struct signatures *one = &all->signatures[0], *other = &all->signatures[1];
    if (one->width != other->width || one->height != other->height) {
        return bad_input("%s is of %u x %u pixels, %s of %u x %u; allowed are: signatures of one "
                         "size",
                         all->signature_files[0].path, one->width, one->height,
                         all->signature_files[1].path, other->width, other->height);
    }
    return STATUS_DONE;
}

/* Returns the dots along each side of a pixel that has a signature. A screen's picture has 2 where
 * the pixels are few enough; a picture from elsewhere may have one dot a pixel. */
static unsigned dots_a_pixel(const struct compared *all) {
    const struct signatures *signatures = &all->signatures[0];
    const struct png_image *image = &all->image[0];
    bool is_screen = image->width == BOARD_WIDTH && image->height == BOARD_HEIGHT;
    return is_screen ? board_dots_a_pixel(signatures->width, signatures->height) : 1;
}

static int measure_signatures(struct compared *all) {
    const struct png_image *image = &all->image[0];
    const struct signatures *signatures = &all->signatures[0];
    unsigned dots = dots_a_pixel(all);
    if (image->rgb != NULL &&
        (signatures->width * dots > image->width || signatures->height * dots > image->height)) {
        return bad_input("%s is of %u x %u pixels, %s has %u x %u; allowed are: signatures of the "
                         "pictures' own pixels",
                         all->signature_files[0].path, signatures->width, signatures->height,
                         all->pictures[0].path, image->width, image->height);
    }
    signatures_compare(&all->signatures[0], &all->signatures[1], all->image[0].rgb,
                       all->image[1].rgb, image->width, dots, &all->paths);
    return STATUS_DONE;
}

static int measure(struct compared *all) {
    const struct png_image *a = &all->image[0], *b = &all->image[1];
    size_t pixels = (size_t)a->width * a->height;
    int status = STATUS_DONE;
    compare_pictures(a->rgb, b->rgb, pixels, &all->comparison);
    if (a->rgb != NULL &&
        (!colour_differences(a->rgb, b->rgb, pixels, &all->colours) ||
         !picture_similarity(a->rgb, b->rgb, a->width, a->height, &all->similarity))) {
        return failure("out of memory");
    }
    if (all->signature_files[0].path != NULL) {
        status = measure_signatures(all);
    }
    if (a->rgb != NULL) {
        all->holds = comparison_holds(&all->comparison, all->options->within, all->options->share);
    } else {
        all->holds = (double)all->paths.flips <=
                     (1 - all->options->share / 100) * (double)all->paths.pixels + 1e-3;
    }
    return status;
}

static double flip_share(const struct compared *all) {
    return 100.0 * (double)all->paths.flips / (double)all->paths.pixels;
}

static uint64_t pixels_far_off(const struct comparison *comparison) {
    return comparison->pixels - comparison_within(comparison, COMPARE_FAR);
}

static void print_words(const struct compared *all) {
    const struct comparison *comparison = &all->comparison;
    unsigned within = all->options->within;
    if (all->pictures[0].path != NULL) {
        (void)printf("pixels              %" PRIu64 "\n", comparison->pixels);
        (void)printf("largest error       %u LSB\n", comparison_largest(comparison));
        (void)printf("RMSE                %.6f LSB\n", comparison_rmse(comparison));
        (void)printf("PSNR                %.4f dB\n", comparison_psnr(comparison));
        (void)printf("within 1 LSB        %.6f %%\n", comparison_share(comparison, 1));
        if (within != 1) {
            (void)printf("within %-3u LSB      %.6f %%\n", within,
                         comparison_share(comparison, within));
        }
        (void)printf("over %d LSB          %" PRIu64 " pixels\n", COMPARE_FAR,
                     pixels_far_off(comparison));
        (void)printf("CIEDE2000           %.6f mean, %.4f at 99.9 %%, %.4f largest\n",
                     all->colours.mean, all->colours.high, all->colours.largest);
        if (!isnan(all->similarity)) {
            (void)printf("SSIM                %.6f\n", all->similarity);
        }
    }
    if (all->signature_files[0].path != NULL) {
        (void)printf("flips               %" PRIu64 " of %" PRIu64 " signatures, %.6f %%\n",
                     all->paths.flips, all->paths.pixels, flip_share(all));
    }
    if (all->signature_files[0].path != NULL && all->pictures[0].path != NULL) {
        (void)printf("error of flips      %u LSB\n", all->paths.flip_error);
        (void)printf("drift               %u LSB, over 1 LSB in %" PRIu64 " pixels\n",
                     all->paths.drift, all->paths.drifted);
    }
}

static void print_json(const struct compared *all) {
    const struct comparison *comparison = &all->comparison;
    unsigned within = all->options->within;
    struct json json = {.out = stdout};
    json_begin_object(&json, NULL);
    if (all->pictures[0].path != NULL) {
        json_count(&json, "width", all->image[0].width);
        json_count(&json, "height", all->image[0].height);
        json_count(&json, "pixels", comparison->pixels);
        json_count(&json, "max_error", comparison_largest(comparison));
        json_real(&json, "rmse", comparison_rmse(comparison));
        json_real(&json, "psnr", comparison_psnr(comparison)); /* null: the pictures are equal */
        json_real(&json, "share_within_1", comparison_share(comparison, 1));
        json_count(&json, "pixels_over_8", pixels_far_off(comparison));
        json_count(&json, "within", within);
        json_real(&json, "share_within", comparison_share(comparison, within));
        json_real(&json, "delta_e_mean", all->colours.mean);
        json_real(&json, "delta_e_999", all->colours.high);
        json_real(&json, "delta_e_max", all->colours.largest);
        json_real(&json, "ssim", all->similarity);
    }
    if (all->signature_files[0].path != NULL) {
        json_count(&json, "signatures", all->paths.pixels);
        json_count(&json, "flips", all->paths.flips);
        json_real(&json, "flip_share", flip_share(all));
    }
    if (all->signature_files[0].path != NULL && all->pictures[0].path != NULL) {
        json_count(&json, "flip_error", all->paths.flip_error);
        json_count(&json, "drift", all->paths.drift);
        json_count(&json, "drifted_over_1", all->paths.drifted);
    }
    json_real(&json, "share", all->options->share);
    json_flag(&json, "holds", all->holds);
    json_end_object(&json);
}

static int print(struct compared *all) {
    if (all->options->common.json) {
        print_json(all);
    } else {
        print_words(all);
    }
    return STATUS_DONE;
}

/* Writes the picture of the differences over the first picture's memory, which nothing reads
 * afterwards. */
static int write_difference(struct compared *all) {
    const struct png_image *a = &all->image[0];
    if (all->options->difference == NULL) {
        return STATUS_DONE;
    }
    difference_picture(a->rgb, all->image[1].rgb, (size_t)a->width * a->height, a->rgb);
    return write_png_picture(all->options->difference, a->rgb, a->width, a->height) ? STATUS_DONE
                                                                                    : STATUS_FAILED;
}

static int judge(struct compared *all) {
    if (all->holds) {
        return STATUS_DONE;
    }
    if (all->pictures[0].path != NULL) {
        complain("%.6f %% of the pixels are within %u LSB; asked for are %g %%",
                 comparison_share(&all->comparison, all->options->within), all->options->within,
                 all->options->share);
    } else {
        complain("%.6f %% of the signatures are equal; asked for are %g %%", 100 - flip_share(all),
                 all->options->share);
    }
    return STATUS_NOT_HELD;
}

/* Opens all files, each once, and reads them. */
static int take_operands(struct compared *all) {
    const struct compare_options *options = all->options;
    struct operand operands[OPERANDS_MOST];
    int count = 0, status = check_count(options);
    memset(operands, 0, sizeof operands);
    if (status == STATUS_DONE && options->signatures != NULL &&
        !open_operand(&all->signature_files[0], options->signatures)) {
        status = STATUS_BAD_INPUT;
    }
    for (; count < options->common.operand_count && status == STATUS_DONE; count++) {
        if (!open_operand(&operands[count], options->common.operands[count])) {
            status = STATUS_BAD_INPUT;
        }
    }
    if (status == STATUS_DONE) {
        status = sort_operands(all, operands, count);
    }
    if (status == STATUS_DONE) {
        status = read_all(all);
    }
    for (int i = 0; i < OPERANDS_MOST; i++) {
        close_operand(&operands[i]);
    }
    close_operand(&all->signature_files[0]);
    return status;
}

static int run_compare(const struct options *options) {
    static int (*const steps[])(struct compared *) = {take_operands, measure, print,
                                                      write_difference, judge};
    struct compared all;
    memset(&all, 0, sizeof all);
    all.options = (const struct compare_options *)options;
    all.similarity = NAN;
    int status = STATUS_DONE;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](&all);
    }
    for (int i = 0; i < 2; i++) {
        free_png(&all.image[i]);
        signatures_free(&all.signatures[i]);
    }
    return status;
}

static const char *printed(const struct options *options) {
    (void)options;
    return "the report";
}

static const struct option_group group_own = {
    "Result",
    OPTION_ENTRIES({.name = "within",
                    .value = "LSB",
                    WHOLE_IN(struct compare_options, within, 0, 255),
                    .preset = "1",
                    .help = "the difference that a channel may have"},
                   {.name = "share",
                    .value = "PERCENT",
                    REAL_IN(struct compare_options, share, 0, 100),
                    .preset = "99.9",
                    .help = "the pixels that must be within it"},
                   {.name = "difference",
                    .value = "FILE.png",
                    TEXT_IN(struct compare_options, difference),
                    .role = ROLE_PICTURE,
                    .allowed = "a file's name or -",
                    .help = "write a picture of where they differ: blue 1 LSB, green 2, yellow 4, "
                            "red 9, white 33"},
                   {.name = "signatures",
                    .value = "FILE",
                    TEXT_IN(struct compare_options, signatures),
                    .role = ROLE_INPUT,
                    .help = "the hashes of paths that render wrote; one more file is an operand"})};

const struct command command_compare = {
    .name = "compare",
    COMMAND_OPERANDS("A.png B.png", 1, 3, OPERANDS_FILES),
    .summary = "Measure how far two pictures of the same size are apart.",
    .size = sizeof(struct compare_options),
    .groups = OPTION_GROUPS(&group_own, &group_json),
    .examples = COMMAND_EXAMPLES("compare a.png b.png --within 2 --share 99",
                                 "compare a.png b.png --json --difference where.png"),
    .printed = printed,
    .run = run_compare};
