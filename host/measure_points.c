/* SPDX-License-Identifier: MIT */
/* The points of `superframe measure`: which there are, and their lines in points.csv. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "load_scene.h"
#include "measure.h"

enum { LINE_SIZE = 1024, BASE_WIDTH = 160, BASE_HEIGHT = 100, BASE_DEPTH = 10, TAIL_DEPTH = 64 };

static const double base_threshold = 1.0 / 4096;

/* ---- Lists ---------------------------------------------------------------------------------- */

void measure_key(const struct measure_point *point, char key[MEASURE_KEY_SIZE]) {
    (void)snprintf(key, MEASURE_KEY_SIZE, "%s,%s,%u,%.9g,%u,%u,%s,%s,%s,%.9g", point->scene,
                   point->arithmetic, point->depth, point->threshold, point->width, point->height,
                   point->colour, point->model, point->tail, point->error);
}

bool measure_list_add(struct measure_list *list, const struct measure_point *point) {
    if (list->count == list->room) {
        size_t room = list->room == 0 ? 64 : 2 * list->room;
        struct measure_point *points = realloc(list->points, room * sizeof *points);
        if (points == NULL) {
            return false;
        }
        list->points = points;
        list->room = room;
    }
    list->points[list->count++] = *point;
    return true;
}

struct measure_point *measure_list_find(const struct measure_list *list,
                                        const struct measure_point *like) {
    char wanted[MEASURE_KEY_SIZE], key[MEASURE_KEY_SIZE];
    measure_key(like, wanted);
    for (size_t i = 0; i < list->count; i++) {
        measure_key(&list->points[i], key);
        if (strcmp(key, wanted) == 0) {
            return &list->points[i];
        }
    }
    return NULL;
}

/* ---- The plan ------------------------------------------------------------------------------- */

static const char *const model_words[] = {"simple", "fresnel", "wavelength"};

static void colour_text(enum scene_colour colour, int bits, char text[16]) {
    if (colour == COLOUR_BITS) {
        (void)snprintf(text, 16, "bits:%d", bits);
    } else {
        (void)snprintf(text, 16, "%s", colour == COLOUR_DITHER ? "dither" : "full");
    }
}

