/* SPDX-License-Identifier: MIT */
/* What a scene requires of the renderer, what it provably does not, and its ranges, in words. */
#include "compiler/requirements.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "compiler/features.h"

enum { LINE_WIDTH = 96 };

/* A list of words on lines that begin alike. */
struct words {
    FILE *out;
    int column;
};

static void print_word(struct words *words, const char *text) {
    int length = (int)strlen(text);
    if (words->column > 0 && words->column + length + 2 > LINE_WIDTH) {
        (void)fprintf(words->out, ",\n            ");
        words->column = 12;
    } else if (words->column > 0) {
        words->column += fprintf(words->out, ", ");
    } else {
        words->column = fprintf(words->out, "requires    ");
    }
    words->column += fprintf(words->out, "%s", text);
}

/* Prints a required feature's name as people write names. Features that are numbers are followed by
 * their value. */
static void take_feature(void *context, const char *name, int value) {
    static const char *const numbers[] = {"DEPTH", "WIDTH", "PRIMITIVE_WORDS", "NESTING", "LEVELS"};
    char text[64];
    size_t length = 0;
    if (value == 0) {
        return;
    }
    for (; length < sizeof text - 16 && name[length] != '\0'; length++) {
        text[length] = name[length] == '_' ? ' ' : (char)tolower((unsigned char)name[length]);
    }
    text[length] = '\0';
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (strcmp(name, numbers[i]) == 0) {
            (void)snprintf(text + length, sizeof text - length, " %d", value);
        }
    }
    print_word(context, text);
}

/* ---- Proofs --------------------------------------------------------------------------------- */

int requirements_nesting(const struct compiled_scene *scene) {
    int deepest = 0;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        uint32_t at = i;
        int depth = 0;
        while (scene->primitives[at].enclosure < scene->primitive_count &&
               (uint32_t)depth < scene->primitive_count) {
            at = scene->primitives[at].enclosure;
            depth++;
        }
        deepest = depth > deepest ? depth : deepest;
    }
    return deepest;
}

bool requirements_total_reflection(const struct compiled_scene *scene) {
    bool refracts = features_has_transparency(scene) && !scene->simple;
    for (uint32_t i = 1; i < scene->material_count && refracts; i++) {
        if (scene->materials[i].transparent &&
            scene->materials[i].optical != scene->materials[0].optical) {
            return true;
        }
    }
    return false;
}

bool requirements_highlight(const struct compiled_scene *scene) {
    for (uint32_t i = 1; i < scene->material_count; i++) {
        if (scene->materials[i].specular > 0 ||
            scene->materials[i].specular_table != SPECULAR_CONSTANT) {
            return true;
        }
    }
    return false;
}

static bool has_operation(const struct compiled_scene *scene, uint32_t code) {
    for (uint32_t i = 0; i < scene->program_length; i++) {
        if (scene->programs[i] == code) {
            return true;
        }
    }
    return false;
}

static void print_dead(FILE *out, const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->dead_count; i++) {
        (void)fprintf(out, "dead        %s: %s\n", scene->dead[i].what, scene->dead[i].why);
    }
    if (!scene->has_shadows) {
        (void)fprintf(out, "dead        shadow rays: %s\n",
                      scene->light_count == 0
                          ? "there is no light"
                          : "nothing that keeps light off can stand between a surface and a light");
    }
    if (!requirements_total_reflection(scene)) {
        (void)fprintf(out, "dead        total reflection: %s\n",
                      !features_has_transparency(scene) ? "nothing is transparent to a path"
                      : scene->simple                   ? "the simplified model bends no ray"
                                      : "no boundary is between two indices of refraction");
    }
    if (!features_has_dispersion(scene)) {
        (void)fprintf(out, "dead        dispersion: no material's indices differ by wavelength%s\n",
                      features_has_transparency(scene) ? " in this model" : "");
    }
    if (!requirements_highlight(scene)) {
        (void)fprintf(out, "dead        highlights and mirrors: every material's specular is 0\n");
    }
}

/* ---- Ranges --------------------------------------------------------------------------------- */

static void print_materials(FILE *out, const struct compiled_scene *scene) {
    double gloss = 0, absorption = 0, least = HUGE_VAL, most = 0;
    for (uint32_t i = 1; i < scene->material_count; i++) {
        const struct compiled_material *material = &scene->materials[i];
        gloss = fmax(gloss, material->gloss);
        for (int j = 0; j < 3 && material->transparent; j++) {
            absorption = fmax(absorption, material->absorption[j]);
            least = fmin(least, material->ior[j]);
            most = fmax(most, material->ior[j]);
        }
    }
    (void)fprintf(out, "ranges      %u light%s, gloss up to %g", scene->light_count,
                  scene->light_count == 1 ? "" : "s", gloss);
    if (most > 0) {
        (void)fprintf(out, ", indices %g to %g, absorption up to %g per scaled unit", least, most,
                      absorption);
    }
    (void)fprintf(out, "\n");
}

static void print_nesting(FILE *out, const struct compiled_scene *scene) {
    uint32_t longest = 0;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        longest = scene->objects[i].length > longest ? scene->objects[i].length : longest;
    }
    (void)fprintf(out,
                  "nesting     %d deep; the longest CSG program has %u codes; a way meets up to %u "
                  "boundaries\n",
                  requirements_nesting(scene), longest, scene->depth + 1u);
}

void requirements_print(FILE *out, const struct compiled_scene *scene) {
    struct words words = {out, 0};
    features_tell(scene, take_feature, &words);
    static const struct {
        uint32_t code;
        const char *name;
    } operations[] = {{COMPILED_UNION, "union"},
                      {COMPILED_INTERSECTION, "intersection"},
                      {COMPILED_DIFFERENCE, "difference"}};
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; i++) {
        if (has_operation(scene, operations[i].code)) {
            print_word(&words, operations[i].name);
        }
    }
    if (scene->light_count > 1) {
        print_word(&words, "more than one light");
    }
    if (requirements_total_reflection(scene)) {
        print_word(&words, "total reflection");
    }
    if (requirements_highlight(scene)) {
        print_word(&words, "highlights");
    }
    (void)fprintf(out, "\n");
    print_dead(out, scene);
    print_materials(out, scene);
    print_nesting(out, scene);
}
