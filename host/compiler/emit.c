/* SPDX-License-Identifier: MIT */
/* A compiled scene as C source. */
#include "compiler/emit.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>

#include <xxhash.h>

#include "compiler/features.h"

/* Numbers are written as hexadecimal floating constants, which every compiler reads exactly.
 * Members are named, so that their order does not matter. */

static void emit_vector(FILE *out, const char *role, const double v[3]) {
    fprintf(out, "{%s(%a), %s(%a), %s(%a)}", role, v[0], role, v[1], role, v[2]);
}

static void emit_vectors(FILE *out, const char *role, const double v[3][3]) {
    for (int i = 0; i < 3; i++) {
        fputs(i > 0 ? ", " : "{", out);
        emit_vector(out, role, v[i]);
    }
    fputc('}', out);
}

static void emit_steps(FILE *out, const char *role, const double v[SPECULAR_STEPS]) {
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        fprintf(out, "%s%s(%a)", i > 0 ? ", " : "{", role, v[i]);
    }
    fputc('}', out);
}

static void emit_surfaces(FILE *out, const uint32_t surface[6]) {
    fprintf(out, "{%u, %u, %u, %u, %u, %u}", surface[0], surface[1], surface[2], surface[3],
            surface[4], surface[5]);
}

/* Writes as many words of a set as the scene needs; an image with larger sets fills the rest with
 * 0. */
static void emit_set(FILE *out, const struct compiled_set *set, uint32_t words) {
    fprintf(out, "{{");
    for (uint32_t i = 0; i < words; i++) {
        fprintf(out, "%s0x%08lXu", i ? ", " : "", (unsigned long)compiled_set_word(set, i));
    }
    fprintf(out, "}}");
}

static const char *truth(bool value) {
    return value ? "true" : "false";
}

/* What is written, and how many words a set has. */
struct emitter {
    FILE *out;
    uint32_t words;
};

