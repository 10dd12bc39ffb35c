/* SPDX-License-Identifier: MIT */
/* Whole frames in fx, f32 and f64 against f128, as a table: accuracy FOLDER [SCENE...]
 *
 * FOLDER holds the f128 pictures of earlier runs; the caller empties it when the renderer has
 * changed. Exit status: 0 every frame is as right as is asked for, 1 one is not, 2 bad usage. */
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <xxhash.h>

#include "picture/compare.h"
#include "render/arithmetic.h"
#include "scene/load.h"
#include "transformed_scene.h"

enum { WIDTH = 640, HEIGHT = 400, PIXELS = WIDTH * HEIGHT, BYTES = 3 * PIXELS, THREADS = 2 };
enum { LISTED_MOST = 12, PATH_SIZE = 512, NODES_MOST = 100000 };

/* A built-in scene, perhaps in another unit of length and at another place. */
static const struct subject {
    const char *scene, *name;
    double scale, move;
} subjects[] = {
    {"fig3", "fig3", 1, 0},
    {"fig3", "fig3 × 0.001", 1e-3, 0},
    {"fig3", "fig3 × 1000", 1e3, 0},
    {"fig3", "fig3 moved by 100", 1, 100},
    {"fig4a", "fig4a", 1, 0},
    {"fig4b", "fig4b", 1, 0},
    {"fig5", "fig5", 1, 0},
    {"fig6a", "fig6a", 1, 0},
    {"fig6b", "fig6b", 1, 0},
    {"fig7-isolated", "fig7-isolated", 1, 0},
    {"fig7-frustum", "fig7-frustum", 1, 0},
    {"figA", "figA", 1, 0},
};

/* The arithmetics under test, with the pixels in 10,000 that may be off by more than 1 LSB. */
static const struct tested {
    const char *name;
    unsigned allowed;
} tested[] = {{"fx", 1}, {"f32", 1}, {"f64", 0}};

/* What the threads share: rows are handed out one by one. */
struct frame_work {
    pthread_mutex_t lock;
    const struct arithmetic *arithmetic;
    const struct scene *scene;
    uint8_t *picture;
    int next_row;
    uint64_t leaked_rays;
};

static void *render_rows(void *argument) {
    struct frame_work *work = argument;
    struct render_counts counts;
    memset(&counts, 0, sizeof counts);
    for (;;) {
        pthread_mutex_lock(&work->lock);
        int row = work->next_row++;
        pthread_mutex_unlock(&work->lock);
        if (row >= HEIGHT) {
            break;
        }
        work->arithmetic->image->row(work->scene, (uint16_t)row,
                                     &work->picture[(size_t)row * 3 * WIDTH], &counts);
    }
    pthread_mutex_lock(&work->lock);
    work->leaked_rays += counts.leaked_rays;
    pthread_mutex_unlock(&work->lock);
    return NULL;
}

