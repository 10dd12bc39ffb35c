/* SPDX-License-Identifier: MIT */
/* superframe measure: speed against accuracy, as tables, plots and a report. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/path.h"
#include "command/command.h"
#include "lab/measure/measure.h"
#include "scene/load.h"

enum { FOLDER_MODE = 0777 };

static const char *const default_scenes[] = {"fig3", "fig4a", "fig5"};

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
        if (strpbrk(scene->name, ",\"'\n|<>&") != NULL) {
            return bad_input("%s: allowed are: names without commas, quotes, |, <, > and &",
                             scene->operand);
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

static int make_folder(struct measure *measure) {
    measure->points_path = path_join(measure->folder, "points.csv");
    if (measure->points_path == NULL) {
        return failure("out of memory");
    }
    if (mkdir(measure->folder, FOLDER_MODE) != 0 && errno != EEXIST) {
        return failure("%s: cannot be written: %s", measure->folder, strerror(errno));
    }
    return STATUS_DONE;
}

static int run_measure(const struct options *options) {
    static int (*const steps[])(struct measure *) = {take_scenes,    measure_plan,   make_folder,
                                                     measure_resume, measure_run,    measure_gather,
                                                     measure_plot,   measure_report, measure_print};
    struct measure *measure = calloc(1, sizeof *measure);
    if (measure == NULL) {
        return failure("out of memory");
    }
    measure->options = options;
    measure->folder = options->output;
    int status = STATUS_DONE;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](measure);
    }
    free(measure->settings.settings);
    free(measure->points.points);
    free(measure->points_path);
    free(measure);
    return status;
}

static const char *printed(const struct options *options) {
    return options->json ? "the settings and points" : NULL;
}

static bool check_measure(const struct options *options, struct options_error *error) {
    if (options->overrides.has_colour && options->overrides.colour == COLOUR_EXPOSURES) {
        return options_refuse(error, "measure: --colour exposures is not measured; allowed is: "
                                     "full, bits:1..bits:8 or dither");
    }
    return options->output != NULL || options_refuse(error, "measure: -o FOLDER is missing");
}

const struct command command_measure = {
    .name = "measure",
    COMMAND_OPERANDS("[SCENE...]", 0, 1000, OPERANDS_SCENES),
    .summary = "Measure speed against accuracy.",
    .groups = OPTION_GROUPS(&group_folder, &group_json, &group_measured, &group_jobs, &group_quiet),
    .examples = COMMAND_EXAMPLES("measure -o trade --jobs 2",
                                 "measure my.scene --arith fx --size 160x100 -o trade"),
    .printed = printed,
    .check = check_measure,
    .run = run_measure};
