/* SPDX-License-Identifier: MIT */
/* How far two pictures are apart, where one may have 2 x 2 dots for each pixel of the other. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "png_file.h"

/* usage: psnr A.png B.png
 * Standard output gets the peak signal-to-noise ratio in dB, over all three primaries, 255 as the
 * peak; 999 for pictures that are the same. Exit status: 0; 2 if a file can't be read or the sizes
 * don't go together. The emulated screen shows 320 x 200 pixels as 640 x 400 dots, another renderer
 * writes them as they are: that is why `superframe compare` will not do here. */

static bool read_picture(const char *path, struct png_image *image) {
    struct png_error error = {PNG_OK, ""};
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        (void)fprintf(stderr, "psnr: %s: cannot be read\n", path);
        return false;
    }
    enum png_status status = read_png(file, image, &error);
    (void)fclose(file);
    if (status != PNG_OK) {
        (void)fprintf(stderr, "psnr: %s: %s\n", path, error.message);
    }
    return status == PNG_OK;
}

/* The dots of a to a pixel of b, a side; 0: the sizes don't go together. */
static unsigned dots(const struct png_image *a, const struct png_image *b) {
    unsigned times = a->width / b->width;
    bool fits = (times == 1 || times == 2) && b->width * times == a->width &&
                b->height * times == a->height;
    return fits ? times : 0;
}

static double square_error(const struct png_image *a, const struct png_image *b, unsigned times) {
    double sum = 0;
    for (unsigned y = 0; y < a->height; y++) {
        for (unsigned x = 0; x < a->width; x++) {
            const uint8_t *of_a = a->rgb + ((size_t)y * a->width + x) * 3;
            const uint8_t *of_b = b->rgb + ((size_t)(y / times) * b->width + x / times) * 3;
            for (int i = 0; i < 3; i++) {
                double error = (double)of_a[i] - (double)of_b[i];
                sum += error * error;
            }
        }
    }
    return sum / ((double)a->width * a->height * 3);
}

static int compare(const char *name_a, const char *name_b, const struct png_image *a,
                   const struct png_image *b) {
    const struct png_image *large = a->width >= b->width ? a : b;
    const struct png_image *small = large == a ? b : a;
    unsigned times = dots(large, small);
    if (times == 0) {
        (void)fprintf(stderr, "psnr: %s is %u x %u and %s %u x %u; allowed is: once or twice\n",
                      name_a, a->width, a->height, name_b, b->width, b->height);
        return 2;
    }
    double error = square_error(large, small, times);
    (void)printf("%.3f\n", error > 0 ? 10 * log10(255.0 * 255.0 / error) : 999.0);
    return 0;
}

int main(int argc, char **argv) {
    struct png_image a = {0, 0, NULL}, b = {0, 0, NULL};
    if (argc != 3) {
        (void)fprintf(stderr, "usage: psnr A.png B.png\n");
        return 2;
    }
    int status = 2;
    if (read_picture(argv[1], &a) && read_picture(argv[2], &b)) {
        status = compare(argv[1], argv[2], &a, &b);
    }
    free_png(&a);
    free_png(&b);
    return status;
}