static int add(struct measure *measure, const struct measure_point *point) {
    if (measure_list_find(&measure->points, point) == NULL &&
        !measure_list_add(&measure->points, point)) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

/* Arithmetic by depth by threshold. Without a threshold a tree doubles with each level: only as far
 * as the paper goes. The finest threshold says nothing new where the depth ends the tree. */
static int plan_grid(struct measure *measure, struct measure_point point) {
    static const char *const arithmetics[] = {"fx", "f32", "f64", "q16", "q16_epsilon"};
    static const unsigned depths[] = {1, 2, 4, 7, 10, 16, 32, 64};
    static const double thresholds[] = {0,          1.0 / 256,   1.0 / 1024,
                                        1.0 / 4096, 1.0 / 16384, 1.0 / 65536};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    unsigned many_a = options->has_arithmetic ? 1 : 5, many_d = overrides->has_depth ? 1 : 8;
    unsigned many_t = overrides->has_threshold ? 1 : 6;
    for (unsigned i = 0; i < many_a * many_d * many_t; i++) {
        unsigned a = i / (many_d * many_t), d = i / many_t % many_d, t = i % many_t;
        (void)snprintf(point.arithmetic, sizeof point.arithmetic, "%s",
                       options->has_arithmetic ? options->arithmetic : arithmetics[a]);
        point.depth = overrides->has_depth ? (unsigned)overrides->depth : depths[d];
        point.threshold = overrides->has_threshold ? overrides->threshold : thresholds[t];
        bool is_endless = point.depth > BASE_DEPTH && !(point.threshold > 0);
        bool is_idle = point.depth < 64 && point.threshold > 0 && point.threshold < 1e-4 / 2;
        if ((is_endless || is_idle) && !overrides->has_depth && !overrides->has_threshold) {
            continue;
        }
        if (add(measure, &point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* What an estimated tail gains, where there is room for it. */
static int plan_tails(struct measure *measure, struct measure_point point) {
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    static const double thresholds[] = {1.0 / 256,  1.0 / 1024,  1.0 / 2048,
                                        1.0 / 4096, 1.0 / 16384, 1.0 / 65536};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    unsigned many_a = options->has_arithmetic ? 1 : 3, many_t = overrides->has_threshold ? 1 : 6;
    strcpy(point.tail, "estimate");
    point.depth = overrides->has_depth ? (unsigned)overrides->depth : TAIL_DEPTH;
    for (unsigned i = 0; i < many_a * many_t && !overrides->has_estimates; i++) {
        (void)snprintf(point.arithmetic, sizeof point.arithmetic, "%s",
                       options->has_arithmetic ? options->arithmetic : arithmetics[i / many_t]);
        point.threshold = overrides->has_threshold ? overrides->threshold : thresholds[i % many_t];
        if (add(measure, &point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* An accuracy asked for instead of a threshold; the tail is estimated then. */
static int plan_errors(struct measure *measure, struct measure_point point) {
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    static const double errors[] = {4, 2, 1, 0.5};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    unsigned many_a = options->has_arithmetic ? 1 : 3, many_e = overrides->has_error ? 1 : 4;
    strcpy(point.tail, "estimate");
    point.threshold = 0;
    point.depth = overrides->has_depth ? (unsigned)overrides->depth : TAIL_DEPTH;
    bool is_fixed = overrides->has_threshold || (overrides->has_estimates && !overrides->estimates);
    for (unsigned i = 0; i < many_a * many_e && !is_fixed; i++) {
        (void)snprintf(point.arithmetic, sizeof point.arithmetic, "%s",
                       options->has_arithmetic ? options->arithmetic : arithmetics[i / many_e]);
        point.error = overrides->has_error ? overrides->error : errors[i % many_e];
        if (add(measure, &point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* One setting varied, the others as in the middle of the grid. */
static int plan_star(struct measure *measure, struct measure_point point) {
    static const unsigned sizes[][2] = {{80, 50}, {320, 200}, {640, 400}};
    static const char *const colours[] = {"bits:6", "bits:4", "bits:2", "bits:1", "dither"};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    (void)snprintf(point.arithmetic, sizeof point.arithmetic, "%s", options->arithmetic);
    point.depth = overrides->has_depth ? (unsigned)overrides->depth : BASE_DEPTH;
    point.threshold = overrides->has_threshold ? overrides->threshold : base_threshold;
    int status = STATUS_DONE;
    for (int i = 0; i < 3 && !overrides->has_size && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        other.width = sizes[i][0];
        other.height = sizes[i][1];
        status = add(measure, &other);
    }
    for (int i = 0; i < 5 && !overrides->has_colour && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        (void)snprintf(other.colour, sizeof other.colour, "%s", colours[i]);
        status = add(measure, &other);
    }
    for (int i = 0; i < 3 && !overrides->has_model && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        (void)snprintf(other.model, sizeof other.model, "%s", model_words[i]);
        status = add(measure, &other);
    }
    return status;
}

int measure_plan(struct measure *measure) {
    const struct scene_overrides *overrides = &measure->options->overrides;
    for (size_t i = 0; i < measure->scene_count; i++) {
        struct measure_scene *scene = &measure->scenes[i];
        struct scene_error error;
        struct scene_description *description = load_scene(scene->operand, &error);
        struct compiled_scene *compiled = NULL;
        if (description != NULL) {
            compiled = scene_compile(description, &error);
        }
        if (compiled == NULL) {
            scene_description_free(description);
            return bad_input("%s", error.text);
        }
        scene->mix = cost_mix_of(compiled);
        if (!scene_digest(compiled, scene->digest)) {
            scene_description_free(description);
            free(compiled);
            complain("out of memory");
            return STATUS_FAILED;
        }
        struct measure_point point;
        memset(&point, 0, sizeof point);
        (void)snprintf(point.scene, sizeof point.scene, "%s", scene->name);
        point.width = overrides->has_size ? (unsigned)overrides->width : BASE_WIDTH;
        point.height = overrides->has_size ? (unsigned)overrides->height : BASE_HEIGHT;
        colour_text(overrides->has_colour ? overrides->colour : COLOUR_FULL, overrides->colour_bits,
                    point.colour);
        enum scene_model model = overrides->has_model ? overrides->model : description->model;
        (void)snprintf(point.model, sizeof point.model, "%s", model_words[model]);
        bool estimates = overrides->has_estimates && overrides->estimates;
        strcpy(point.tail, estimates ? "estimate" : "black");
        scene_description_free(description);
        free(compiled);
        if (plan_grid(measure, point) != STATUS_DONE || plan_tails(measure, point) != STATUS_DONE ||
            plan_errors(measure, point) != STATUS_DONE ||
            plan_star(measure, point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* ---- points.csv ----------------------------------------------------------------------------- */

static const char head[] =
    "scene,arithmetic,depth,threshold,width,height,colour,model,tail,error,rays,shadow_rays,nodes,"
    "solid_tests,leaked_rays,port_writes,seconds,percent_wrong,percent_apart,largest_error,rmse,"
    "psnr,"
    "delta_e_mean,delta_e_999,scene_digest\n";

void measure_write_head(FILE *file) {
    (void)fputs(head, file);
}

const struct measure_scene *measure_scene_of(const struct measure *measure, const char *name) {
    for (size_t i = 0; i < measure->scene_count; i++) {
        if (strcmp(measure->scenes[i].name, name) == 0) {
            return &measure->scenes[i];
        }
    }
    return NULL;
}

void measure_write_point(const struct measure *measure, FILE *file,
                         const struct measure_point *point) {
    const struct measure_scene *scene = measure_scene_of(measure, point->scene);
    char key[MEASURE_KEY_SIZE];
    measure_key(point, key);
    (void)fprintf(file,
                  "%s,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%" PRIu64
                  ",%.6f,%.6f,%.6f,%u,%.6f,%.4f,%.6f,%.6f,%s\n",
                  key, point->events.rays, point->events.shadow_rays, point->events.nodes,
                  point->events.solid_tests, point->leaked_rays, point->port_writes, point->seconds,
                  point->wrong, point->apart, point->largest, point->rmse, point->psnr,
                  point->colour_mean, point->colour_high, scene != NULL ? scene->digest : "");
}

/* Reads what stands behind the key. */
static bool read_results(const char *text, struct measure_point *point,
                         char digest[SCENE_DIGEST_SIZE]) {
    char end;
    return sscanf(text,
                  ",%" SCNu64 ",%" SCNu64 ",%" SCNu64 ",%" SCNu64 ",%" SCNu64 ",%" SCNu64
                  ",%lf,%lf,%lf,%u,%lf,%lf,%lf,%lf,%16[0-9a-f]%c",
                  &point->events.rays, &point->events.shadow_rays, &point->events.nodes,
                  &point->events.solid_tests, &point->leaked_rays, &point->port_writes,
                  &point->seconds, &point->wrong, &point->apart, &point->largest, &point->rmse,
                  &point->psnr, &point->colour_mean, &point->colour_high, digest, &end) == 16 &&
           end == '\n';
}

/* A line that was cut off, or of a point that is not asked for any more, is passed over. NULL, or
 * the name of the line's scene where that is another one by now. */
static const char *take_line(struct measure *measure, const char *line) {
    char key[MEASURE_KEY_SIZE], digest[SCENE_DIGEST_SIZE];
    for (size_t i = 0; i < measure->points.count; i++) {
        struct measure_point *point = &measure->points.points[i];
        measure_key(point, key);
        size_t length = strlen(key);
        if (!point->is_done && strncmp(line, key, length) == 0 && line[length] == ',') {
            point->is_done = read_results(line + length, point, digest);
            measure->kept += point->is_done;
            const struct measure_scene *scene = measure_scene_of(measure, point->scene);
            bool is_other = point->is_done && scene != NULL && strcmp(digest, scene->digest) != 0;
            return is_other ? point->scene : NULL;
        }
    }
    return NULL;
}

int measure_resume(struct measure *measure) {
    char path[LINE_SIZE], line[LINE_SIZE];
    (void)snprintf(path, sizeof path, "%s/points.csv", measure->folder);
    FILE *file = fopen(path, "r");
    if (file == NULL && errno == ENOENT) {
        return STATUS_DONE;
    }
    if (file == NULL) {
        complain("%s: cannot be read: %s", path, strerror(errno));
        return STATUS_FAILED;
    }
    bool is_ours = fgets(line, sizeof line, file) != NULL && strcmp(line, head) == 0;
    const char *changed = NULL;
    while (is_ours && changed == NULL && fgets(line, sizeof line, file) != NULL) {
        changed = take_line(measure, line);
    }
    (void)fclose(file);
    if (changed != NULL) {
        return bad_input("%s: its points of \"%s\" are of that scene as it was before it was "
                         "changed; allowed is: another -o DIR, or one without points.csv",
                         path, changed);
    }
    return is_ours ? STATUS_DONE
                   : bad_input("%s: does not begin as this version's points do; allowed is: "
                               "another -o DIR, or one without points.csv",
                               path);
}
