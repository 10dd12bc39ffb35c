/* SPDX-License-Identifier: MIT */
/* Whether --error keeps its promise on scenes that nobody tuned it for, as a table:
 * promise WIDTHxHEIGHT N,N... E,E... FILE...
 *
 * A pixel is known if the tree without a threshold ends within RAYS_MOST rays. It is known as well
 * if it is proved to be nearer than a tenth of the error. Exit status: 0 the promise is kept or
 * withdrawn aloud, and no proved error is exceeded; 1 not; 2 bad usage. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/arithmetic.h"
#include "scene/load.h"

enum { RAYS_MOST = 100000, LIST_MOST = 16 };

/* Within so many times the error are to be so many per cent of the known pixels. */
static const double error_most = 1.5, share_least = 99.9;

/* A scene in the tables of an arithmetic, at one depth level and threshold or error. */
struct subject {
    const struct arithmetic *arithmetic;
    struct scene *scene;
    struct estimate estimate;
    uint64_t learning_rays;
};

struct exact_pixel {
    double level[3];
    double radius; /* the pixel is known to be as near as that; below 0: it is not known */
};

struct frame {
    unsigned width, height;
};

static bool prepare(const char *path, const struct frame *frame, int depth, double error,
                    struct subject *subject) {
    struct scene_error refusal;
    struct scene_description *description = load_scene(path, &refusal);
    if (description == NULL) {
        fprintf(stderr, "promise: %s: %s\n", path, refusal.text);
        return false;
    }
    description->width = (int)frame->width;
    description->height = (int)frame->height;
    description->depth = depth;
    description->threshold = 0;
    description->estimates = error > 0;
    description->error = error;
    struct compiled_scene *compiled = scene_compile(description, &refusal);
    scene_description_free(description);
    subject->scene = NULL;
    if (compiled != NULL) {
        compiled->ray_budget = RAYS_MOST;
        subject->arithmetic = arithmetic_for(arithmetic_find("f64"), compiled);
        subject->scene = subject->arithmetic->load(compiled, &refusal);
    }
    compiled_scene_free(compiled);
    if (subject->scene == NULL) {
        fprintf(stderr, "promise: %s: %s\n", path, refusal.text);
        return false;
    }
    struct render_counts counts = {0};
    subject->arithmetic->learn(subject->scene, &subject->estimate, &counts);
    subject->learning_rays = counts.rays;
    return true;
}

static void trace(const struct subject *subject, const struct frame *frame, unsigned pixel,
                  double level[3], struct render_counts *counts) {
    memset(counts, 0, sizeof *counts);
    subject->arithmetic->pixel(subject->scene, (uint16_t)(pixel % frame->width),
                               (uint16_t)(pixel / frame->width), level, counts, NULL);
}

/* Traces all pixels without a threshold, and those again that take too many rays, to what can be
 * proved of them. */
static bool trace_exact(const char *path, const struct frame *frame, int depth,
                        struct exact_pixel *exact) {
    struct subject whole, fine;
    struct render_counts counts;
    bool good = prepare(path, frame, depth, 0, &whole);
    if (!good || !prepare(path, frame, depth, 1.0 / 64, &fine)) {
        return false;
    }
    for (unsigned i = 0; i < frame->width * frame->height; i++) {
        trace(&whole, frame, i, exact[i].level, &counts);
        exact[i].radius = (double)counts.rays / 131072 + 1e-9;
        if (counts.exhausted_pixels > 0) {
            trace(&fine, frame, i, exact[i].level, &counts);
            exact[i].radius = counts.proved_error / 65536.0 + 1e-9;
        }
    }
    free(whole.scene);
    free(fine.scene);
    return true;
}

/* Returns the largest difference of a channel, as a screen clamps both. */
static double distance(const double a[3], const double b[3]) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
        double left = fmin(fmax(a[i], 0), 255), right = fmin(fmax(b[i], 0), 255);
        most = fmax(most, fabs(left - right));
    }
    return most;
}

/* What was found of one picture: numbers of pixels. */
struct finding {
    unsigned known, far, told, disproved;
    double worst, rays;
};

static struct finding find(const struct subject *subject, const struct frame *frame, double error,
                           const struct exact_pixel *exact) {
    struct finding finding = {0, 0, 0, 0, 0, 0};
    for (unsigned i = 0; i < frame->width * frame->height; i++) {
        struct render_counts counts;
        double level[3];
        trace(subject, frame, i, level, &counts);
        double off = distance(level, exact[i].level);
        finding.rays += (double)counts.rays;
        finding.told += counts.unreached_pixels > 0;
        finding.disproved += off > counts.proved_error / 65536.0 + exact[i].radius;
        if (exact[i].radius <= error / 10) {
            finding.known++;
            finding.far += off > error_most * error && counts.unreached_pixels == 0;
            finding.worst = fmax(finding.worst, counts.unreached_pixels == 0 ? off : 0);
        }
    }
    finding.rays /= (double)frame->width * frame->height;
    return finding;
}

static bool judge(const char *path, const struct frame *frame, int depth, double error,
                  const struct exact_pixel *exact) {
    struct subject subject;
    if (!prepare(path, frame, depth, error, &subject)) {
        return false;
    }
    const struct finding found = find(&subject, frame, error, exact);
    const char *name = strrchr(path, '/');
    double pixels = (double)frame->width * frame->height;
    bool kept = found.far * 100.0 <= (100 - share_least) * found.known;
    printf("| %s | %d | %g | %.1f | %.3f%s | %.2f | %.2f | %u | %.1f (%.1f) |\n",
           name != NULL ? name + 1 : path, depth, error, 100 * found.known / pixels,
           found.known > 0 ? 100.0 * (found.known - found.far) / found.known : 100.0,
           kept ? "" : " **below**", found.worst, 100 * found.told / pixels, found.disproved,
           found.rays, (double)subject.learning_rays / pixels);
    fflush(stdout);
    free(subject.scene);
    return kept && found.disproved == 0;
}

/* Reads numbers with commas between them; returns how many, or 0 for anything else. */
static int read_list(const char *text, double list[LIST_MOST]) {
    int count = 0;
    char *end;
    bool is_number;
    do {
        list[count++] = strtod(text, &end);
        is_number = end != text;
        text = end + 1;
    } while (is_number && *end == ',' && count < LIST_MOST);
    return is_number && *end == '\0' ? count : 0;
}

int main(int argc, char **argv) {
    struct frame frame = {0, 0};
    double depths[LIST_MOST], errors[LIST_MOST];
    bool good = argc > 4 && sscanf(argv[1], "%ux%u", &frame.width, &frame.height) == 2;
    int depth_count = good ? read_list(argv[2], depths) : 0;
    int error_count = good ? read_list(argv[3], errors) : 0;
    struct exact_pixel *exact = calloc((size_t)frame.width * frame.height + 1, sizeof *exact);
    if (exact == NULL || depth_count == 0 || error_count == 0) {
        fprintf(stderr, "usage: promise WIDTHxHEIGHT N,N... E,E... FILE...\n");
        free(exact);
        return 2;
    }
    printf("| scene | N | E | %% known | %% of these kept | worst kept | %% withdrawn | proof "
           "exceeded "
           "| rays a pixel (learning) |\n|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 4; i < argc; i++) {
        for (int j = 0; j < depth_count; j++) {
            if (!trace_exact(argv[i], &frame, (int)depths[j], exact)) {
                free(exact);
                return 2;
            }
            for (int k = 0; k < error_count; k++) {
                good &= judge(argv[i], &frame, (int)depths[j], errors[k], exact);
            }
        }
    }
    free(exact);
    return good ? 0 : 1;
}
