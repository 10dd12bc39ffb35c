/* SPDX-License-Identifier: MIT */
/* superframe scenes: the built-in scenes, one a line. */
#include <stdio.h>

#include "base/json.h"
#include "command/command.h"
#include "scene/builtin.h"
#include "scene/load.h"

/* Prints a scene on a line, or as an entry of the list. */
static void print_scene(struct json *json, const char *name, const char *title, bool is_json) {
    if (!is_json) {
        (void)printf("%s\t%s\n", name, title);
        return;
    }
    json_begin_object(json, NULL);
    json_text(json, "name", name);
    json_text(json, "title", title);
    json_end_object(json);
}

static int run_scenes(const struct options *options) {
    struct json json = {.out = stdout};
    if (options->json) {
        json_begin_list(&json, NULL);
    }
    for (size_t i = 0; i < builtin_scene_count; i++) {
        struct scene_error error;
        struct scene_description *scene = load_scene(builtin_scenes[i].name, &error);
        if (scene == NULL) {
            return bad_input("%s", error.text);
        }
        print_scene(&json, builtin_scenes[i].name, scene->title, options->json);
        scene_description_free(scene);
    }
    if (options->json) {
        json_end_list(&json);
    }
    return STATUS_DONE;
}

static const struct option_group *const groups[] = {&group_json, NULL};
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
