/* SPDX-License-Identifier: MIT */
/* The relation between a picture whose accuracy is asked for and one without a threshold. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "relation.h"

/* In levels: the coarser, the more is left out, and the more the bounds have to hold. */
static const double asked[] = {64, 8, 1};
enum { ASKED = sizeof asked / sizeof asked[0] };

/* A scene in one arithmetic's tables. */
struct subject {
    struct form form;
    const struct arithmetic *arithmetic;
    struct scene *scene;
};

/* Loads a scene without a threshold, or with an error asked for. False: it is refused. */
static bool subject_start(struct subject *subject, const struct syntax *syntax, int arithmetic) {
    subject->scene = NULL;
    if (form_start(&subject->form, syntax)) {
        struct estimate estimate;
        struct render_counts counts = {0};
        subject->arithmetic =
            arithmetic_for(relation_arithmetic(arithmetic), subject->form.compiled);
        subject->scene = subject->arithmetic->load(subject->form.compiled, &subject->form.error);
        if (subject->scene != NULL) {
            subject->arithmetic->learn(subject->scene, &estimate, &counts);
        }
    }
    return subject->scene != NULL;
}

static void subject_end(struct subject *subject) {
    free(subject->scene);
    form_end(&subject->form);
}

/* One pixel in levels as a screen clamps them, and what it took. */
struct traced_pixel {
    double level[3];
    struct render_counts counts;
};

static void trace(const struct subject *subject, int x, int y, struct traced_pixel *pixel) {
    memset(pixel, 0, sizeof *pixel);
    subject->arithmetic->pixel(subject->scene, (uint16_t)x, (uint16_t)y, pixel->level,
                               &pixel->counts, NULL);
    for (int i = 0; i < 3; i++) {
        pixel->level[i] = fmin(fmax(pixel->level[i], 0), 255);
    }
}

static double distance(const double a[3], const double b[3]) {
    return fmax(fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1])), fabs(a[2] - b[2]));
}

/* Holds one pixel to its proof. Without a threshold, each ray rounds what it adds by half a step of
 * 2^-16 level at most. A pixel that a budget ended is known by nobody. */
static void hold_pixel(const struct subject *exact, const struct subject *found, int x, int y,
                       struct trial_result *result) {
    struct traced_pixel right, pixel;
    trace(exact, x, y, &right);
    trace(found, x, y, &pixel);
    result->pixels++;
    if (right.counts.exhausted_pixels > 0) {
        return;
    }
    double off = distance(pixel.level, right.level);
    double proved = pixel.counts.proved_error / 65536.0 + (double)right.counts.rays / 131072 + 1e-9;
    result->agreeing += off <= proved;
    if (off > proved) {
        result_fail(result, FAULT_DRIFT,
                    "--error %g: pixel %d %d is off by %.6f levels, proved are %.6f",
                    found->form.syntax->error, x, y, off, proved);
    }
}

void check_proved(struct form *form, int arithmetic, struct rendering *room,
                  struct trial_result *result) {
    struct syntax *whole = malloc(sizeof *whole), *rough = malloc(sizeof *rough);
    struct subject exact, found;
    (void)room;
    result->applies = whole != NULL && rough != NULL;
    for (int i = 0; result->applies && i < ASKED; i++) {
        *whole = *rough = *form->syntax;
        whole->threshold = 0;
        rough->error = asked[i];
        bool has_exact = subject_start(&exact, whole, arithmetic);
        result->applies = subject_start(&found, rough, arithmetic) && has_exact;
        for (int j = 0; result->applies && j < whole->width * whole->height; j++) {
            hold_pixel(&exact, &found, j % whole->width, j / whole->width, result);
        }
        subject_end(&found);
        subject_end(&exact);
    }
    free(rough);
    free(whole);
}
