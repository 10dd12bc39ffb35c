/* SPDX-License-Identifier: MIT */
/* Abstract syntax as the text of a scene file. */
#include "write.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct out {
    char *text;
    size_t size, used;
};

static void put(struct out *out, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    size_t room = out->size - out->used;
    int letters = vsnprintf(out->text + out->used, room, format, arguments);
    va_end(arguments);
    out->used =
        letters < 0 || (size_t)letters >= room ? out->size - 1 : out->used + (size_t)letters;
}

/* Writes the shortest decimal number that is read as the same double. */
static void put_number(struct out *out, double number) {
    char digits[40];
    for (int precision = 1; precision <= 17; precision++) {
        (void)snprintf(digits, sizeof digits, "%.*g", precision, number);
        double back = strtod(digits, NULL);
        if (!(back < number || back > number)) {
            break;
        }
    }
    bool is_whole = strpbrk(digits, ".e") == NULL;
    put(out, is_whole && strlen(digits) > 8 ? "%s.0" : "%s", digits);
}

static void put_three(struct out *out, const char *key, const double three[3]) {
    put(out, " %s = (", key);
    for (int i = 0; i < 3; i++) {
        put(out, i == 0 ? "" : ", ");
        put_number(out, three[i]);
    }
    put(out, ");");
}

static void put_one(struct out *out, const char *key, double number) {
    put(out, " %s = ", key);
    put_number(out, number);
    put(out, ";");
}

static bool is_all(const double three[3], double number) {
    for (int i = 0; i < 3; i++) {
        if (three[i] < number || three[i] > number) {
            return false;
        }
    }
    return true;
}

static void put_plane(struct out *out, const struct syntax_plane *plane) {
    put_three(out, "normal", plane->normal);
    put_one(out, "offset", plane->offset);
}

static void put_ends(struct out *out, const struct syntax_solid *solid) {
    put_three(out, "from", solid->a);
    put_three(out, "to", solid->b);
}

static void put_round(struct out *out, const struct syntax_solid *solid) {
    put_ends(out, solid);
    switch (solid->kind) {
    case SYNTAX_CONE:
        put_one(out, "from_radius", solid->radius);
        put_one(out, "to_radius", solid->radius_b);
        break;
    case SYNTAX_ONE_SHEET:
        put_one(out, "radius", solid->radius);
        put_one(out, "waist", solid->radius_b);
        break;
    case SYNTAX_TWO_SHEETS:
        put_one(out, "radius", solid->radius);
        put_one(out, "gap", solid->radius_b);
        break;
    default: /* cylinders and paraboloids */
        put_one(out, "radius", solid->radius);
        break;
    }
}

static const char *const words[SYNTAX_KINDS] = {
    "box",        "ball",        "cylinder",     "cone",       "ellipsoid",
    "paraboloid", "hyperboloid", "hyperboloid",  "quadric",    "half_space",
    "polyhedron", "union",       "intersection", "difference", "part",
};

static void put_many(struct out *out, const struct syntax_solid *solid) {
    if (solid->kind == SYNTAX_QUADRIC) {
        put(out, " coefficients = (");
        for (int i = 0; i < 10; i++) {
            put(out, i == 0 ? "" : ", ");
            put_number(out, solid->form[i]);
        }
        put(out, ");");
        return;
    }
    put(out, " planes = (");
    for (int i = 0; i < solid->plane_count; i++) {
        put(out, i == 0 ? "{" : ", {");
        put_plane(out, &solid->planes[i]);
        put(out, " }");
    }
    put(out, ");");
}

static void put_leaf(struct out *out, const struct syntax_solid *solid) {
    put(out, " %s = {", words[solid->kind]);
    switch (solid->kind) {
    case SYNTAX_BOX:
        put_three(out, "min", solid->a);
        put_three(out, "max", solid->b);
        break;
    case SYNTAX_BALL:
        put_three(out, "centre", solid->a);
        put_one(out, "radius", solid->radius);
        break;
    case SYNTAX_ELLIPSOID:
        put_three(out, "centre", solid->a);
        put_three(out, "radii", solid->b);
        break;
    case SYNTAX_HALF_SPACE:
        put_plane(out, &solid->planes[0]);
        break;
    case SYNTAX_QUADRIC:
    case SYNTAX_POLYHEDRON:
        put_many(out, solid);
        break;
    default: /* what has an axis */
        put_round(out, solid);
        break;
    }
    put(out, " };");
}

