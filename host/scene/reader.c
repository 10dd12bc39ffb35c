/* SPDX-License-Identifier: MIT */
/* Reads a scene file's text: the tree of values becomes a checked scene_description. */
#include "scene/reader_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "board_ports.h"
#include "scene/assign.h"
#include "scene/overrides.h"
#include "scene/values.h"

enum { SCENE_VERSION = 1, WIDTH_MOST = BOARD_WIDTH, HEIGHT_MOST = BOARD_HEIGHT };

/* A light may be many times white, for scenes in which light fades with the distance. */
static const struct scene_range RANGE_LIGHT = {0, 32767};
static const struct scene_range RANGE_FIELD_OF_VIEW = {1, 170};
static const struct scene_range RANGE_WELD = {0, 1e9};
static const struct scene_range RANGE_WAVELENGTH = {380, 780};

/* The spectral primaries of the CIE 1931 RGB system, in nm. */
static const double CIE_PRIMARIES[3] = {700.0, 546.1, 435.8};

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static bool read_camera(struct scene_reader *reader, const struct scene_scope *top) {
    static const char *const keys[] = {"eye", "look_at", "up", "field_of_view", NULL};
    struct scene_scope scope = {reader, NULL, "camera"};
    if (!scope_group(top, "camera", REQUIRED, &scope.group) || !scope_check_keys(&scope, keys)) {
        return false;
    }
    struct scene_camera camera = {.line = scope.group->line, .up = {0, 0, 1}, .field_of_view = 40};
    if (!scope_numbers(&scope, "eye", REQUIRED, RANGE_COORDINATE, 3, camera.eye) ||
        !scope_numbers(&scope, "look_at", REQUIRED, RANGE_COORDINATE, 3, camera.look_at) ||
        !scope_numbers(&scope, "up", OPTIONAL, RANGE_COORDINATE, 3, camera.up) ||
        !scope_number(&scope, "field_of_view", OPTIONAL, RANGE_FIELD_OF_VIEW,
                      &camera.field_of_view)) {
        return false;
    }
    double view[3], across[3];
    for (int i = 0; i < 3; i++) {
        view[i] = camera.look_at[i] - camera.eye[i];
    }
    if (length_of(view) < RANGE_LENGTH.least) {
        return scene_fail(reader, scope_line(&scope, "look_at"),
                          "'look_at' of the camera is where its 'eye' is: they have to differ");
    }
    if (length_of(camera.up) < RANGE_LENGTH.least) {
        return scene_fail(reader, scope_line(&scope, "up"),
                          "'up' of the camera is zero: it needs a direction, such as [0, 0, 1]");
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = view[j] * camera.up[k] - view[k] * camera.up[j];
    }
    if (length_of(across) < 1e-6 * length_of(view) * length_of(camera.up)) {
        return scene_fail(reader, scope_line(&scope, "up"),
                          "the camera looks along 'up' ([%.10g, %.10g, %.10g]): give an 'up' that "
                          "is not parallel to the way from 'eye' to 'look_at'",
                          camera.up[0], camera.up[1], camera.up[2]);
    }
    reader->scene->camera = camera;
    return true;
}

static bool read_light(struct scene_reader *reader, const struct scene_value *group,
                       struct scene_light *light) {
    static const char *const keys[] = {"position", "direction", "colour", NULL};
    struct scene_scope scope = {reader, group, "light"};
    *light = (struct scene_light){.line = group->line, .colour = {255, 255, 255}};
    if (!scene_is_group(reader, group, "light") || !scope_check_keys(&scope, keys)) {
        return false;
    }
    light->parallel = scope_has(&scope, "direction");
    if (light->parallel == scope_has(&scope, "position")) {
        return scene_fail(reader, light->line,
                          "a light needs either 'position' (of a point light) or 'direction' (of "
                          "parallel light): this one has %s",
                          light->parallel ? "both" : "none");
    }
    if (!scope_numbers(&scope, "position", OPTIONAL, RANGE_COORDINATE, 3, light->position) ||
        !scope_numbers(&scope, "direction", OPTIONAL, RANGE_COORDINATE, 3, light->direction) ||
        !scope_numbers(&scope, "colour", OPTIONAL, RANGE_LIGHT, 3, light->colour)) {
        return false;
    }
    double length = length_of(light->direction);
    if (light->parallel && length < RANGE_LENGTH.least) {
        return scene_fail(reader, scope_line(&scope, "direction"),
                          "'direction' of the light is zero: it needs a direction, such as "
                          "[0, 0, -1] for light from above");
    }
    for (int i = 0; light->parallel && i < 3; i++) {
        light->direction[i] /= length;
    }
    return true;
}

