/* SPDX-License-Identifier: MIT */
/* superframe measure: speed against accuracy, as tables, plots and a report. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "command.h"
#include "load_scene.h"
#include "measure.h"

enum { PATH_SIZE = 1024, FOLDER_MODE = 0777 };

static const char *const default_scenes[] = {"fig3", "fig4a", "fig5"};

FILE *measure_create(const struct measure *measure, const char *name) {
    char path[PATH_SIZE];
    (void)snprintf(path, sizeof path, "%s/%s", measure->folder, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        complain("%s: cannot be written: %s", path, strerror(errno));
    }
    return file;
}

int measure_close(const struct measure *measure, FILE *file, const char *name) {
    bool is_written = ferror(file) == 0;
    is_written = fclose(file) == 0 && is_written;
    if (!is_written) {
        complain("%s/%s: cannot be written: %s", measure->folder, name, strerror(errno));
    }
    return is_written ? STATUS_DONE : STATUS_FAILED;
}

double measure_predict(const struct measure *measure, const struct measure_point *point,
                       const struct cost_target *target) {
    struct cost_work work = {point->events, {1, 0, 0, 0, 0}, point->port_writes};
    for (size_t i = 0; i < measure->scene_count; i++) {
        if (strcmp(measure->scenes[i].name, point->scene) == 0) {
            work.mix = measure->scenes[i].mix;
        }
    }
    return cost_seconds(target, point->arithmetic, &work);
}

static int take_scenes(struct measure *measure) {
    const struct options *options = measure->options;
    size_t count = (size_t)options->operand_count;
    bool are_given = count > 0;
    count = are_given ? count : sizeof default_scenes / sizeof default_scenes[0];
    if (count > MEASURE_SCENES_MOST) {
        return bad_input("measure: %zu scenes; allowed are up to %d", count, MEASURE_SCENES_MOST);
    }
    for (size_t i = 0; i < count; i++) {
        struct measure_scene *scene = &measure->scenes[i];
        scene->operand = are_given ? options->operands[i] : default_scenes[i];
        scene_short_name(scene->operand, scene->name, sizeof scene->name);
        if (strpbrk(scene->name, ",\"'\n") != NULL) {
            return bad_input("%s: allowed are: names without commas and quotes", scene->operand);
        }
        for (size_t j = 0; j < i; j++) {
            if (strcmp(measure->scenes[j].name, scene->name) == 0) {
                return bad_input("measure: two scenes are called \"%s\"; allowed are: names that "
                                 "differ",
                                 scene->name);
            }
        }
    }
    measure->scene_count = count;
    return STATUS_DONE;
}

static int make_folder(const struct measure *measure) {
    if (mkdir(measure->folder, FOLDER_MODE) != 0 && errno != EEXIST) {
        complain("%s: cannot be written: %s", measure->folder, strerror(errno));
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

int run_measure(const struct options *options) {
    static int (*const steps[])(struct measure *) = {measure_plan, measure_resume, measure_run,
                                                     measure_plot, measure_report};
    struct measure *measure = calloc(1, sizeof *measure);
    if (measure == NULL) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    measure->options = options;
    measure->folder = options->output;
    int status = take_scenes(measure);
    if (status == STATUS_DONE) {
        status = make_folder(measure);
    }
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](measure);
    }
    free(measure->points.points);
    free(measure);
    return status;
}
