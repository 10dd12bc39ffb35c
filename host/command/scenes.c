/* SPDX-License-Identifier: MIT */
/* superframe scenes: the built-in scenes, one a line. */
#include <stdio.h>

#include "command/command.h"
#include "scene/builtin.h"
#include "scene/load.h"

static int run_scenes(const struct options *options) {
    (void)options;
    for (size_t i = 0; i < builtin_scene_count; i++) {
        struct scene_error error;
        struct scene_description *scene = load_scene(builtin_scenes[i].name, &error);
        if (scene == NULL) {
            return bad_input("%s", error.text);
        }
        (void)printf("%s\t%s\n", builtin_scenes[i].name, scene->title);
        scene_description_free(scene);
    }
    return STATUS_DONE;
}

static const struct option_group *const groups[] = {NULL};
static const char *const examples[] = {"scenes", "scenes | cut -f 1", NULL};

const struct command command_scenes = {.name = "scenes",
                                       .operands = "",
                                       .summary =
                                           "List the built-in scenes: name, tab, one sentence.",
                                       .least = 0,
                                       .most = 0,
                                       .kind = OPERANDS_NONE,
                                       .groups = groups,
                                       .examples = examples,
                                       .run = run_scenes};
