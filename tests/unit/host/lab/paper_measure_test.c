/* SPDX-License-Identifier: MIT */
/* What is measured on the paper's pictures, on pictures whose measures are known. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/complain.h"
#include "lab/paper/measure.h"

enum { WIDTH = 40, HEIGHT = 10 };

static bool is_near(double a, double b) {
    return fabs(a - b) < 1e-9;
}

static void clear(struct paper_photo *photo, unsigned dots) {
    memset(photo, 0, sizeof *photo);
    photo->width = WIDTH;
    photo->height = HEIGHT;
    photo->dots = dots;
}

/* One pixel as the screen shows it. */
static void set(struct paper_photo *photo, unsigned x, unsigned y, int r, int g, int b) {
    for (unsigned i = 0; i < photo->dots * photo->dots; i++) {
        uint8_t *dot = &photo->rgb[((y * photo->dots + i / photo->dots) * PICTURE_WIDTH +
                                    x * photo->dots + i % photo->dots) *
                                   3];
        dot[0] = (uint8_t)r;
        dot[1] = (uint8_t)g;
        dot[2] = (uint8_t)b;
    }
}

/* Eight pixels in the mask, of which the outer ones differ by nothing, 4, 5 and 30 in the channel
 * that differs most; what is outside of it differs a lot. */
static void contrast_within_a_mask(void **state) {
    (void)state;
    static struct paper_photo mask, a, b;
    for (unsigned dots = 1; dots <= 2; dots++) {
        clear(&mask, dots);
        clear(&a, dots);
        clear(&b, dots);
        for (unsigned x = 0; x < WIDTH; x++) {
            set(&a, x, 3, 100, 100, 100);
            set(&b, x, 3, 200, 100, 100);
        }
        for (unsigned x = 10; x < 18; x++) {
            set(&mask, x, 3, 0, 0, 1); /* not black is inside, however dark */
            set(&b, x, 3, 100, 100, 100);
        }
        set(&b, 10, 3, 104, 99, 100);
        set(&b, 11, 3, 100, 95, 103);
        set(&b, 17, 3, 101, 110, 70);
        const struct paper_contrast contrast = paper_contrast(&mask, &a, &b);
        assert_int_equal(contrast.pixels, 8);
        assert_true(is_near(contrast.mean, (4 + 5 + 30) / 8.0));
        assert_true(is_near(contrast.share, 2 / 8.0));
    }
}

static void an_empty_mask_shows_nothing(void **state) {
    (void)state;
    static struct paper_photo mask, a;
    clear(&mask, 2);
    clear(&a, 2);
    set(&a, 1, 1, 9, 9, 9);
    const struct paper_contrast contrast = paper_contrast(&mask, &a, &mask);
    const struct paper_mean mean = paper_mean(&mask, NULL, &a);
    assert_int_equal(contrast.pixels, 0);
    assert_true(contrast.mean == 0 && contrast.share == 0);
    assert_true(mean.rgb[0] == 0 && mean.rgb[1] == 0 && mean.rgb[2] == 0);
    assert_int_equal(paper_profile(&mask, &a).length, 0);
}

static void mean_colours_and_their_chroma(void **state) {
    (void)state;
    static struct paper_photo mask, hole, photo;
    clear(&mask, 2);
    clear(&hole, 2);
    clear(&photo, 2);
    for (unsigned x = 0; x < 4; x++) {
        set(&mask, x, 0, 255, 255, 255);
        set(&photo, x, 0, 40, 20, (int)x * 10);
    }
    set(&hole, 3, 0, 255, 255, 255);
    struct paper_mean mean = paper_mean(&mask, NULL, &photo);
    assert_true(is_near(mean.rgb[0], 40) && is_near(mean.rgb[1], 20) && is_near(mean.rgb[2], 15));
    assert_true(is_near(paper_chroma(&mean), 25 / 40.0));
    mean = paper_mean(&mask, &hole, &photo);
    assert_true(is_near(mean.rgb[2], 10));
    const struct paper_mean grey = {{7, 7, 7}}, black = {{0, 0, 0}}, blue = {{0, 0, 3}};
    assert_true(paper_chroma(&grey) == 0 && paper_chroma(&black) == 0);
    assert_true(is_near(paper_chroma(&blue), 1));
}