/* Members of *from, by the roles of scene_fields.h. */
#define EMIT_MEMBER(role, name)                                                                    \
    fputs("." #name " = ", to->out);                                                               \
    EMIT_##role(from->name) fputs(", ", to->out);
#define EMIT_POINT(value)        emit_vector(to->out, "REAL_LENGTH", value);
#define EMIT_DIRECTION(value)    emit_vector(to->out, "REAL_UNIT", value);
#define EMIT_DIRECTIONS(value)   emit_vectors(to->out, "REAL_UNIT", value);
#define EMIT_LENGTH(value)       fprintf(to->out, "REAL_LENGTH(%a)", value);
#define EMIT_AREA(value)         fprintf(to->out, "REAL_AREA(%a)", value);
#define EMIT_UNIT_STEPS(value)   emit_steps(to->out, "REAL_UNIT", value);
#define EMIT_COLOURS(value)      emit_vector(to->out, "REAL_COLOUR", value);
#define EMIT_ENERGIES(value)     emit_vector(to->out, "REAL_ENERGY", value);
#define EMIT_ENERGY(value)       fprintf(to->out, "REAL_ENERGY(%a)", value);
#define EMIT_ENERGY_STEPS(value) emit_steps(to->out, "REAL_ENERGY", value);
#define EMIT_INDICES(value)      emit_vector(to->out, "REAL_INDEX", value);
#define EMIT_EXTINCTIONS(value)  emit_vector(to->out, "REAL_EXTINCTION", value);
#define EMIT_BYTE(value)         fprintf(to->out, "%u", value);
#define EMIT_WORD(value)         fprintf(to->out, "%u", value);
#define EMIT_LONG(value)         fprintf(to->out, "UINT32_C(%lu)", (unsigned long)(value));
#define EMIT_SIGNED(value)       fprintf(to->out, "%d", value);
#define EMIT_TRUTH(value)        fputs(truth(value), to->out);
#define EMIT_SURFACES(value)     emit_surfaces(to->out, value);
#define EMIT_SET(value)          emit_set(to->out, &(value), to->words);
#define EMIT_MARKS(value)        emit_set(to->out, &(value), to->words);
#define EMIT_ENTRY(value)        fprintf(to->out, "%u", (uint8_t)(value));
#define EMIT_SURFACE(value)      fprintf(to->out, "%u", (uint16_t)(value));
#define EMIT_FIRST(value)        fprintf(to->out, "%u", (uint16_t)(value));
#define EMIT_COUNT(value)        fprintf(to->out, "%u", (uint8_t)(value));

static void emit_frame(const struct emitter *to, const struct compiled_frame *from) {
    FRAME_FIELDS(EMIT_MEMBER)
}

static void emit_primitive(const struct emitter *to, const struct compiled_primitive *from) {
    fprintf(to->out, ".kind = %u, ", (unsigned)from->kind);
    PRIMITIVE_FIELDS(EMIT_MEMBER)
}

static void emit_box(const struct emitter *to, const struct compiled_box *from) {
    BOX_FIELDS(EMIT_MEMBER)
}

static void emit_ball(const struct emitter *to, const struct compiled_ball *from) {
    BALL_FIELDS_BEFORE(EMIT_MEMBER)
    BALL_FIELDS_AFTER(EMIT_MEMBER)
    fprintf(to->out, ".square_radius = REAL_AREA(%a), ", from->radius * from->radius);
}

static void emit_polyhedron(const struct emitter *to, const struct compiled_polyhedron *from) {
    POLYHEDRON_FIELDS(EMIT_MEMBER)
}

static void emit_plane(const struct emitter *to, const struct compiled_plane *from) {
    PLANE_FIELDS(EMIT_MEMBER)
}

static void emit_quadric(const struct emitter *to, const struct compiled_quadric *from) {
    QUADRIC_FIELDS_BEFORE(EMIT_MEMBER)
    QUADRIC_FIELDS_AMID(EMIT_MEMBER)
    QUADRIC_FIELDS_AFTER(EMIT_MEMBER)
    fprintf(to->out, ".square_reach = REAL_AREA(%a), .ends = %s, ", from->reach * from->reach,
            truth(from->reach > 0));
}

static void emit_object(const struct emitter *to, const struct compiled_object *from) {
    OBJECT_FIELDS(EMIT_MEMBER)
}

static void emit_material(const struct emitter *to, const struct compiled_material *from) {
    MATERIAL_FIELDS(EMIT_MEMBER)
}

static void emit_pattern(const struct emitter *to, const struct compiled_pattern *from) {
    PATTERN_FIELDS(EMIT_MEMBER)
}

static void emit_pattern_face(const struct emitter *to, const struct compiled_pattern_face *from) {
    PATTERN_FACE_FIELDS(EMIT_MEMBER)
}

static void emit_specular_table(const struct emitter *to,
                                const struct compiled_specular_table *from) {
    SPECULAR_TABLE_FIELDS(EMIT_MEMBER)
}

static void emit_light(const struct emitter *to, const struct compiled_light *from) {
    LIGHT_FIELDS(EMIT_MEMBER)
}

static void emit_camera(const struct emitter *to, const struct compiled_camera *from) {
    CAMERA_FIELDS(EMIT_MEMBER)
}

static void emit_code(const struct emitter *to, uint32_t code) {
    fprintf(to->out, "0x%02X", (uint8_t)code);
}

static void emit_entry_set(const struct emitter *to, const struct compiled_set *from) {
    emit_set(to->out, from, to->words);
}

/* Writes a table, if it has entries: C99 has no empty arrays. */
#define EMIT_TABLE(type, table, count, emit_it)                                                    \
    if (scene->count > 0) {                                                                        \
        fprintf(to->out, "\nstatic const " type " " #table "[] = {\n");                            \
        for (uint32_t i = 0; i < scene->count; i++) {                                              \
            emit_it                                                                                \
        }                                                                                          \
        fprintf(to->out, "};\n");                                                                  \
    }
#define EMIT_ENTRY_OF(emit_members, table)                                                         \
    fputs("    {", to->out);                                                                       \
    emit_members(to, &scene->table[i]);                                                            \
    fputs("},\n", to->out);
#define EMIT_VALUE(emit_value, value)                                                              \
    fputs("    ", to->out);                                                                        \
    emit_value(to, value);                                                                         \
    fputs(",\n", to->out);

static void emit_tables(const struct emitter *to, const struct compiled_scene *scene) {
    EMIT_TABLE("struct frame", frames, frame_count, EMIT_ENTRY_OF(emit_frame, frames))
    EMIT_TABLE("struct primitive", primitives, primitive_count,
               EMIT_ENTRY_OF(emit_primitive, primitives))
    EMIT_TABLE("struct box", boxes, box_count, EMIT_ENTRY_OF(emit_box, boxes))
    EMIT_TABLE("struct ball", balls, ball_count, EMIT_ENTRY_OF(emit_ball, balls))
    EMIT_TABLE("struct polyhedron", polyhedra, polyhedron_count,
               EMIT_ENTRY_OF(emit_polyhedron, polyhedra))
    EMIT_TABLE("struct plane", planes, plane_count, EMIT_ENTRY_OF(emit_plane, planes))
    EMIT_TABLE("struct quadric", quadrics, quadric_count, EMIT_ENTRY_OF(emit_quadric, quadrics))
    EMIT_TABLE("struct primitive_set", surfaces, surface_count,
               EMIT_VALUE(emit_entry_set, &scene->surfaces[i]))
    EMIT_TABLE("struct primitive_set", hidden_by, primitive_count,
               EMIT_VALUE(emit_entry_set, &scene->hidden_by[i]))
    EMIT_TABLE("uint8_t", programs, program_length, EMIT_VALUE(emit_code, scene->programs[i]))
    EMIT_TABLE("struct object", objects, object_count, EMIT_ENTRY_OF(emit_object, objects))
    EMIT_TABLE("struct material", materials, material_count,
               EMIT_ENTRY_OF(emit_material, materials))
    EMIT_TABLE("struct pattern", patterns, pattern_count, EMIT_ENTRY_OF(emit_pattern, patterns))
    EMIT_TABLE("struct pattern_face", pattern_faces, pattern_face_count,
               EMIT_ENTRY_OF(emit_pattern_face, pattern_faces))
    EMIT_TABLE("struct specular_table", specular_tables, specular_table_count,
               EMIT_ENTRY_OF(emit_specular_table, specular_tables))
    EMIT_TABLE("struct light", lights, light_count, EMIT_ENTRY_OF(emit_light, lights))
}

/* Writes a pointer to a table that has entries; the others stay null. */
static void emit_pointer(const struct emitter *to, const char *table, uint32_t count) {
    if (count > 0) {
        fprintf(to->out, "    .%s = %s,\n", table, table);
    }
}

static void emit_pointers(const struct emitter *to, const struct compiled_scene *scene) {
    emit_pointer(to, "frames", scene->frame_count);
    emit_pointer(to, "primitives", scene->primitive_count);
    emit_pointer(to, "boxes", scene->box_count);
    emit_pointer(to, "balls", scene->ball_count);
    emit_pointer(to, "polyhedra", scene->polyhedron_count);
    emit_pointer(to, "planes", scene->plane_count);
    emit_pointer(to, "quadrics", scene->quadric_count);
    emit_pointer(to, "surfaces", scene->surface_count);
    emit_pointer(to, "hidden_by", scene->primitive_count);
    emit_pointer(to, "programs", scene->program_length);
    emit_pointer(to, "objects", scene->object_count);
    emit_pointer(to, "materials", scene->material_count);
    emit_pointer(to, "patterns", scene->pattern_count);
    emit_pointer(to, "pattern_faces", scene->pattern_face_count);
    emit_pointer(to, "specular_tables", scene->specular_table_count);
    emit_pointer(to, "lights", scene->light_count);
}

/* Names by enum show; firmware/targets/build.sh looks for the last one. */
static const char *const show_names[] = {[SHOW_FULL] = "SHOW_FULL",
                                         [SHOW_BITS] = "SHOW_BITS",
                                         [SHOW_DITHER] = "SHOW_DITHER",
                                         [SHOW_EXPOSURES] = "SHOW_EXPOSURES"};

static void emit_scene(const struct emitter *to, const struct compiled_scene *from,
                       const char *name) {
    fprintf(to->out, "\nextern const struct scene scene_%s;\n\nconst struct scene scene_%s = {\n",
            name, name);
    fprintf(to->out, "    /* %s */\n    ", show_names[from->show]);
    SCENE_FIELDS_BEFORE(EMIT_MEMBER)
    SCENE_FIELDS_AMID(EMIT_MEMBER)
    SCENE_FIELDS_AFTER(EMIT_MEMBER)
    SCENE_FIELDS_SHOWN(EMIT_MEMBER)
    fprintf(to->out, "\n    .error = UINT32_C(%lu),\n    .camera = {",
            (unsigned long)(from->error * 65536 + 0.5));
    emit_camera(to, &from->camera);
    fprintf(to->out, "},\n    .primitive_count = %u, .object_count = %u, .light_count = %u,\n",
            from->primitive_count, from->object_count, from->light_count);
    emit_pointers(to, from);
    fprintf(to->out, "};\n");
}

int scene_emit(FILE *out, const struct compiled_scene *scene, const char *name) {
    char symbol[64];
    size_t length = 0;
    for (; name[length] != '\0' && length + 1 < sizeof symbol; length++) {
        symbol[length] = '_';
        if (isalnum((unsigned char)name[length])) {
            symbol[length] = name[length];
        }
    }
    symbol[length] = '\0';
    fprintf(out, "/* The tables of the scene \"%s\", made by `superframe compile`. */\n", symbol);
    fprintf(out, "/* scaled = (p - (%.17g, %.17g, %.17g)) * 2^%d */\n", scene->centre[0],
            scene->centre[1], scene->centre[2], scene->exponent);
    fprintf(out, "/* solids shared %u, simplified %u, fused %u, bounded %u, pairs hidden %u */\n",
            scene->report.shared, scene->report.simplified, scene->report.fused,
            scene->report.bounded, scene->report.hidden);
    fprintf(out, "#include \"scene.h\"\n");
    features_emit_assertions(out, scene);
    const struct emitter emitter = {out, features_primitive_words(scene)};
    emit_tables(&emitter, scene);
    emit_scene(&emitter, scene, symbol);
    return ferror(out) ? -1 : 0;
}

bool scene_digest(const struct compiled_scene *scene, char digest[SCENE_DIGEST_SIZE]) {
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    if (file == NULL) {
        return false;
    }
    bool is_written = scene_emit(file, scene, "digest") == 0;
    is_written = fclose(file) == 0 && is_written;
    if (is_written) {
        (void)snprintf(digest, SCENE_DIGEST_SIZE, "%016" PRIx64,
                       (uint64_t)XXH3_64bits(text, length));
    }
    free(text);
    return is_written;
}
