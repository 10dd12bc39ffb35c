/* SPDX-License-Identifier: MIT */
/* An accuracy that is asked for: reached on every built-in scene, told truly, and worth its rays.
 */
#include "scene_fixture.h"

#include <limits.h>

enum { WIDTH = 40, HEIGHT = 25, PIXELS = WIDTH * HEIGHT };

/* 99.9 per cent of the pixels are to be near enough. */
enum { FAR_MOST = PIXELS / 1000 };

static const char *const scenes[] = {"fig3",  "fig4a",         "fig4b",        "fig5", "fig6a",
                                     "fig6b", "fig7-isolated", "fig7-frustum", "figA"};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* A picture in levels, neither rounded nor clamped, and what it took without the pre-pass. */
struct picture {
    double level[PIXELS][3];
    double estimated[PIXELS]; /* the error of each pixel as it is told, in levels */
    unsigned long rays, exhausted;
};

/* The weights of a pixel that the threshold cut. */
struct cut_weight {
    double sum[3];
};

static void ignore_node(void *context, const struct observed_node *node) {
    (void)context;
    (void)node;
}

static void note_end(void *context, const struct observed_end *end) {
    struct cut_weight *cut = context;
    for (int i = 0; i < 3 && end->why == OBSERVED_THRESHOLD; i++) {
        cut->sum[i] += end->weight[i];
    }
}

static struct loaded_scene load_with(const char *name, const char *arithmetic, double threshold,
                                     bool estimates, double error) {
    struct scene_error refusal;
    struct scene_description *description = load_scene(name, &refusal);
    assert_non_null(description);
    description->width = WIDTH;
    description->height = HEIGHT;
    description->depth = SCENE_ERROR_DEPTH;
    description->threshold = threshold;
    description->estimates = estimates;
    description->error = error;
    struct loaded_scene loaded = load_description(description, arithmetic);
    scene_description_free(description);
    return loaded;
}

static void render_picture(const struct loaded_scene *loaded, struct picture *picture) {
    memset(picture, 0, sizeof *picture);
    for (int i = 0; i < PIXELS; i++) {
        struct render_counts counts;
        memset(&counts, 0, sizeof counts);
        loaded->arithmetic->pixel(loaded->scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                  picture->level[i], &counts, NULL);
        assert_int_equal(counts.leaked_rays, 0);
        picture->estimated[i] = counts.estimated_error / 65536.0;
        picture->rays += counts.rays;
        picture->exhausted += counts.exhausted_pixels;
    }
}

static void render_uniform(const char *name, double threshold, struct picture *picture) {
    struct loaded_scene loaded = load_with(name, "fx", threshold, true, 0);
    struct render_counts counts = {0};
    struct estimate estimate;
    loaded.arithmetic->learn(loaded.scene, &estimate, &counts);
    render_picture(&loaded, picture);
    unload(&loaded);
}

static void render_asked(const char *name, double error, struct picture *picture) {
    struct loaded_scene loaded = load_with(name, "fx", 0, true, error);
    struct render_counts counts = {0};
    struct estimate estimate;
    loaded.arithmetic->learn(loaded.scene, &estimate, &counts);
    render_picture(&loaded, picture);
    unload(&loaded);
}

/* In double, down to that weight; what is left is worth what a coarser threshold taught. */
static void render_converged(const char *name, double threshold, struct picture *picture) {
    struct loaded_scene coarse = load_with(name, "f64", 1.0 / 1024, true, 0);
    struct loaded_scene loaded = load_with(name, "f64", threshold, false, 0);
    struct render_counts counts = {0};
    struct estimate estimate;
    coarse.arithmetic->learn(coarse.scene, &estimate, &counts);
    for (int i = 0; i < PIXELS; i++) {
        struct cut_weight cut = {{0, 0, 0}};
        const struct pixel_observer observer = {&cut, ignore_node, note_end};
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                 picture->level[i], &counts, &observer);
        for (int j = 0; j < 3; j++) {
            picture->level[i][j] += cut.sum[j] * estimate.mean[WAY_ANY][j] / 65536.0;
        }
    }
    unload(&coarse);
    unload(&loaded);
}

