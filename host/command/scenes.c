/* SPDX-License-Identifier: MIT */
/* superframe scenes: the built-in scenes, one a line. */
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "command/command.h"
#include "scene/builtin.h"
#include "scene/load.h"
#include "scene/reference.h"

/* Holds the options that `scenes` alone takes. */
struct scenes_options {
    struct options common;
    const char *printed; /* the scene whose text is printed; NULL: they are listed */
    bool keys;           /* the keys of scene files are printed instead */
};

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

/* Prints a built-in scene's text. */
static int print_text(const char *name) {
    for (size_t i = 0; i < builtin_scene_count; i++) {
        if (strcmp(builtin_scenes[i].name, name) == 0) {
            (void)fwrite(builtin_scenes[i].text, 1, builtin_scenes[i].length, stdout);
            return STATUS_DONE;
        }
    }
    return bad_input("scenes: no built-in scene \"%.100s\"; superframe scenes lists them", name);
}

static int run_scenes(const struct options *options) {
    const struct scenes_options *own = (const struct scenes_options *)options;
    if (own->printed != NULL) {
        return print_text(own->printed);
    }
    if (own->keys) {
        scene_print_reference(stdout);
        return STATUS_DONE;
    }
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

static bool check_scenes(const struct options *options, struct options_error *error) {
    const struct scenes_options *own = (const struct scenes_options *)options;
    return options->json + (own->printed != NULL) + own->keys <= 1 ||
           options_refuse(error, "--print, --keys and --json exclude each other; give one of them");
}

static const struct option_group group_own = {
    "Result", OPTION_ENTRIES({.name = "print",
                              .value = "NAME",
                              TEXT_IN(struct scenes_options, printed),
                              .allowed = "a built-in scene's name",
                              .help = "print the text of a built-in scene"},
                             {.name = "keys",
                              FLAG_IN(struct scenes_options, keys),
                              .help = "print the keys of scene files, with ranges and defaults"})};

const struct command command_scenes = {
    .name = "scenes",
    .operands = "",
    .summary = "List the built-in scenes: name, tab, one sentence.",
    .size = sizeof(struct scenes_options),
    .groups = OPTION_GROUPS(&group_own, &group_json),
    .examples = COMMAND_EXAMPLES("scenes", "scenes --print fig3 > my.scene"),
    .check = check_scenes,
    .run = run_scenes};
