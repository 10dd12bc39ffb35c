/* SPDX-License-Identifier: MIT */
/* Reads a scene file's text: the tree of values becomes a checked scene_description. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "board_ports.h"
#include "scene/assign.h"
#include "scene/keys.h"
#include "scene/overrides.h"

enum { WIDTH_MOST = BOARD_WIDTH, HEIGHT_MOST = BOARD_HEIGHT, TEXT_MOST = 64 * 1024 * 1024 };

/* A light may be many times white, for scenes in which light fades with the distance. */
static const struct scene_range light_levels = {0, 32767, NULL};
static const struct scene_range degrees = {1, 170, NULL};
static const struct scene_range distances = {0, 1e9, "length, or 0"};
static const struct scene_range nanometres = {380, 780, NULL};
static const struct scene_range pixels = {1, WIDTH_MOST, NULL};
static const struct scene_range depths = {0, SCENE_DEPTH_MOST, NULL};
static const struct scene_range versions = {1, 1, NULL};
static const struct scene_range any_number = {0, INFINITY, NULL};
static const struct scene_range one_or_more = {1, INFINITY, NULL};

/* The spectral primaries of the CIE 1931 RGB system, in nm. */
static const double CIE_PRIMARIES[3] = {700.0, 546.1, 435.8};

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* ---- Camera, lights, attenuation ------------------------------------------------------------- */

static const struct scene_camera camera_defaults = {.up = {0, 0, 1}, .field_of_view = 40};
static const struct scene_key camera_rows[] = {
    {NUMBERS_KEY("eye", scene_camera, eye, 3, RANGE_COORDINATE), .is_required = true,
     .noun = "point", .meaning = "the viewpoint"},
    {NUMBERS_KEY("look_at", scene_camera, look_at, 3, RANGE_COORDINATE), .is_required = true,
     .noun = "point", .meaning = "what is in the middle of the picture; not the eye"},
    {NUMBERS_KEY("up", scene_camera, up, 3, RANGE_COORDINATE), .noun = "direction of any length",
     .meaning = "upwards in the picture; neither 0 nor parallel to the view"},
    {NUMBER_KEY("field_of_view", scene_camera, field_of_view, degrees), .noun = "degrees",
     .meaning = "from the picture's left edge to its right one. Pixels are square"}};
const struct scene_keys scene_camera_keys = SCENE_KEYS("camera", camera_rows, &camera_defaults);