static bool read_lights(struct scene_reader *reader, const struct scene_scope *top) {
    const struct scene_value *list;
    if (!scope_list(top, "lights", OPTIONAL, 0, SCENE_LIGHTS_MOST, &list)) {
        return false;
    }
    size_t count = list ? list->count : 0;
    struct scene_light *lights = scene_allocate(reader, count, sizeof *lights);
    if (!lights) {
        return false;
    }
    reader->scene->lights = lights;
    reader->scene->light_count = count;
    for (size_t i = 0; i < count; i++) {
        if (!read_light(reader, &list->members[i], &lights[i])) {
            return false;
        }
    }
    return true;
}

static bool read_attenuation(struct scene_reader *reader, const struct scene_scope *top) {
    static const char *const keys[] = {"constant", NULL};
    static const struct scene_range range = {0, 1e9};
    struct scene_scope scope = {reader, NULL, "attenuation"};
    if (!scope_group(top, "attenuation", OPTIONAL, &scope.group)) {
        return false;
    }
    reader->scene->has_attenuation = scope.group != NULL;
    return !scope.group ||
           (scope_check_keys(&scope, keys) && scope_number(&scope, "constant", REQUIRED, range,
                                                           &reader->scene->attenuation_constant));
}

/* Reads `colour`: full, bits:1 to bits:8, dither or exposures. */
static bool read_colour(const struct scene_scope *top) {
    static const char *const words[] = {"full",   "dither", "exposures", "bits:1",
                                        "bits:2", "bits:3", "bits:4",    "bits:5",
                                        "bits:6", "bits:7", "bits:8",    NULL};
    static const enum scene_colour colours[] = {COLOUR_FULL, COLOUR_DITHER, COLOUR_EXPOSURES};
    enum { FIRST_BITS = 3 };
    struct scene_description *scene = top->reader->scene;
    int index = 0;
    if (!scope_choice(top, "colour", words, &index)) {
        return false;
    }
    scene->colour = index >= FIRST_BITS ? COLOUR_BITS : colours[index];
    scene->colour_bits = index >= FIRST_BITS ? index - FIRST_BITS + 1 : 0;
    return true;
}

static bool read_size(const struct scene_scope *top) {
    double size[2] = {320, 200};
    struct scene_range whole = {1, WIDTH_MOST};
    if (!scope_numbers(top, "size", OPTIONAL, whole, 2, size)) {
        return false;
    }
    if (size[1] > HEIGHT_MOST || floor(size[0]) != size[0] || floor(size[1]) != size[1]) {
        return scene_fail(top->reader, scope_line(top, "size"),
                          "'size' of the scene is %.10g x %.10g: whole numbers of pixels, up to "
                          "%d x %d, are allowed",
                          size[0], size[1], WIDTH_MOST, HEIGHT_MOST);
    }
    top->reader->scene->width = (int)size[0];
    top->reader->scene->height = (int)size[1];
    return true;
}

/* Reads the choices of the optical model, of highlights and of mixing. */
static bool read_choices(const struct scene_scope *top) {
    static const char *const models[] = {"simple", "fresnel", "wavelength", NULL};
    static const char *const highlights[] = {"phong", "blinn", NULL};
    static const char *const mixings[] = {"additive", "filter", NULL};
    struct scene_description *scene = top->reader->scene;
    int model = MODEL_FRESNEL, highlight = HIGHLIGHT_PHONG, mixing = MIXING_ADDITIVE;
    if (!scope_choice(top, "model", models, &model) ||
        !scope_choice(top, "highlight", highlights, &highlight) ||
        !scope_choice(top, "mixing", mixings, &mixing)) {
        return false;
    }
    scene->model = (enum scene_model)model;
    scene->highlight = (enum scene_highlight)highlight;
    scene->mixing = (enum scene_mixing)mixing;
    return true;
}

