/* SPDX-License-Identifier: MIT */
/* What a scene requires of an image of the firmware, as a feature_set.h and as assertions. */
#include "compiler/features.h"

#include <limits.h>
#include <stdbool.h>
#include <string.h>

#include "image.h"
#include "scene/description.h"

/* A constant of a feature_set.h, with what the scene needs of the constant. The constants come in
 * the order of firmware/features/; tests/targets/quick_test.sh holds the names against the files
 * there. */
struct feature {
    const char *name;
    int value; /* NOT_OF_FORM: an image with the scene's form of sets does not know the constant */
};

enum { FEATURES = 29, NOT_OF_FORM = -1 };

static bool has_rotation(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (scene->primitives[i].frame != COMPILED_FRAME_WORLD) {
            return true;
        }
    }
    return false;
}

static bool has_csg(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].length > 1) {
            return true;
        }
    }
    return false;
}

static bool has_point_light(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->light_count; i++) {
        if (!scene->lights[i].parallel) {
            return true;
        }
    }
    return false;
}

/* Tells whether paths go on somewhere, or whether what paths would bring counts where they end. */
static bool has_paths(const struct compiled_scene *scene) {
    return scene->has_branches && (scene->depth > 0 || scene->estimates);
}

/* Tells whether paths go through a transparent material. The air around, material 0, does not
 * count: its boundary with an opaque material is that material's. */
bool features_has_transparency(const struct compiled_scene *scene) {
    for (uint32_t i = 1; i < scene->material_count; i++) {
        if (scene->materials[i].transparent) {
            return has_paths(scene);
        }
    }
    return false;
}

static bool has_absorption(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->material_count; i++) {
        if (scene->materials[i].absorbs) {
            return true;
        }
    }
    return false;
}

bool features_has_dispersion(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->material_count; i++) {
        if (scene->materials[i].disperses) {
            return has_paths(scene);
        }
    }
    return false;
}

static bool has_tint(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->material_count; i++) {
        if (scene->materials[i].tints) {
            return has_paths(scene);
        }
    }
    return false;
}

uint32_t features_primitive_words(const struct compiled_scene *scene) {
    return scene->primitive_count > 32 ? (scene->primitive_count + 31) / 32 : 1;
}

/* Returns the depth level that an image must have room for: learning goes beyond the scene's own.
 */
static int depth_required(const struct compiled_scene *scene) {
    bool goes_beyond = scene->estimates && scene->error <= 0;
    int depth = scene->depth + (goes_beyond ? ESTIMATE_EVENTS : 0);
    return depth < SCENE_DEPTH_MOST ? depth : SCENE_DEPTH_MOST;
}

static void find_features(const struct compiled_scene *scene, struct feature features[FEATURES]) {
    const bool lists = !compiled_fits_bits(scene);
    const int nesting = scene->nesting < INT_MAX ? (int)scene->nesting : INT_MAX;
    const struct feature found[FEATURES] = {
        {"DEPTH", depth_required(scene)},
        {"WIDTH", scene->width},
        {"PRIMITIVE_WORDS", lists ? NOT_OF_FORM : (int)features_primitive_words(scene)},
        {"NESTING", lists ? nesting : NOT_OF_FORM},
        {"LEVELS", lists ? (int)scene->hierarchy.levels : NOT_OF_FORM},
        {"BOX", scene->box_count > 0},
        {"BALL", scene->ball_count > 0},
        {"POLYHEDRON", scene->polyhedron_count > 0},
        {"QUADRIC", scene->quadric_count > 0},
        {"ROTATION", has_rotation(scene)},
        {"CSG", has_csg(scene)},
        {"LIGHTS", scene->light_count > 0},
        {"POINT_LIGHTS", has_point_light(scene)},
        {"HIGHLIGHT_BLINN", scene->blinn},
        {"SHADOWS", scene->has_shadows},
        {"FADING", scene->fades},
        {"PATTERN", scene->pattern_count > 0},
        {"PATTERN_FACES", scene->pattern_face_count > 0},
        {"TRANSPARENCY", features_has_transparency(scene)},
        {"ABSORPTION", has_absorption(scene)},
        {"SIMPLE", scene->simple && has_paths(scene)},
        {"DISPERSION", features_has_dispersion(scene)},
        {"TINT", has_tint(scene)},
        {"FILTER", scene->filters},
        {"SPECULAR_TABLE", scene->specular_table_count > 0},
        {"ESTIMATE", scene->estimates && scene->has_branches},
        {"ACCURACY", scene->error > 0 && scene->has_branches},
        {"OBSERVER", 0},
        {"SHOW", scene->show != SHOW_FULL},
    };
    for (int i = 0; i < FEATURES; i++) {
        features[i] = found[i];
    }
}

void features_tell(const struct compiled_scene *scene,
                   void (*take)(void *context, const char *name, int value), void *context) {
    struct feature features[FEATURES];
    find_features(scene, features);
    for (int i = 0; i < FEATURES; i++) {
        if (features[i].value != NOT_OF_FORM) {
            take(context, features[i].name, features[i].value);
        }
    }
}

int features_emit(FILE *out, const struct compiled_scene *scene, const char *name) {
    struct feature features[FEATURES];
    find_features(scene, features);
    fprintf(out,
            "/* What the scene \"%s\" requires of an image; made by `superframe compile"
            " --minimal`. */\n",
            name);
    fprintf(out, "#ifndef SUPERFRAME_FEATURE_SET_H\n#define SUPERFRAME_FEATURE_SET_H\n\nenum {\n");
    for (int i = 0; i < FEATURES; i++) {
        if (features[i].value != NOT_OF_FORM) {
            fprintf(out, "    FEATURE_%s = %d%s\n", features[i].name, features[i].value,
                    i + 1 < FEATURES ? "," : "");
        }
    }
    fprintf(out, "};\n\n#include \"sets/%s/primitive_set.h\"\n\n#endif\n",
            compiled_fits_bits(scene) ? "bits" : "list");
    return ferror(out) ? -1 : 0;
}

void features_emit_assertions(FILE *out, const struct compiled_scene *scene) {
    struct feature features[FEATURES];
    find_features(scene, features);
    fprintf(out, "\n/* What an image must have to render this scene. */\n");
    for (int i = 0; i < FEATURES; i++) {
        if (features[i].value > 0) {
            fprintf(out, "typedef char image_lacks_FEATURE_%s[FEATURE_%s >= %d ? 1 : -1];\n",
                    features[i].name, features[i].name, features[i].value);
        }
    }
}
