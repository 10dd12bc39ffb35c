/* SPDX-License-Identifier: MIT */
/* superframe compare: how far two pictures are apart, and why. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
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

/* A file that is read; all NULL: no file was given. */
struct operand {
    const char *path;
    FILE *file;
};

/* Two of everything that is compared; all zero where no such files are given. */
struct compared {
    const struct options *options;
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
static int check_count(const struct options *options) {
    if (options->signatures == NULL && options->operand_count == 1) {
        return bad_input("%s", lacks_picture);
    }
    if (options->signatures == NULL && options->operand_count == OPERANDS_MOST) {
        return bad_input("compare: \"%s\" is one too many; allowed are: A.png B.png, with "
                         "--signatures A.sig B.sig or without",
                         options->operands[OPERANDS_MOST - 1]);
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
    return is_screen ? render_dots(signatures->width, signatures->height) : 1;
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
        complain("out of memory");
        return STATUS_FAILED;
    }
    if (all->signature_files[0].path != NULL) {
        status = measure_signatures(all);
    }
    if (a->rgb != NULL) {
        all->holds =
            comparison_holds(&all->comparison, (unsigned)all->options->within, all->options->share);
    } else {
        all->holds = (double)all->paths.flips <=
                     (1 - all->options->share / 100) * (double)all->paths.pixels + 1e-3;
    }
    return status;
}

static double flip_share(const struct compared *all) {
    return 100.0 * (double)all->paths.flips / (double)all->paths.pixels;
}

static void print_words(const struct compared *all) {
    const struct comparison *comparison = &all->comparison;
    unsigned within = (unsigned)all->options->within;
    uint64_t far = comparison->pixels - comparison_within(comparison, COMPARE_FAR);
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
        (void)printf("over %d LSB          %" PRIu64 " pixels\n", COMPARE_FAR, far);
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

/* Prints a number; null where JSON has no word for it. */
static void print_number(const char *key, double number) {
    if (isfinite(number)) {
        (void)printf("  \"%s\": %.17g,\n", key, number);
    } else {
        (void)printf("  \"%s\": null,\n", key);
    }
}

static void print_json(const struct compared *all) {
    const struct comparison *comparison = &all->comparison;
    unsigned within = (unsigned)all->options->within;
    uint64_t far = comparison->pixels - comparison_within(comparison, COMPARE_FAR);
    (void)printf("{\n");
    if (all->pictures[0].path != NULL) {
        (void)printf("  \"width\": %u,\n  \"height\": %u,\n  \"pixels\": %" PRIu64 ",\n",
                     all->image[0].width, all->image[0].height, comparison->pixels);
        (void)printf("  \"max_error\": %u,\n", comparison_largest(comparison));
        print_number("rmse", comparison_rmse(comparison));
        print_number("psnr", comparison_psnr(comparison)); /* null: the pictures are equal */
        print_number("share_within_1", comparison_share(comparison, 1));
        (void)printf("  \"pixels_over_8\": %" PRIu64 ",\n  \"within\": %u,\n", far, within);
        print_number("share_within", comparison_share(comparison, within));
        print_number("delta_e_mean", all->colours.mean);
        print_number("delta_e_999", all->colours.high);
        print_number("delta_e_max", all->colours.largest);
        print_number("ssim", all->similarity);
    }
    if (all->signature_files[0].path != NULL) {
        (void)printf("  \"signatures\": %" PRIu64 ",\n  \"flips\": %" PRIu64 ",\n",
                     all->paths.pixels, all->paths.flips);
        print_number("flip_share", flip_share(all));
    }
    if (all->signature_files[0].path != NULL && all->pictures[0].path != NULL) {
        (void)printf("  \"flip_error\": %u,\n  \"drift\": %u,\n  \"drifted_over_1\": %" PRIu64
                     ",\n",
                     all->paths.flip_error, all->paths.drift, all->paths.drifted);
    }
    print_number("share", all->options->share);
    (void)printf("  \"holds\": %s\n}\n", all->holds ? "true" : "false");
}

/* Writes the picture of the differences over the first picture's memory, which nothing reads
 * afterwards. */
static int write_difference(struct compared *all) {
    const struct png_image *a = &all->image[0];
    difference_picture(a->rgb, all->image[1].rgb, (size_t)a->width * a->height, a->rgb);
    return write_png_picture(all->options->difference, a->rgb, a->width, a->height) ? STATUS_DONE
                                                                                    : STATUS_FAILED;
}

static int judge(const struct compared *all) {
    if (all->holds) {
        return STATUS_DONE;
    }
    if (all->pictures[0].path != NULL) {
        complain("%.6f %% of the pixels are within %d LSB; asked for are %g %%",
                 comparison_share(&all->comparison, (unsigned)all->options->within),
                 all->options->within, all->options->share);
    } else {
        complain("%.6f %% of the signatures are equal; asked for are %g %%", 100 - flip_share(all),
                 all->options->share);
    }
    return STATUS_NOT_HELD;
}

/* Opens all files, each once, and reads them. */
static int take_operands(struct compared *all) {
    const struct options *options = all->options;
    struct operand operands[OPERANDS_MOST];
    int count = 0, status = check_count(options);
    memset(operands, 0, sizeof operands);
    if (status == STATUS_DONE && options->signatures != NULL &&
        !open_operand(&all->signature_files[0], options->signatures)) {
        status = STATUS_BAD_INPUT;
    }
    for (; count < options->operand_count && status == STATUS_DONE; count++) {
        if (!open_operand(&operands[count], options->operands[count])) {
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
    struct compared all;
    memset(&all, 0, sizeof all);
    all.options = options;
    all.similarity = NAN;
    int status = take_operands(&all);
    if (status == STATUS_DONE) {
        status = measure(&all);
    }
    if (status == STATUS_DONE) {
        if (options->json) {
            print_json(&all);
        } else {
            print_words(&all);
        }
        if (options->difference != NULL) {
            status = write_difference(&all);
        }
    }
    if (status == STATUS_DONE) {
        status = judge(&all);
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

static const struct option_entry own_entries[] = {
    {.name = "within",
     .value = "LSB",
     .type = OPTION_WHOLE,
     OPTION_MEMBER(within),
     .most = 255,
     .help = "the difference that a channel may have (1)"},
    {.name = "share",
     .value = "PERCENT",
     .type = OPTION_REAL,
     OPTION_MEMBER(share),
     .most = 100,
     .help = "the pixels that must be within it (99.9)"},
    {.name = "difference",
     .value = "FILE.png",
     .type = OPTION_TEXT,
     OPTION_MEMBER(difference),
     .role = ROLE_PICTURE,
     .allowed = "a file's name or -",
     .help =
         "write a picture of where they differ: blue 1 LSB, green 2, yellow 4, red 9, white 33"},
    {.name = "signatures",
     .value = "FILE",
     .type = OPTION_TEXT,
     OPTION_MEMBER(signatures),
     .role = ROLE_INPUT,
     .help = "the hashes of paths that render wrote; one more file is an operand"},
    {.name = NULL}};
static const struct option_group group_own = {"Result", own_entries};

static const struct option_group *const groups[] = {&group_own, &group_json, NULL};
static const char *const examples[] = {"compare a.png b.png --within 2 --share 99",
                                       "compare a.png b.png --json --difference where.png", NULL};

const struct command command_compare = {
    .name = "compare",
    .operands = "A.png B.png",
    .summary = "Measure how far two pictures of the same size are apart.",
    .least = 1,
    .most = 3,
    .kind = OPERANDS_FILES,
    .groups = groups,
    .examples = examples,
    .printed = printed,
    .run = run_compare};