static void read_camera(struct scene_reader *reader, const struct scene_value *group) {
    const struct scene_scope scope = {reader, group, scene_camera_keys.what};
    struct scene_camera camera = camera_defaults;
    double view[3], across[3];
    camera.line = group->at.line;
    if (!scene_read_keys(&scope, &scene_camera_keys, &camera)) {
        return;
    }
    reader->scene->camera = camera;
    for (int i = 0; i < 3; i++) {
        view[i] = camera.look_at[i] - camera.eye[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across[i] = view[j] * camera.up[k] - view[k] * camera.up[j];
    }
    if (length_of(view) < RANGE_LENGTH.least) {
        (void)scene_fail(reader, scene_place_of(group, "look_at"),
                         "'look_at' of the camera is where its 'eye' is: they have to differ");
    } else if (length_of(camera.up) < RANGE_LENGTH.least) {
        (void)scene_fail(reader, scene_place_of(group, "up"),
                         "'up' of the camera is zero: it needs a direction, such as [0, 0, 1]");
    } else if (length_of(across) < 1e-6 * length_of(view) * length_of(camera.up)) {
        (void)scene_fail(reader, scene_place_of(group, "up"),
                         "the camera looks along 'up' ([%.10g, %.10g, %.10g]): give an 'up' that "
                         "is not parallel to the way from 'eye' to 'look_at'",
                         camera.up[0], camera.up[1], camera.up[2]);
    }
}

static const struct scene_light light_defaults = {.colour = {255, 255, 255}};
static const struct scene_key light_rows[] = {
    {NUMBERS_KEY("position", scene_light, position, 3, RANGE_COORDINATE), .noun = "point",
     .fallback = "", .meaning = "of a point light"},
    {NUMBERS_KEY("direction", scene_light, direction, 3, RANGE_COORDINATE),
     .noun = "direction of any length, not 0", .fallback = "",
     .meaning = "of parallel light: the way that the light goes, so `[0, 0, -1]` comes from above"},
    {NUMBERS_KEY("colour", scene_light, colour, 3, light_levels), .noun = "colour",
     .meaning = "Ip. 0: no light"}};
const struct scene_keys scene_light_keys = SCENE_KEYS("light", light_rows, &light_defaults);

static void read_light(struct scene_reader *reader, const struct scene_value *group,
                       struct scene_light *light) {
    const struct scene_scope scope = {reader, group, scene_light_keys.what};
    *light = light_defaults;
    light->line = group->at.line;
    if (!scene_read_keys(&scope, &scene_light_keys, light)) {
        return;
    }
    const double length = length_of(light->direction);
    light->parallel = value_member(group, "direction") != NULL;
    if (light->parallel == (value_member(group, "position") != NULL)) {
        (void)scene_fail(reader, group->at,
                         "a light needs either 'position' (of a point light) or 'direction' (of "
                         "parallel light): this one has %s",
                         light->parallel ? "both" : "none");
    } else if (light->parallel && length < RANGE_LENGTH.least) {
        (void)scene_fail(reader, scene_place_of(group, "direction"),
                         "'direction' of the light is zero: it needs a direction, such as "
                         "[0, 0, -1] for light from above");
    }
    for (int i = 0; light->parallel && i < 3; i++) {
        light->direction[i] /= length;
    }
}

static void read_lights(struct scene_reader *reader, const struct scene_value *list) {
    struct scene_light *lights = scene_allocate(reader, list->count, sizeof *lights);
    for (size_t i = 0; lights != NULL && i < list->count; i++) {
        read_light(reader, &list->members[i], &lights[i]);
        reader->scene->light_count = i + 1;
    }
    reader->scene->lights = lights;
}

static const struct scene_key attenuation_rows[] = {
    {NUMBER_KEY("constant", scene_description, attenuation_constant, distances),
     .is_required = true, .meaning = "C of C + D, in the file's unit"}};
const struct scene_keys scene_attenuation_keys = SCENE_KEYS("attenuation", attenuation_rows, NULL);

/* ---- The scene ------------------------------------------------------------------------------- */

/* The scene and what of it is not yet as the description has it. */
struct read_scene {
    struct scene_description scene;
    const char *title;
    int version, model, highlight, mixing, colour;
};

static void read_size(const struct scene_scope *scope, const struct scene_value *value,
                      void *into) {
    struct scene_description *scene = &((struct read_scene *)into)->scene;
    double size[2];
    if (!scene_read_numbers(scope, "size", value, &pixels, 2, size)) {
        return;
    }
    if (size[1] > HEIGHT_MOST || floor(size[0]) != size[0] || floor(size[1]) != size[1]) {
        (void)scene_fail(scope->reader, value->at,
                         "'size' of the scene is %.10g x %.10g: whole numbers of pixels, up to "
                         "%d x %d, are allowed",
                         size[0], size[1], WIDTH_MOST, HEIGHT_MOST);
        return;
    }
    scene->width = (int)size[0];
    scene->height = (int)size[1];
}

static void read_wavelengths(const struct scene_scope *scope, const struct scene_value *value,
                             void *into) {
    (void)into;
    (void)scene_read_numbers(scope, "wavelengths", value, &nanometres, 3,
                             scope->reader->wavelengths);
}

static const char *const models[] = {"simple", "fresnel", "wavelength", NULL};
static const char *const highlights[] = {"phong", "blinn", NULL};
static const char *const mixings[] = {"additive", "filter", NULL};
static const char *const colours[] = {"full",   "dither", "exposures", "bits:1", "bits:2", "bits:3",
                                      "bits:4", "bits:5", "bits:6",    "bits:7", "bits:8", NULL};

static const struct read_scene scene_defaults = {
    .scene = {.width = 320, .height = 200, .depth = 10, .threshold = 1.0 / 4096, .seed = 1},
    .title = "",
    .model = MODEL_FRESNEL};

static const struct scene_key scene_rows[] = {
    {WHOLE_KEY("version", read_scene, version, versions), .is_required = true,
     .meaning = "of this format"},
    {KEY_AT("title", KEY_TEXT, read_scene, title),
     .meaning = "one sentence; `superframe scenes` shows it"},
    {OTHER_KEY("size", read_size), .noun = "2 whole numbers, up to 640 and 400",
     .fallback = "`[320, 200]`", .meaning = "width and height in pixels"},
    {WHOLE_KEY("depth", read_scene, scene.depth, depths),
     .meaning = "the paper's depth level N: how many reflections and refractions a path may have. "
                "0: the surfaces' own colours only"},
    {NUMBER_KEY("threshold", read_scene, scene.threshold, RANGE_SHARE), .fallback = "1/4096",
     .meaning = "the product of reflectances and transmittances under which a branch ends. 0: only "
                "`depth` ends it"},
    {KEY_AT("model", KEY_WORD, read_scene, model), .words = models,
     .meaning = "Table 1 (a), (b), (c); (d) is the material's `absorption`"},
    {KEY_AT("highlight", KEY_WORD, read_scene, highlight), .words = highlights,
     .meaning = "the highlight by α, to the mirror direction, or by β, between normal and half-way "
                "direction"},
    {KEY_AT("mixing", KEY_WORD, read_scene, mixing), .words = mixings,
     .meaning = "`additive`: intensities add up as in Eq. (3). `filter`: a transparent material "
                "adds nothing of its own; going into it multiplies by colour/255, so that Z like "
                "media pass T^Z"},
    {KEY_AT("colour", KEY_WORD, read_scene, colour), .words = colours,
     .noun = "`\"full\"`, `\"bits:1\"` to `\"bits:8\"`, `\"dither\"`, `\"exposures\"`",
     .meaning = "256 levels; the upper bits only; 8 colours by a random dither; 8 pictures of a "
                "multiple exposure"},
    {NUMBERS_KEY("background", read_scene, scene.background, 3, RANGE_COLOUR), .noun = "colour",
     .meaning = "what a ray brings that leaves the scene"},
    {NUMBERS_KEY("ambient", read_scene, scene.ambient, 3, RANGE_COLOUR), .noun = "colour",
     .meaning = "Ia of Eq. (1). 0: ambient light only where a material has its own"},
    {KEY_AT("attenuation", KEY_GROUP, read_scene, scene), .fallback = "left out",
     .meaning = "divides a light's part by C + D (below); left out: by 1"},
    {NUMBER_KEY("weld", read_scene, scene.weld, distances),
     .noun = "length, up to 1/32768 of the scene",
     .meaning = "faces that are nearer than this are one: for numbers that were rounded before "
                "they came into the file"},
    {NUMBER_KEY("world", read_scene, scene.world, distances), .fallback = "as far as is needed",
     .meaning =
         "how far from the scene's middle what has no end goes on, at least. A larger world puts "
         "its visible end nearer to the horizon, and makes all else coarser in `fx` and "
         "`f32`"},
    {KEY_AT("camera", KEY_GROUP, read_scene, scene), .is_required = true, .meaning = "below"},
    {KEY_AT("lights", KEY_LIST, read_scene, scene), .range = &any_number, .fallback = "none",
     .noun = "list of groups", .meaning = "below"},
    {OTHER_KEY("wavelengths", read_wavelengths), .noun = "3 numbers, 380..780 nm",
     .fallback = "`(700, 546.1, 435.8)`",
     .meaning = "of R, G, B, for `cauchy`; the default are the spectral primaries of the CIE 1931 "
                "RGB system"},
    {KEY_AT("materials", KEY_GROUP, read_scene, scene), .is_required = true,
     .noun = "group of groups, 1 or more", .meaning = "below"},
    {KEY_AT("parts", KEY_LIST, read_scene, scene), .range = &any_number, .fallback = "none",
     .noun = "list of groups", .meaning = "named solids, below"},
    {KEY_AT("objects", KEY_LIST, read_scene, scene), .range = &one_or_more, .is_required = true,
     .noun = "list of groups, 1 or more", .meaning = "below"}};
const struct scene_keys scene_top_keys = SCENE_KEYS("scene", scene_rows, &scene_defaults);

static void read_settings(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_scope scope = {reader, root, scene_top_keys.what};
    struct read_scene read = scene_defaults;
    enum { FIRST_BITS = 3 };
    static const enum scene_colour kinds[FIRST_BITS] = {COLOUR_FULL, COLOUR_DITHER,
                                                        COLOUR_EXPOSURES};
    read.scene.memory = reader->scene->memory;
    (void)scene_read_keys(&scope, &scene_top_keys, &read);
    *reader->scene = read.scene;
    reader->scene->model = (enum scene_model)read.model;
    reader->scene->highlight = (enum scene_highlight)read.highlight;
    reader->scene->mixing = (enum scene_mixing)read.mixing;
    reader->scene->colour = read.colour < FIRST_BITS ? kinds[read.colour] : COLOUR_BITS;
    reader->scene->colour_bits = read.colour < FIRST_BITS ? 0 : read.colour - FIRST_BITS + 1;
    reader->scene->path = scene_copy(reader, reader->path);
    reader->scene->title = scene_copy(reader, read.title);
}

static void read_sections(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_value *camera = scene_find_group(root, "camera");
    const struct scene_value *lights = scene_find_list(root, "lights");
    const struct scene_scope fading = {reader, scene_find_group(root, "attenuation"),
                                       scene_attenuation_keys.what};
    reader->scene->has_attenuation = fading.group != NULL;
    if (fading.group != NULL) {
        (void)scene_read_keys(&fading, &scene_attenuation_keys, reader->scene);
    }
    if (camera != NULL) {
        read_camera(reader, camera);
    }
    if (lights != NULL) {
        read_lights(reader, lights);
    }
    scene_read_materials(reader, root);
    scene_read_parts(reader, root);
    scene_read_objects(reader, root);
}

/* Checks what no token can hold. */
static bool check_bytes(struct scene_reader *reader, const char *text, size_t length) {
    struct scene_place at = {1, 1};
    if (length > TEXT_MOST) {
        return scene_fail(reader, at, "a scene of %zu bytes is too large: at most %d are allowed",
                          length, TEXT_MOST);
    }
    for (size_t i = 0; i < length; i++, at.column++) {
        if (text[i] == '\0') {
            return scene_fail(reader, at, "a NUL byte: a scene is plain text");
        }
        if (text[i] == '\n') {
            at.line++;
            at.column = 0;
        }
    }
    return true;
}

static void read_text(struct scene_reader *reader, const char *text, size_t length,
                      const struct scene_overrides *overrides) {
    struct scene_value root;
    if (!check_bytes(reader, text, length)) {
        return;
    }
    scene_parse(reader, text, length, &root);
    for (unsigned i = 0; i < overrides->set_count; i++) {
        (void)scene_assign(reader, &root, overrides->sets[i]);
    }
    read_settings(reader, &root);
    read_sections(reader, &root);
}

/* Copies a text and ends it by NUL; some editors' byte order mark becomes blanks. */
static char *copy_text(const char *text, size_t length) {
    char *copy = malloc(length + 1);
    if (copy != NULL) {
        memcpy(copy, text, length);
        copy[length] = '\0';
        if (length >= 3 && memcmp(copy, "\xEF\xBB\xBF", 3) == 0) {
            memset(copy, ' ', 3);
        }
    }
    return copy;
}

struct scene_description *scene_description_read_with(const char *path, const char *text,
                                                      size_t length,
                                                      const struct scene_overrides *overrides,
                                                      struct scene_error *error) {
    struct scene_reader *reader = calloc(1, sizeof *reader);
    struct scene_description *scene = calloc(1, sizeof *scene);
    char *copy = copy_text(text, length);
    if (error != NULL) {
        error->text[0] = '\0';
    }
    if (reader == NULL || scene == NULL || copy == NULL) {
        if (error != NULL) {
            (void)snprintf(error->text, sizeof error->text,
                           "%.200s: not enough memory to read the scene", path);
        }
        free(scene);
        scene = NULL;
    } else {
        reader->path = path;
        reader->scene = scene;
        memcpy(reader->wavelengths, CIE_PRIMARIES, sizeof reader->wavelengths);
        read_text(reader, copy, length, overrides);
        if (reader->refusal_count > 0) {
            if (error != NULL) {
                scene_report(reader, copy, error);
            }
            scene_description_free(scene);
            scene = NULL;
        }
        memory_free(&reader->memory);
        free(reader->facts);
    }
    free(reader);
    free(copy);
    return scene;
}

struct scene_description *scene_description_read(const char *path, const char *text, size_t length,
                                                 struct scene_error *error) {
    static const struct scene_overrides none;
    return scene_description_read_with(path, text, length, &none, error);
}