/* False, with the reason printed, where a ray leaked or a thread could not start. */
static bool render_frame(const struct arithmetic *arithmetic, const struct scene *scene,
                         uint8_t *picture) {
    struct frame_work work = {PTHREAD_MUTEX_INITIALIZER, arithmetic, scene, picture, 0, 0};
    pthread_t threads[THREADS];
    int started = 0;
    while (started < THREADS && pthread_create(&threads[started], NULL, render_rows, &work) == 0) {
        started++;
    }
    for (int i = 0; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
    if (started == 0) {
        fprintf(stderr, "accuracy: no thread could be started\n");
        return false;
    }
    if (work.leaked_rays != 0) {
        fprintf(stderr, "accuracy: %s: %lu rays leaked\n", arithmetic->image->name,
                (unsigned long)work.leaked_rays);
        return false;
    }
    return true;
}

/* The subject's tables in one arithmetic; NULL with the reason printed. */
static struct scene *load_subject(const struct compiled_scene *compiled, const char *name,
                                  const struct arithmetic **arithmetic) {
    struct scene_error error;
    *arithmetic = arithmetic_find(name);
    struct scene *scene = (*arithmetic)->load(compiled, &error);
    if (!scene) {
        fprintf(stderr, "accuracy: %s: %s\n", name, error.text);
    }
    return scene;
}

/* The f128 picture, from the folder if it is there. The name tells the compiled scene, all of which
 * was cleared before it was filled. */
static bool reference_frame(const char *folder, const struct compiled_scene *compiled,
                            uint8_t *picture) {
    char path[PATH_SIZE];
    const struct arithmetic *arithmetic;
    snprintf(path, sizeof path, "%s/%016llx.rgb", folder,
             (unsigned long long)XXH3_64bits(compiled, sizeof *compiled));
    FILE *file = fopen(path, "rb");
    bool cached = file && fread(picture, 1, BYTES, file) == BYTES;
    if (file) {
        fclose(file);
    }
    if (cached) {
        return true;
    }
    struct scene *scene = load_subject(compiled, "f128", &arithmetic);
    bool good = scene && render_frame(arithmetic, scene, picture);
    free(scene);
    file = good ? fopen(path, "wb") : NULL;
    if (file) {
        bool written = fwrite(picture, 1, BYTES, file) == BYTES;
        if (fclose(file) != 0 || !written) {
            remove(path); /* a picture that could not be kept is rendered again */
        }
    }
    return good;
}

/* The tree of rays of one pixel: which faces, from which side, in which order, and what they show.
 */
struct shape {
    struct observed_node nodes[NODES_MOST];
    size_t count;
};

static void keep_node(void *context, const struct observed_node *node) {
    struct shape *shape = context;
    if (shape->count < NODES_MOST) {
        shape->nodes[shape->count++] = *node;
    }
}

static void ignore_end(void *context, const struct observed_end *end) {
    (void)context;
    (void)end;
}

static void pixel_shape(const struct arithmetic *arithmetic, const struct scene *scene, int pixel,
                        struct shape *shape, double intensity[3]) {
    struct render_counts counts;
    memset(&counts, 0, sizeof counts);
    const struct pixel_observer observer = {shape, keep_node, ignore_end};
    shape->count = 0;
    arithmetic->pixel(scene, (uint16_t)(pixel % WIDTH), (uint16_t)(pixel / WIDTH), intensity,
                      &counts, &observer);
}

/* Why a pixel is off: nothing but rounding, another tree, or the same tree in which a boundary
 * shows another colour: the other cell of a pattern, or light where there was a shadow. */
enum cause { CAUSE_DRIFT, CAUSE_TREE, CAUSE_COLOUR };

static enum cause cause_of(const struct shape *a, const struct shape *b) {
    enum cause cause = a->count == b->count ? CAUSE_DRIFT : CAUSE_TREE;
    for (size_t i = 0; i < a->count && i < b->count && cause != CAUSE_TREE; i++) {
        const struct observed_node *left = &a->nodes[i], *right = &b->nodes[i];
        for (int j = 0; j < 3; j++) {
            cause = fabs(left->local[j] - right->local[j]) > 4 ? CAUSE_COLOUR : cause;
        }
        if (left->parent != right->parent || left->kind != right->kind ||
            left->primitive != right->primitive || left->face != right->face ||
            left->leaving != right->leaving) {
            cause = CAUSE_TREE;
        }
    }
    return cause;
}

static int pixel_difference(const uint8_t *a, const uint8_t *b, int pixel) {
    int most = 0;
    for (int i = 3 * pixel; i < 3 * pixel + 3; i++) {
        int difference = abs(a[i] - b[i]);
        most = difference > most ? difference : most;
    }
    return most;
}

/* What is wrong in a frame. */
struct errors {
    struct comparison measures;
    int off;         /* pixels off by more than 1 LSB */
    int by_cause[3]; /* of those */
    int worst;       /* the pixel with the largest difference */
};

/* Names the first pixels that are off, with both arithmetics' unrounded colours. */
static void judge_pixels(const struct compiled_scene *compiled, const struct arithmetic *arithmetic,
                         const struct scene *scene, const uint8_t *exact, const uint8_t *found,
                         struct errors *errors) {
    static const char *const causes[] = {"drift", "another tree", "another colour at a boundary"};
    static struct shape expected, seen;
    const struct arithmetic *reference;
    struct scene *reference_scene = load_subject(compiled, "f128", &reference);
    int largest = 0;
    for (int pixel = 0; pixel < PIXELS && reference_scene; pixel++) {
        int difference = pixel_difference(exact, found, pixel);
        if (difference > largest) {
            largest = difference;
            errors->worst = pixel;
        }
        if (difference <= 1) {
            continue;
        }
        double a[3], b[3];
        pixel_shape(reference, reference_scene, pixel, &expected, a);
        pixel_shape(arithmetic, scene, pixel, &seen, b);
        enum cause cause = cause_of(&expected, &seen);
        errors->off++;
        errors->by_cause[cause]++;
        if (errors->off <= LISTED_MOST) {
            fprintf(stderr, "  %s: pixel %d %d: %.3f %.3f %.3f for %.3f %.3f %.3f, %s\n",
                    arithmetic->image->name, pixel % WIDTH, pixel / WIDTH, b[0], b[1], b[2], a[0],
                    a[1], a[2], causes[cause]);
        }
    }
    free(reference_scene);
}

static bool compare_arithmetic(const struct subject *subject, const struct compiled_scene *compiled,
                               const struct tested *with, const uint8_t *exact, uint8_t *found) {
    const struct arithmetic *arithmetic;
    struct errors errors;
    memset(&errors, 0, sizeof errors);
    struct scene *scene = load_subject(compiled, with->name, &arithmetic);
    if (!scene || !render_frame(arithmetic, scene, found)) {
        free(scene);
        return false;
    }
    compare_pictures(exact, found, PIXELS, &errors.measures);
    judge_pixels(compiled, arithmetic, scene, exact, found, &errors);
    free(scene);
    bool good = (uint64_t)errors.off * 10000 <= (uint64_t)with->allowed * PIXELS;
    printf("| %s | %s | %.4f%s | %d | %d, %d, %d | %lu | %u | %d, %d |\n", subject->name,
           with->name, comparison_share(&errors.measures, 1), good ? "" : " **below**", errors.off,
           errors.by_cause[CAUSE_COLOUR], errors.by_cause[CAUSE_TREE], errors.by_cause[CAUSE_DRIFT],
           (unsigned long)(PIXELS - comparison_within(&errors.measures, 0)),
           comparison_largest(&errors.measures), errors.worst % WIDTH, errors.worst / WIDTH);
    fflush(stdout);
    return good;
}

/* Renders a subject in every arithmetic; false, with the reason printed, if one is not right. */
static bool measure(const struct subject *subject, const char *folder) {
    struct scene_error error;
    struct compiled_scene *compiled = NULL;
    uint8_t *exact = malloc(BYTES), *found = malloc(BYTES);
    struct scene_description *description = load_scene(subject->scene, &error);
    if (description) {
        description->width = WIDTH;
        description->height = HEIGHT;
        description->colour = COLOUR_FULL;
        transform_scene(description, subject->scale, subject->move);
        compiled = scene_compile(description, &error);
        scene_description_free(description);
    }
    bool good = compiled && exact && found;
    if (!good) {
        fprintf(stderr, "accuracy: %s\n", error.text);
    }
    good = good && reference_frame(folder, compiled, exact);
    bool right = good;
    for (size_t i = 0; i < sizeof tested / sizeof tested[0] && good; i++) {
        right &= compare_arithmetic(subject, compiled, &tested[i], exact, found);
    }
    free(exact);
    free(found);
    compiled_scene_free(compiled);
    return right;
}

static bool is_asked_for(const char *scene, char **names, int count) {
    bool asked = count == 0;
    for (int i = 0; i < count; i++) {
        asked = asked || strcmp(scene, names[i]) == 0;
    }
    return asked;
}

int main(int argc, char **argv) {
    int measured = 0;
    bool right = true;
    if (argc < 2) {
        fprintf(stderr, "usage: accuracy FOLDER [SCENE...]\n");
        return 2;
    }
    printf("| scene, 640 × 400 | arithmetic | share within 1 LSB, %% | pixels off | by a colour, a "
           "tree, drift | not equal | largest error, LSB | worst pixel |\n"
           "|---|---|---|---|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof subjects / sizeof subjects[0]; i++) {
        if (is_asked_for(subjects[i].scene, argv + 2, argc - 2)) {
            right &= measure(&subjects[i], argv[1]);
            measured++;
        }
    }
    if (measured == 0) {
        fprintf(stderr, "accuracy: no such built-in scene\n");
        return 2;
    }
    return right ? 0 : 1;
}