static void put_solid(struct out *out, const struct syntax *syntax, int index, int indent) {
    const struct syntax_solid *solid = &syntax->solids[index];
    put(out, "{");
    if (syntax_is_leaf(solid->kind)) {
        put_leaf(out, solid);
    } else if (solid->kind == SYNTAX_PART) {
        put(out, " part = \"p%d\";", solid->part);
    } else {
        put(out, " %s = (", words[solid->kind]);
        for (int i = 0; i < solid->child_count; i++) {
            put(out, "%s\n%*s", i == 0 ? "" : ",", indent + 2, "");
            put_solid(out, syntax, solid->children[i], indent + 2);
        }
        put(out, " );");
    }
    if (solid->material >= 0) {
        put(out, " material = \"m%d\";", solid->material);
    }
    if (!is_all(solid->scale, 1)) {
        put_three(out, "scale", solid->scale);
    }
    if (!is_all(solid->rotate, 0)) {
        put_three(out, "rotate", solid->rotate);
    }
    if (!is_all(solid->translate, 0)) {
        put_three(out, "translate", solid->translate);
    }
    put(out, " }");
}

static void put_specular(struct out *out, const struct syntax_material *material) {
    if (!material->has_table) {
        put_one(out, "specular", material->specular);
        return;
    }
    put(out, " specular = (");
    for (int i = 0; i < SYNTAX_TABLE; i++) {
        put(out, i == 0 ? "" : ", ");
        put_number(out, material->table[i]);
    }
    put(out, ");");
}

static void put_optics(struct out *out, const struct syntax_material *material) {
    if (material->disperses) {
        put_three(out, "ior", material->ior);
    } else {
        put_one(out, "ior", material->ior[0]);
    }
    if (!is_all(material->absorption, 0)) {
        put_three(out, "absorption", material->absorption);
    }
    if (!is_all(material->reflects, 1)) {
        put_three(out, "reflectance_factors", material->reflects);
    }
    if (!is_all(material->transmits, 1)) {
        put_three(out, "transmittance_factors", material->transmits);
    }
    if (material->casts_shadow) {
        put(out, " casts_shadow = true;");
    }
}

static void put_material(struct out *out, const struct syntax_material *material, int index) {
    put(out, "  m%d = {", index);
    put_three(out, "colour", material->colour);
    put_one(out, "ambient", material->ambient);
    put(out, " ambient_is_own = %s;", material->ambient_is_own ? "true" : "false");
    put_one(out, "diffuse", material->diffuse);
    put_specular(out, material);
    put(out, " gloss = %d;", material->gloss);
    if (material->transparent) {
        put_optics(out, material);
    }
    if (material->pattern.present) {
        put(out, " pattern = {");
        put_three(out, "size", material->pattern.size);
        put_three(out, "origin", material->pattern.origin);
        put_three(out, "colour", material->pattern.colour);
        put(out, " };");
    }
    put(out, " };\n");
}

static void put_lights(struct out *out, const struct syntax *syntax) {
    put(out, "lights = (");
    for (int i = 0; i < syntax->light_count; i++) {
        const struct syntax_light *light = &syntax->lights[i];
        put(out, i == 0 ? "\n  {" : ",\n  {");
        put_three(out, light->parallel ? "direction" : "position", light->place);
        put_three(out, "colour", light->colour);
        put(out, " }");
    }
    put(out, " );\n");
}

static void put_head(struct out *out, const struct syntax *syntax) {
    static const char *const models[] = {"simple", "fresnel", "wavelength"};
    put(out, "version = 1; size = [%d, %d]; depth = %d;", syntax->width, syntax->height,
        syntax->depth);
    put_one(out, "threshold", syntax->threshold);
    put(out, " model = \"%s\"; highlight = \"%s\"; mixing = \"%s\";\n", models[syntax->model],
        syntax->blinn ? "blinn" : "phong", syntax->filters ? "filter" : "additive");
    put_three(out, "background", syntax->background);
    put_three(out, "ambient", syntax->ambient);
    if (syntax->fades) {
        put(out, " attenuation = {");
        put_one(out, "constant", syntax->fade_constant);
        put(out, " };");
    }
    put(out, "\ncamera = {");
    put_three(out, "eye", syntax->eye);
    put_three(out, "look_at", syntax->look_at);
    put_three(out, "up", syntax->up);
    put_one(out, "field_of_view", syntax->field_of_view);
    put(out, " };\n");
}

bool write_scene(const struct syntax *syntax, char *text, size_t size) {
    struct out out = {text, size, 0};
    put_head(&out, syntax);
    put_lights(&out, syntax);
    put(&out, "materials = {\n");
    for (int i = 0; i < syntax->material_count; i++) {
        if (!syntax_uses_material(syntax, i)) {
            continue;
        }
        put_material(&out, &syntax->materials[i], i);
    }
    put(&out, "};\nparts = (");
    for (int i = 0; i < syntax->part_count; i++) {
        put(&out, "%s\n  { name = \"p%d\"; solid = ", i == 0 ? "" : ",", i);
        put_solid(&out, syntax, syntax->parts[i], 4);
        put(&out, "; }");
    }
    put(&out, " );\nobjects = (");
    for (int i = 0; i < syntax->object_count; i++) {
        put(&out, "%s\n  { material = \"m%d\"; solid = ", i == 0 ? "" : ",",
            syntax->objects[i].material);
        put_solid(&out, syntax, syntax->objects[i].solid, 4);
        put(&out, "; }");
    }
    put(&out, " );\n");
    return out.used < size - 1;
}
