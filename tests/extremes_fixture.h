/* SPDX-License-Identifier: MIT */
/* Small scenes at their limits: pictures without a NaN or a leaked ray, against f128's. */
#ifndef SUPERFRAME_EXTREMES_FIXTURE_H
#define SUPERFRAME_EXTREMES_FIXTURE_H

#include "scene_fixture.h"

static const char *const extreme_arithmetics[] = {"fx", "f32", "f64"};
enum { FX, F32, F64, EXTREME_ARITHMETICS };

enum { PICTURE_PIXELS_MOST = 64 * 64, EXTREME_TEXT_SIZE = 24576 };

/* Intensities in levels, before rounding, and the sum of what was cut off or left the scene. */
struct picture {
    int width, height;
    double level[PICTURE_PIXELS_MOST][3];
    double weight_at_ends[PICTURE_PIXELS_MOST]; /* green: 1 where nothing absorbs */
    struct render_counts counts;
};

static inline void ignore_node(void *context, const struct observed_node *node) {
    (void)context;
    (void)node;
}

static inline void add_end(void *context, const struct observed_end *end) {
    *(double *)context += end->weight[1];
}

/* Renders a scene whole; fails at a leaked ray, and at an intensity that no port could show. */
static inline void render_loaded(struct picture *picture, const struct loaded_scene *loaded) {
    picture->width = loaded->compiled->width;
    picture->height = loaded->compiled->height;
    memset(&picture->counts, 0, sizeof picture->counts);
    assert_true(picture->width * picture->height <= PICTURE_PIXELS_MOST);
    for (int y = 0; y < picture->height; y++) {
        for (int x = 0; x < picture->width; x++) {
            int pixel = y * picture->width + x;
            double *level = picture->level[pixel];
            const struct pixel_observer observer = {&picture->weight_at_ends[pixel], ignore_node,
                                                    add_end};
            picture->weight_at_ends[pixel] = 0;
            loaded->arithmetic->pixel(loaded->scene, (uint16_t)x, (uint16_t)y, level,
                                      &picture->counts, &observer);
            for (int i = 0; i < 3; i++) {
                if (!(level[i] >= 0 && level[i] <= 32768)) {
                    fail_msg("%s: pixel %d %d, channel %d: %g", loaded->arithmetic->image->name, x,
                             y, i, level[i]);
                }
            }
        }
    }
    if (picture->counts.leaked_rays != 0) {
        fail_msg("%s: %u of %u rays leaked", loaded->arithmetic->image->name,
                 (unsigned)picture->counts.leaked_rays, (unsigned)picture->counts.rays);
    }
}

static inline void render_description(struct picture *picture,
                                      const struct scene_description *description,
                                      const char *arithmetic) {
    struct loaded_scene loaded = load_description(description, arithmetic);
    render_loaded(picture, &loaded);
    unload(&loaded);
}

static inline void render_text(struct picture *picture, const char *text, const char *arithmetic) {
    struct scene_description *description = read_text(text);
    render_description(picture, description, arithmetic);
    scene_description_free(description);
}

static inline int shown_level(double intensity) {
    return (int)floor(fmin(fmax(intensity, 0), 255) + 0.5);
}

/* How many pixels are shown more than `within` LSB apart in some channel. */
static inline int pixels_apart(const struct picture *a, const struct picture *b, int within) {
    int apart = 0;
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    for (int pixel = 0; pixel < a->width * a->height; pixel++) {
        int most = 0;
        for (int i = 0; i < 3; i++) {
            int difference = abs(shown_level(a->level[pixel][i]) - shown_level(b->level[pixel][i]));
            most = difference > most ? difference : most;
        }
        apart += most > within;
    }
    return apart;
}

static inline void assert_pictures_agree(const struct picture *found,
                                         const struct picture *expected, int allowed,
                                         const char *what) {
    int apart = pixels_apart(found, expected, 1);
    if (apart > allowed) {
        for (int pixel = 0; pixel < found->width * found->height; pixel++) {
            const double *a = found->level[pixel], *b = expected->level[pixel];
            if (fabs(a[0] - b[0]) > 1.5 || fabs(a[1] - b[1]) > 1.5 || fabs(a[2] - b[2]) > 1.5) {
                print_message("pixel %d %d: (%g %g %g) instead of (%g %g %g)\n",
                              pixel % found->width, pixel / found->width, a[0], a[1], a[2], b[0],
                              b[1], b[2]);
                break;
            }
        }
        fail_msg("%s: %d of %d pixels are more than 1 LSB off; allowed are %d", what, apart,
                 found->width * found->height, allowed);
    }
}

/* Whether anything is to be seen: at least so many pixels differ from the first by 8 levels. */
static inline int pixels_unlike_first(const struct picture *picture) {
    int count = 0;
    for (int pixel = 0; pixel < picture->width * picture->height; pixel++) {
        bool unlike = false;
        for (int i = 0; i < 3; i++) {
            unlike = unlike || fabs(picture->level[pixel][i] - picture->level[0][i]) > 8;
        }
        count += unlike;
    }
    return count;
}

/* Pixels that may be off in each arithmetic: 1 in 1,000 for fx and f32, none for f64. */
static inline int pixels_allowed(int arithmetic, const struct picture *picture) {
    return arithmetic == F64 ? 0 : picture->width * picture->height / 1000;
}

/* fx, f32 and f64 show what f128 shows of the same scene. */
static inline void check_against_f128(const char *text) {
    static struct picture expected, found;
    render_text(&expected, text, "f128");
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        render_text(&found, text, extreme_arithmetics[i]);
        assert_pictures_agree(&found, &expected, pixels_allowed(i, &found), extreme_arithmetics[i]);
    }
}

/* The message with which a text is refused, by the reader, the compiler or the arithmetic; "" if it
 * is not. */
static inline const char *refusal_of(const char *text, const char *arithmetic) {
    static struct scene_error error;
    struct compiled_scene *compiled = NULL;
    struct scene *scene = NULL;
    strcpy(error.text, "");
    struct scene_description *description =
        scene_description_read("test.scene", text, strlen(text), &error);
    if (description) {
        compiled = scene_compile(description, &error);
        scene_description_free(description);
    }
    if (compiled) {
        scene = arithmetic_find(arithmetic)->load(compiled, &error);
    }
    free(scene);
    free(compiled);
    return error.text;
}

static inline void assert_refused(const char *text, const char *arithmetic, const char *line,
                                  const char *reason) {
    const char *message = refusal_of(text, arithmetic);
    if (!strstr(message, line) || !strstr(message, reason)) {
        fail_msg("%s: \"%s\" lacks \"%s\" or \"%s\"", arithmetic, message, line, reason);
    }
}

#endif