/* The line of levels, with PAPER_TERRACE pixels more at both ends, which are not looked at. */
static struct paper_profile profile_of(const int *levels, unsigned count) {
    static struct paper_photo mask, photo;
    clear(&mask, 1);
    clear(&photo, 1);
    set(&mask, 20, 2, 255, 255, 255); /* a narrower row above, and one below */
    set(&mask, 20, 8, 255, 255, 255);
    for (unsigned i = 0; i < count + 2 * PAPER_TERRACE; i++) {
        bool is_end = i < PAPER_TERRACE || i >= count + PAPER_TERRACE;
        set(&mask, 5 + i, 6, 255, 255, 255);
        set(&photo, 5 + i, 6, is_end ? 255 : levels[i - PAPER_TERRACE], 9, 9);
    }
    return paper_profile(&mask, &photo);
}

static void terraces_and_cliffs(void **state) {
    (void)state;
    /* Terraces of 16, 32 and 48; the last step of 4 leads to two pixels only. */
    static const int coarse[] = {16, 16, 16, 32, 32, 32, 32, 48, 48, 48, 52, 52};
    struct paper_profile profile = profile_of(coarse, 12);
    assert_int_equal(profile.length, 12);
    assert_int_equal(profile.levels, 4);
    assert_int_equal(profile.largest, 16);
    assert_int_equal(profile.terraces, 3);
    assert_int_equal(profile.cliff, 16);
    /* A steep ramp between two terraces is no cliff: they don't touch. */
    static const int ramp[] = {10, 10, 10, 40, 70, 100, 100, 100, 101, 101, 101};
    profile = profile_of(ramp, 11);
    assert_int_equal(profile.levels, 5);
    assert_int_equal(profile.largest, 30);
    assert_int_equal(profile.terraces, 3);
    assert_int_equal(profile.cliff, 1);
    /* Downwards too. */
    static const int down[] = {90, 90, 90, 74, 74, 74};
    profile = profile_of(down, 6);
    assert_int_equal(profile.cliff, 16);
}

static void verdicts(void **state) {
    (void)state;
    static const bool all[] = {true, true}, some[] = {false, true}, none[] = {false, false};
    static struct paper_claim claim;
    assert_int_equal(paper_judge(&claim, all, 2), STATUS_DONE);
    assert_int_equal(claim.verdict, PAPER_HOLDS);
    assert_int_equal(paper_judge(&claim, some, 2), STATUS_DONE);
    assert_int_equal(claim.verdict, PAPER_HOLDS_IN_PART);
    assert_int_equal(paper_judge(&claim, none, 2), STATUS_DONE);
    assert_int_equal(claim.verdict, PAPER_DOES_NOT_HOLD);
    assert_string_equal(paper_verdict_text(PAPER_HOLDS), "holds");
    assert_string_equal(paper_verdict_text(PAPER_HOLDS_IN_PART), "holds in part");
    assert_string_equal(paper_verdict_text(PAPER_DOES_NOT_HOLD), "does not hold");
    assert_string_equal(paper_verdict_text(PAPER_NOT_MEASURED), "not measured");
}

static void texts_are_joined_and_end_in_time(void **state) {
    (void)state;
    static char text[PAPER_TEXT_SIZE + 1];
    text[PAPER_TEXT_SIZE] = '#';
    paper_say(text, "N = %d", 5);
    paper_say(text, ", %.1f", 2.25);
    assert_string_equal(text, "N = 5, 2.2");
    for (int i = 0; i < PAPER_TEXT_SIZE; i++) {
        paper_say(text, "ab");
    }
    assert_int_equal(strlen(text), PAPER_TEXT_SIZE - 1);
    assert_int_equal(text[PAPER_TEXT_SIZE], '#');
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contrast_within_a_mask),
        cmocka_unit_test(an_empty_mask_shows_nothing),
        cmocka_unit_test(mean_colours_and_their_chroma),
        cmocka_unit_test(terraces_and_cliffs),
        cmocka_unit_test(verdicts),
        cmocka_unit_test(texts_are_joined_and_end_in_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
