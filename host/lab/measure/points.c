/* SPDX-License-Identifier: MIT */
/* The points of `superframe measure`: lists of them, and their lines in points.csv. */
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "lab/measure/measure.h"
#include "scene/load.h"

enum { LINE_SIZE = 1024 };

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

/* ---- points.csv ----------------------------------------------------------------------------- */

static const char head[] =
    "scene,arithmetic,depth,threshold,width,height,colour,model,tail,error,rays,shadow_rays,nodes,"
    "solid_tests,leaked_rays,port_writes,seconds,percent_wrong,percent_apart,largest_error,rmse,"
    "psnr,delta_e_mean,delta_e_999,scene_digest\n";

bool measure_write_head(FILE *file) {
    return fputs(head, file) >= 0 && fflush(file) == 0;
}

enum measure_beginning measure_read_head(FILE *file) {
    char line[sizeof head] = "";
    size_t length = fread(line, 1, sizeof head - 1, file);
    if (memcmp(line, head, length) != 0) {
        return MEASURE_FOREIGN;
    }
    return length == sizeof head - 1 ? MEASURE_BEGUN : MEASURE_EMPTY;
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

/* Reads what stands behind the key. Returns false where the line is not whole. */
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

/* Takes over one line of points.csv. A line that was cut off, or of a point not asked for any more,
 * is passed over. Returns NULL, or the name of the line's scene where its digest has changed
 * since. */
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
    const char *path = measure->points_path;
    char line[LINE_SIZE];
    FILE *file = fopen(path, "r");
    if (file == NULL && errno == ENOENT) {
        return STATUS_DONE;
    }
    if (file == NULL) {
        return failure("%s: cannot be read: %s", path, strerror(errno));
    }
    bool is_ours = measure_read_head(file) != MEASURE_FOREIGN;
    const char *changed = NULL;
    while (is_ours && changed == NULL && fgets(line, sizeof line, file) != NULL) {
        changed = take_line(measure, line);
    }
    (void)fclose(file);
    if (changed != NULL) {
        return bad_input("%s: its points of \"%s\" are of another scene (it was changed, or has "
                         "another --highlight or --seed); allowed is: another -o FOLDER, or one "
                         "without points.csv",
                         path, changed);
    }
    return is_ours ? STATUS_DONE
                   : bad_input("%s: does not begin as this version's points do; allowed is: "
                               "another -o FOLDER, or one without points.csv",
                               path);
}

/* ---- Predictions ---------------------------------------------------------------------------- */

double measure_predict(const struct measure *measure, const struct measure_point *point,
                       const struct cost_target *target) {
    const struct measure_scene *scene = measure_scene_of(measure, point->scene);
    const struct cost_work work = {point->events, scene->mix, point->port_writes};
    return cost_seconds(target, point->arithmetic, &work);
}
