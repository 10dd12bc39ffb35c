/* SPDX-License-Identifier: MIT */
/* How different two colours look: CIEDE2000 between sRGB colours. */
#include "picture/ciede2000.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS = 256 };

static const double pi = 3.14159265358979323846;

/* ---- sRGB to CIELAB ------------------------------------------------------------------------- */

static double linear_level(unsigned level) {
    double share = level / 255.0;
    return share <= 0.04045 ? share / 12.92 : pow((share + 0.055) / 1.055, 2.4);
}

/* Returns the CIE's cube root with its straight part near black. */
static double lab_root(double share) {
    const double border = 216.0 / 24389, slope = 24389.0 / 27;
    return share > border ? cbrt(share) : (slope * share + 16) / 116;
}

/* Converts linear R, G, B to CIELAB, by the rows of IEC 61966-2-1's matrix. Each row is divided by
 * its own sum, which is the white point, so that every grey has a* = b* = 0 exactly. */
static struct lab lab_of_linear(double red, double green, double blue) {
    double x = (0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) /
               (0.4124564 + 0.3575761 + 0.1804375);
    double y = (0.2126729 * red + 0.7151522 * green + 0.0721750 * blue) /
               (0.2126729 + 0.7151522 + 0.0721750);
    double z = (0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) /
               (0.0193339 + 0.1191920 + 0.9503041);
    double fx = lab_root(x), fy = lab_root(y), fz = lab_root(z);
    const struct lab lab = {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
    return lab;
}

struct lab lab_of_srgb(const uint8_t rgb[3]) {
    return lab_of_linear(linear_level(rgb[0]), linear_level(rgb[1]), linear_level(rgb[2]));
}

/* ---- CIEDE2000 ------------------------------------------------------------------------------ */

static double degrees(double radians) {
    return radians * 180 / pi;
}

static double radians(double degrees) {
    return degrees * pi / 180;
}

/* Returns the hue in degrees, 0 <= h < 360; the hue of a grey is 0. */
static double hue(double a, double b) {
    if (fpclassify(a) == FP_ZERO && fpclassify(b) == FP_ZERO) {
        return 0;
    }
    double h = degrees(atan2(b, a));
    return h < 0 ? h + 360 : h;
}

/* Returns the step from one hue to another by the shorter arc, in degrees; 0 where one of the two
 * is grey. */
static double hue_step(double from, double to, bool grey) {
    double step = to - from;
    if (grey) {
        return 0;
    }
    return step > 180 ? step - 360 : step < -180 ? step + 360 : step;
}

/* Returns the hue halfway between two by the shorter arc, in degrees; their sum where one of the
 * two is grey. */
static double mean_hue(double one, double other, bool grey) {
    double sum = one + other;
    if (grey) {
        return sum;
    }
    if (fabs(one - other) <= 180) {
        return sum / 2;
    }
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

/* Returns sqrt(c^7 / (c^7 + 25^7)) for a chroma c. */
static double chroma_share(double chroma) {
    double seventh = pow(chroma, 7);
    return sqrt(seventh / (seventh + 6103515625.0));
}

static double hue_weight(double h) {
    return 1 - 0.17 * cos(radians(h - 30)) + 0.24 * cos(radians(2 * h)) +
           0.32 * cos(radians(3 * h + 6)) - 0.20 * cos(radians(4 * h - 63));
}

double colour_difference(struct lab one, struct lab other) {
    double chroma = (hypot(one.a, one.b) + hypot(other.a, other.b)) / 2;
    double stretch = 1 + 0.5 * (1 - chroma_share(chroma));
    double a1 = stretch * one.a, a2 = stretch * other.a;
    double c1 = hypot(a1, one.b), c2 = hypot(a2, other.b);
    double h1 = hue(a1, one.b), h2 = hue(a2, other.b);
    bool grey = fpclassify(c1 * c2) == FP_ZERO;
    double step_hue = 2 * sqrt(c1 * c2) * sin(radians(hue_step(h1, h2, grey) / 2));
    double l = (one.lightness + other.lightness) / 2 - 50;
    double c = (c1 + c2) / 2, h = mean_hue(h1, h2, grey);
    double from_blue = (h - 275) / 25;
    double turn = sin(radians(60 * exp(-from_blue * from_blue))) * -2 * chroma_share(c);
    double lightness = (other.lightness - one.lightness) / (1 + 0.015 * l * l / sqrt(20 + l * l));
    double chroma_part = (c2 - c1) / (1 + 0.045 * c);
    double hue_part = step_hue / (1 + 0.015 * c * hue_weight(h));
    double square = lightness * lightness + chroma_part * chroma_part + hue_part * hue_part +
                    turn * chroma_part * hue_part;
    return square > 0 ? sqrt(square) : 0; /* rounding may leave less than 0 */
}

/* ---- Pictures ------------------------------------------------------------------------------- */

static int compare_doubles(const void *a, const void *b) {
    const double *one = a, *other = b;
    return (*one > *other) - (*one < *other);
}

bool colour_differences(const uint8_t *a, const uint8_t *b, size_t pixels,
                        struct colour_differences *differences) {
    double linear[LEVELS], sum = 0;
    memset(differences, 0, sizeof *differences);
    if (pixels == 0) {
        return true;
    }
    double *all = calloc(pixels, sizeof *all);
    if (all == NULL) {
        return false;
    }
    for (unsigned i = 0; i < LEVELS; i++) {
        linear[i] = linear_level(i);
    }
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *p = &a[3 * i], *q = &b[3 * i];
        if (memcmp(p, q, 3) != 0) {
            all[i] = colour_difference(lab_of_linear(linear[p[0]], linear[p[1]], linear[p[2]]),
                                       lab_of_linear(linear[q[0]], linear[q[1]], linear[q[2]]));
        }
        sum += all[i];
    }
    qsort(all, pixels, sizeof *all, compare_doubles);
    differences->mean = sum / (double)pixels;
    differences->high = all[pixels - 1 - pixels / 1000];
    differences->largest = all[pixels - 1];
    free(all);
    return true;
}
