/* SPDX-License-Identifier: MIT */
/* CIEDE2000 against the published pairs, CIELAB against known colours, SSIM against its sum. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "picture/ciede2000.h"
#include "picture/error_map.h"
#include "picture/ssim.h"

/* Sharma, Wu and Dalal (2005), Table 1: two colours, and what the formula makes of them. */
static const struct {
    struct lab one, other;
    double difference;
} published[] = {
    {{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
    {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
    {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
    {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
    {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
    {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
    {{50, 0, 0}, {50, -1, 2}, 2.3669},
    {{50, -1, 2}, {50, 0, 0}, 2.3669},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
    {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
    {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
    {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
    {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
    {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
    {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
    {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
    {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
    {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
    {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
    {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

enum { PAIRS = sizeof published / sizeof published[0] };

static void assert_near(double actual, double expected, double within) {
    if (!(fabs(actual - expected) <= within)) {
        fail_msg("%.9g is not within %g of %.9g", actual, within, expected);
    }
}

static void the_published_pairs_to_all_four_digits(void **state) {
    (void)state;
    for (int i = 0; i < PAIRS; i++) {
        double there = colour_difference(published[i].one, published[i].other);
        assert_near(there, published[i].difference, 0.5e-4 + 1e-9);
        assert_near(colour_difference(published[i].other, published[i].one), there, 1e-9);
        assert_near(colour_difference(published[i].one, published[i].one), 0, 1e-9);
    }
}

/* Values of Bruce Lindbloom's calculator, sRGB, D65. */
static void known_colours_in_cielab(void **state) {
    (void)state;
    const uint8_t red[] = {255, 0, 0}, green[] = {0, 255, 0}, blue[] = {0, 0, 255};
    const struct lab expected[] = {
        {53.2408, 80.0925, 67.2032}, {87.7347, -86.1827, 83.1793}, {32.2970, 79.1875, -107.8602}};
    const struct lab found[] = {lab_of_srgb(red), lab_of_srgb(green), lab_of_srgb(blue)};
    for (int i = 0; i < 3; i++) {
        assert_near(found[i].lightness, expected[i].lightness, 2e-3);
        assert_near(found[i].a, expected[i].a, 2e-2);
        assert_near(found[i].b, expected[i].b, 2e-2);
    }
}

static void a_grey_has_no_colour_and_white_is_100(void **state) {
    (void)state;
    for (unsigned level = 0; level < 256; level++) {
        const uint8_t grey[] = {(uint8_t)level, (uint8_t)level, (uint8_t)level};
        struct lab lab = lab_of_srgb(grey);
        assert_near(lab.a, 0, 1e-10);
        assert_near(lab.b, 0, 1e-10);
        assert_near(lab.lightness, level == 0 ? 0 : level == 255 ? 100 : lab.lightness, 1e-9);
    }
}

static void mean_percentile_and_largest(void **state) {
    (void)state;
    static uint8_t a[6000], b[6000]; /* 2000 pixels */
    struct colour_differences found;
    memset(a, 100, sizeof a);
    memset(b, 100, sizeof b);
    assert_true(colour_differences(a, b, 2000, &found));
    assert_true(found.mean <= 0 && found.high <= 0 && found.largest <= 0);
    memset(b, 0, 3);      /* one of 2000, far off */
    memset(b + 3, 90, 3); /* another, a little */
    memset(b + 6, 90, 3);
    assert_true(colour_differences(a, b, 2000, &found));
    double far = colour_difference(lab_of_srgb(a), lab_of_srgb(b));
    double near = colour_difference(lab_of_srgb(a), lab_of_srgb(b + 3));
    assert_near(found.largest, far, 1e-9);
    assert_near(found.high, near, 1e-9); /* 2 of 2000 may be above: the third is it */
    assert_near(found.mean, (far + 2 * near) / 2000, 1e-9);
    assert_true(colour_differences(a, b, 0, &found));
    assert_true(found.largest <= 0);
}

/* Pixels of any colours: what is said of the picture is what the formula says of each pixel, and
 * the same the other way round. */
static void a_picture_is_the_sum_of_its_pixels(void **state) {
    (void)state;
    enum { PIXELS = 999 };
    static uint8_t a[3 * PIXELS], b[3 * PIXELS];
    struct colour_differences found, turned;
    uint32_t seed = 5;
    double sum = 0, largest = 0;
    for (size_t i = 0; i < sizeof a; i++) {
        seed = seed * 1664525u + 1013904223u;
        a[i] = (uint8_t)(seed >> 24);
        b[i] = (uint8_t)(seed >> 16);
    }
    for (size_t i = 0; i < PIXELS; i++) {
        double one = colour_difference(lab_of_srgb(&a[3 * i]), lab_of_srgb(&b[3 * i]));
        sum += one;
        largest = fmax(largest, one);
    }
    assert_true(colour_differences(a, b, PIXELS, &found));
    assert_true(colour_differences(b, a, PIXELS, &turned));
    assert_near(found.mean, sum / PIXELS, 1e-9);
    assert_near(found.largest, largest, 1e-9);
    assert_near(turned.mean, found.mean, 1e-9);
    assert_near(turned.high, found.high, 1e-9);
    assert_near(turned.largest, found.largest, 1e-9);
}

/* SSIM as its definition says: one window at a time, all of its pixels. */
static double plain_similarity(const uint8_t *a, const uint8_t *b, int width, int height) {
    double sum = 0;
    int windows = 0;
    for (int y = 5; y < height - 5; y++) {
        for (int x = 5; x < width - 5; x++, windows++) {
            double weights = 0, ma = 0, mb = 0, va = 0, vb = 0, cov = 0;
            for (int pass = 0; pass < 2; pass++) {
                for (int v = -5; v <= 5; v++) {
                    for (int u = -5; u <= 5; u++) {
                        const uint8_t *p = &a[3 * ((y + v) * width + x + u)];
                        const uint8_t *q = &b[3 * ((y + v) * width + x + u)];
                        double w = exp(-(u * u + v * v) / 4.5);
                        double s = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
                        double t = 0.299 * q[0] + 0.587 * q[1] + 0.114 * q[2];
                        if (pass == 0) {
                            weights += w;
                            ma += w * s;
                            mb += w * t;
                        } else {
                            va += w * (s - ma) * (s - ma) / weights;
                            vb += w * (t - mb) * (t - mb) / weights;
                            cov += w * (s - ma) * (t - mb) / weights;
                        }
                    }
                }
                if (pass == 0) {
                    ma /= weights;
                    mb /= weights;
                }
            }
            sum += (2 * ma * mb + 6.5025) * (2 * cov + 58.5225) /
                   ((ma * ma + mb * mb + 6.5025) * (va + vb + 58.5225));
        }
    }
    return sum / windows;
}

static void similarity_is_what_its_definition_says(void **state) {
    (void)state;
    enum { WIDTH = 23, HEIGHT = 17 };
    static uint8_t a[3 * WIDTH * HEIGHT], b[3 * WIDTH * HEIGHT];
    uint32_t seed = 1;
    for (size_t i = 0; i < sizeof a; i++) {
        seed = seed * 1664525 + 1013904223;
        a[i] = (uint8_t)(seed >> 24);
        b[i] = (uint8_t)(a[i] / 2 + (seed >> 16 & 0x3F));
    }
    double there, back, same;
    assert_true(picture_similarity(a, b, WIDTH, HEIGHT, &there));
    assert_true(picture_similarity(b, a, WIDTH, HEIGHT, &back));
    assert_true(picture_similarity(a, a, WIDTH, HEIGHT, &same));
    assert_near(there, plain_similarity(a, b, WIDTH, HEIGHT), 1e-9);
    assert_near(back, there, 1e-12);
    assert_near(same, 1, 1e-12);
    assert_true(there < 0.9);
}

static void similarity_of_two_greys_and_of_too_small_pictures(void **state) {
    (void)state;
    static uint8_t a[3 * 11 * 11], b[3 * 11 * 11];
    double found;
    memset(a, 100, sizeof a);
    memset(b, 150, sizeof b);
    assert_true(picture_similarity(a, b, 11, 11, &found));
    assert_near(found, (2 * 100.0 * 150 + 6.5025) / (100.0 * 100 + 150.0 * 150 + 6.5025), 1e-9);
    assert_true(picture_similarity(a, b, 10, 12, &found));
    assert_true(isnan(found));
}

static void the_difference_picture_has_its_steps(void **state) {
    (void)state;
    static const unsigned off[] = {0, 1, 2, 3, 4, 8, 9, 32, 33, 255};
    static const int step[] = {0, 1, 2, 2, 3, 3, 4, 4, 5, 5};
    for (int i = 0; i < 10; i++) {
        uint8_t a[3] = {0, 0, 0}, b[3] = {0, 0, 0}, rgb[3];
        a[i % 3] = (uint8_t)off[i];
        difference_picture(a, b, 1, rgb);
        assert_memory_equal(rgb, difference_steps[step[i]].rgb, 3);
        difference_picture(b, a, 1, b);
        assert_memory_equal(b, difference_steps[step[i]].rgb, 3);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_published_pairs_to_all_four_digits),
        cmocka_unit_test(known_colours_in_cielab),
        cmocka_unit_test(a_grey_has_no_colour_and_white_is_100),
        cmocka_unit_test(mean_percentile_and_largest),
        cmocka_unit_test(a_picture_is_the_sum_of_its_pixels),
        cmocka_unit_test(similarity_is_what_its_definition_says),
        cmocka_unit_test(similarity_of_two_greys_and_of_too_small_pictures),
        cmocka_unit_test(the_difference_picture_has_its_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