static bool read_settings(const struct scene_scope *top) {
    static const char *const keys[] = {
        "version",     "title",  "size",      "depth",      "threshold",   "model",  "highlight",
        "mixing",      "colour", "ambient",   "background", "attenuation", "camera", "lights",
        "wavelengths", "weld",   "materials", "parts",      "objects",     NULL};
    struct scene_reader *reader = top->reader;
    struct scene_description *scene = reader->scene;
    int version = SCENE_VERSION;
    const char *title = "";
    if (!scope_check_keys(top, keys) ||
        !scope_integer(top, "version", REQUIRED, SCENE_VERSION, SCENE_VERSION, &version) ||
        !scope_string(top, "title", OPTIONAL, &title) || !read_size(top) ||
        !scope_integer(top, "depth", OPTIONAL, 0, SCENE_DEPTH_MOST, &scene->depth) ||
        !scope_number(top, "threshold", OPTIONAL, RANGE_SHARE, &scene->threshold) ||
        !read_choices(top) || !read_colour(top) ||
        !scope_numbers(top, "background", OPTIONAL, RANGE_COLOUR, 3, scene->background) ||
        !scope_numbers(top, "ambient", OPTIONAL, RANGE_COLOUR, 3, scene->ambient) ||
        !scope_number(top, "weld", OPTIONAL, RANGE_WELD, &scene->weld) ||
        !scope_numbers(top, "wavelengths", OPTIONAL, RANGE_WAVELENGTH, 3, reader->wavelengths)) {
        return false;
    }
    scene->title = scene_copy(reader, title);
    return scene->title != NULL;
}

static bool read_all(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_scope top = {reader, root, "scene"};
    return read_settings(&top) && read_attenuation(reader, &top) && read_camera(reader, &top) &&
           read_lights(reader, &top) && scene_read_materials(reader, root) &&
           scene_read_parts(reader, root) && scene_read_objects(reader, root);
}

/* Makes a description with the defaults of depth, seed, threshold and wavelengths. Other defaults
 * stand where their keys are read. */
static struct scene_description *make_description(struct scene_reader *reader) {
    struct scene_description *scene = scene_allocate(reader, 1, sizeof *scene);
    if (scene) {
        scene->depth = 10;
        scene->seed = 1;
        scene->threshold = 1.0 / 4096;
        scene->path = scene_copy(reader, reader->path);
        memcpy(reader->wavelengths, CIE_PRIMARIES, sizeof reader->wavelengths);
    }
    return scene;
}

static bool read_text(struct scene_reader *reader, const char *text, size_t length,
                      const struct scene_overrides *overrides) {
    struct scene_value root;
    bool is_read = scene_parse(reader, text, length, &root);
    for (unsigned i = 0; is_read && i < overrides->set_count; i++) {
        is_read = scene_assign(reader, &root, overrides->sets[i]);
    }
    is_read = is_read && read_all(reader, &root);
    memory_free(&reader->memory);
    return is_read;
}

struct scene_description *scene_description_read_with(const char *path, const char *text,
                                                      size_t length,
                                                      const struct scene_overrides *overrides,
                                                      struct scene_error *error) {
    struct scene_error unread;
    struct scene_reader reader = {.path = path, .error = error ? error : &unread};
    reader.error->text[0] = '\0';
    reader.scene = make_description(&reader);
    if (!reader.scene) {
        return NULL;
    }
    bool sound = reader.scene->path && read_text(&reader, text, length, overrides);
    free(reader.parts);
    if (!sound) {
        scene_description_free(reader.scene);
        return NULL;
    }
    return reader.scene;
}

struct scene_description *scene_description_read(const char *path, const char *text, size_t length,
                                                 struct scene_error *error) {
    static const struct scene_overrides none;
    return scene_description_read_with(path, text, length, &none, error);
}