/* The largest difference of a channel, as the screen clamps them. */
static double distance(const double a[3], const double b[3]) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
        most = fmax(most, fabs(fmin(a[i], 255) - fmin(b[i], 255)));
    }
    return most;
}

/* How many pixels are farther off than that, and the worst of them. */
static int far_pixels(const struct picture *a, const struct picture *b, double most, int *worst) {
    int count = 0;
    *worst = 0;
    for (int i = 0; i < PIXELS; i++) {
        count += distance(a->level[i], b->level[i]) > most;
        if (distance(a->level[i], b->level[i]) > distance(a->level[*worst], b->level[*worst])) {
            *worst = i;
        }
    }
    return count;
}

/* The sum of the squares of the distances, each counted up to that one: what is farther off took
 * another way than double, most often. */
static double squares(const struct picture *a, const struct picture *b, double most) {
    double sum = 0;
    for (int i = 0; i < PIXELS; i++) {
        double counted = fmin(distance(a->level[i], b->level[i]), most);
        sum += counted * counted;
    }
    return sum;
}

static struct picture converged, asked, uniform;

/* The rays of the largest threshold, by quarters of an octave down to 2^-12, that is as accurate;
 * ULONG_MAX if none is. With as few pixels far off and as small squares: of so few pixels, none
 * that is far off says little. */
static unsigned long rays_of_uniform(const char *name, double most) {
    int low = 0, high = 32, worst, far = far_pixels(&asked, &converged, most, &worst);
    double square = squares(&asked, &converged, most);
    unsigned long rays = ULONG_MAX;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        render_uniform(name, exp2(-4 - middle / 4.0), &uniform);
        if (far_pixels(&uniform, &converged, most, &worst) <= far &&
            squares(&uniform, &converged, most) <= square) {
            high = middle;
            rays = uniform.rays;
        } else {
            low = middle;
        }
    }
    return rays;
}

/* How many pixels are within what was told of them; 0.05 for what double itself has not followed.
 */
static int truly_told(const struct picture *picture) {
    int count = 0;
    for (int i = 0; i < PIXELS; i++) {
        count += distance(picture->level[i], converged.level[i]) <= picture->estimated[i] + 0.05;
    }
    return count;
}

static void hold(const char *name, double error) {
    int worst;
    render_asked(name, error, &asked);
    int far = far_pixels(&asked, &converged, 1.5 * error, &worst), told = truly_told(&asked);
    print_message("%s --error %g: %d over %g, worst %.2f at %d, %d; %d within their estimate; %lu "
                  "rays\n",
                  name, error, far, 1.5 * error,
                  distance(asked.level[worst], converged.level[worst]), worst % WIDTH,
                  worst / WIDTH, told, asked.rays);
    assert_true(far <= FAR_MOST);
    assert_true(told * 100 >= PIXELS * 97);
    assert_int_equal(asked.exhausted, 0);
}

/* The pre-pass, of up to 640 pixels whatever the size of the picture, is not counted here. Looks
 * begin again each time, which takes fig4b 1.32 times the rays of one threshold. Other scenes take
 * 0.81 to 1.05 times as many. */
static void hold_rays(const char *name, double error) {
    unsigned long rays = rays_of_uniform(name, 1.5 * error);
    print_message("%s --error %g: %lu rays with one threshold\n", name, error, rays);
    assert_true(asked.rays / 14 <= rays / 10);
}

/* A finer accuracy is finer, and costs more. How much more: for half the error what is cut may have
 * a quarter of the squares. They shrink to five eighths while rays grow by a quarter, which makes
 * twice the rays; to follow branches farther than that is of no use. Where next to nothing is cut,
 * pixels that begin lower have fewer looks: figA takes 0.96 times the rays. */
static void every_scene_is_as_accurate_as_was_asked_for(void **state) {
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        bool is_slow = strcmp(scenes[i], "fig4a") == 0;
        double error = is_slow ? 4 : 2;
        render_converged(scenes[i], 1.0 / (is_slow ? 32768 : 65536), &converged);
        hold(scenes[i], error);
        if (!is_slow) {
            hold_rays(scenes[i], error);
        }
        unsigned long rays = asked.rays;
        hold(scenes[i], error / 2);
        assert_true(asked.rays > rays / 10 * 9 && asked.rays < 3 * rays);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_is_as_accurate_as_was_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
