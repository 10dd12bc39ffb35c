/* SPDX-License-Identifier: MIT */
/* A compiled scene as C source. */
#include "compiler/emit.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

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

static const char *truth(bool value) {
    return value ? "true" : "false";
}

/* What is written, and in which form of sets. */
struct emitter {
    FILE *out;
    bool lists;     /* numbers have 32 bits, and sets are lists */
    uint32_t words; /* of a set of bits */
};

/* Writes a number that has so many bits where sets are bits. */
static void emit_number(const struct emitter *to, uint32_t value, unsigned bits) {
    if (to->lists) {
        fprintf(to->out, "UINT32_C(%lu)", (unsigned long)value);
    } else {
        fprintf(to->out, "%lu", (unsigned long)(value & ((UINT32_C(1) << bits) - 1)));
    }
}

static void emit_numbers(const struct emitter *to, const uint32_t *numbers, uint32_t count,
                         unsigned bits) {
    fputc('{', to->out);
    for (uint32_t i = 0; i < count; i++) {
        fputs(i > 0 ? ", " : "", to->out);
        emit_number(to, numbers[i], bits);
    }
    fputc('}', to->out);
}

/* Writes as many words of a set as the scene needs; an image with larger sets fills the rest with
 * 0. */
static void emit_bits(const struct emitter *to, const struct compiled_set *set) {
    fputs("{{", to->out);
    for (uint32_t i = 0; i < to->words; i++) {
        fprintf(to->out, "%s0x%08lXu", i ? ", " : "", (unsigned long)compiled_set_word(set, i));
    }
    fputs("}}", to->out);
}

/* Writes an empty list with a 0, for C99 has no empty initialisers. */
static void emit_list(const struct emitter *to, const struct compiled_set *set) {
    fprintf(to->out, "{%lu, ", (unsigned long)set->count);
    if (set->count > 0) {
        emit_numbers(to, set->members, set->count, 8);
    } else {
        fputs("{0}", to->out);
    }
    fputc('}', to->out);
}

static void emit_set(const struct emitter *to, const struct compiled_set *set) {
    if (to->lists) {
        emit_list(to, set);
    } else {
        emit_bits(to, set);
    }
}

static void emit_places(const struct emitter *to, const double places[3][NODE_WIDTH]) {
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < NODE_WIDTH; i++) {
            fprintf(to->out, "%sREAL_LENGTH(%a)",
                    i > 0      ? ", "
                    : axis > 0 ? "}, {"
                               : "{{",
                    places[axis][i]);
        }
    }
    fputs("}}", to->out);
}

/* Tells whether members of a role are there: marks are not, where sets are lists. */
static bool role_is_there(const struct emitter *to, const char *role) {
    return !to->lists || strcmp(role, "MARKS") != 0;
}

/* Members of *from, by the roles of scene_fields.h. */
#define EMIT_MEMBER(role, name)                                                                    \
    if (role_is_there(to, #role)) {                                                                \
        fputs("." #name " = ", to->out);                                                           \
        EMIT_##role(from->name) fputs(", ", to->out);                                              \
    }
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
#define EMIT_SURFACES(value)     emit_numbers(to, value, 6, 16);
#define EMIT_SET(value)          emit_set(to, &(value));
#define EMIT_MARKS(value)        emit_set(to, &(value));
#define EMIT_PLACES(value)       emit_places(to, value);
#define EMIT_CHILDREN(value)     emit_numbers(to, value, NODE_WIDTH, 8);
#define EMIT_ENTRY(value)        emit_number(to, value, 8);
#define EMIT_SURFACE(value)      emit_number(to, value, 16);
#define EMIT_FIRST(value)        emit_number(to, value, 16);
#define EMIT_COUNT(value)        emit_number(to, value, 8);

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

static void emit_node(const struct emitter *to, const struct compiled_node *from) {
    NODE_FIELDS(EMIT_MEMBER)
}

static void emit_lead(const struct emitter *to, const struct compiled_lead *from) {
    LEAD_FIELDS(EMIT_MEMBER)
}

static void emit_use(const struct emitter *to, const struct compiled_use *from) {
    USE_FIELDS(EMIT_MEMBER)
}

static void emit_code(const struct emitter *to, uint32_t code) {
    if (to->lists) {
        fprintf(to->out, "UINT32_C(0x%02lX)", (unsigned long)code);
    } else {
        fprintf(to->out, "0x%02X", (uint8_t)code);
    }
}

static void emit_wide(const struct emitter *to, uint32_t number) {
    emit_number(to, number, 16);
}

/* Writes a table, if it has entries: C99 has no empty arrays. */
#define EMIT_TABLE(type, table, count, emit_it)                                                    \
    if (from->count > 0) {                                                                         \
        fprintf(to->out, "\nstatic const %s " #table "[] = {\n", type);                            \
        for (uint32_t i = 0; i < from->count; i++) {                                               \
            emit_it                                                                                \
        }                                                                                          \
        fprintf(to->out, "};\n");                                                                  \
    }
#define EMIT_ENTRY_OF(emit_members, table)                                                         \
    fputs("    {", to->out);                                                                       \
    emit_members(to, &from->table[i]);                                                             \
    fputs("},\n", to->out);
#define EMIT_VALUE(emit_value, value)                                                              \
    fputs("    ", to->out);                                                                        \
    emit_value(to, value);                                                                         \
    fputs(",\n", to->out);

static void emit_tables(const struct emitter *to, const struct compiled_scene *from) {
    EMIT_TABLE("struct frame", frames, frame_count, EMIT_ENTRY_OF(emit_frame, frames))
    EMIT_TABLE("struct primitive", primitives, primitive_count,
               EMIT_ENTRY_OF(emit_primitive, primitives))
    EMIT_TABLE("struct box", boxes, box_count, EMIT_ENTRY_OF(emit_box, boxes))
    EMIT_TABLE("struct ball", balls, ball_count, EMIT_ENTRY_OF(emit_ball, balls))
    EMIT_TABLE("struct polyhedron", polyhedra, polyhedron_count,
               EMIT_ENTRY_OF(emit_polyhedron, polyhedra))
    EMIT_TABLE("struct plane", planes, plane_count, EMIT_ENTRY_OF(emit_plane, planes))
    EMIT_TABLE("struct quadric", quadrics, quadric_count, EMIT_ENTRY_OF(emit_quadric, quadrics))
    if (!to->lists) {
        EMIT_TABLE("struct primitive_set", surfaces, surface_count,
                   EMIT_VALUE(emit_set, &from->surfaces[i]))
        EMIT_TABLE("struct primitive_set", hidden_by, primitive_count,
                   EMIT_VALUE(emit_set, &from->hidden_by[i]))
    }
    EMIT_TABLE(to->lists ? "program_code" : "uint8_t", programs, program_length,
               EMIT_VALUE(emit_code, from->programs[i]))
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

static void emit_pointers(const struct emitter *to, const struct compiled_scene *from) {
    emit_pointer(to, "frames", from->frame_count);
    emit_pointer(to, "primitives", from->primitive_count);
    emit_pointer(to, "boxes", from->box_count);
    emit_pointer(to, "balls", from->ball_count);
    emit_pointer(to, "polyhedra", from->polyhedron_count);
    emit_pointer(to, "planes", from->plane_count);
    emit_pointer(to, "quadrics", from->quadric_count);
    emit_pointer(to, "surfaces", to->lists ? 0 : from->surface_count);
    emit_pointer(to, "hidden_by", to->lists ? 0 : from->primitive_count);
    emit_pointer(to, "programs", from->program_length);
    emit_pointer(to, "objects", from->object_count);
    emit_pointer(to, "materials", from->material_count);
    emit_pointer(to, "patterns", from->pattern_count);
    emit_pointer(to, "pattern_faces", from->pattern_face_count);
    emit_pointer(to, "specular_tables", from->specular_table_count);
    emit_pointer(to, "lights", from->light_count);
}

/* Writes the tables of sets as lists. */
static void emit_hierarchy(const struct emitter *to, const struct compiled_hierarchy *from) {
    EMIT_TABLE("struct bounds_node", nodes, node_count, EMIT_ENTRY_OF(emit_node, nodes))
    EMIT_TABLE("entry_number", endless, endless_count, EMIT_VALUE(emit_wide, from->endless[i]))
    EMIT_TABLE("struct lead", leads, lead_count, EMIT_ENTRY_OF(emit_lead, leads))
    EMIT_TABLE("entry_number", keys, key_count, EMIT_VALUE(emit_wide, from->keys[i]))
    EMIT_TABLE("struct use", uses, use_count, EMIT_ENTRY_OF(emit_use, uses))
    EMIT_TABLE("run_first", parents, parent_count, EMIT_VALUE(emit_wide, from->parents[i]))
}

/* Writes the scene's own members of them. */
static void emit_roots(const struct emitter *to, const struct compiled_hierarchy *from) {
    fputs("    ", to->out);
    SCENE_HIERARCHY_FIELDS(EMIT_MEMBER)
    fputs("\n", to->out);
    emit_pointer(to, "nodes", from->node_count);
    emit_pointer(to, "endless", from->endless_count);
    emit_pointer(to, "leads", from->lead_count);
    emit_pointer(to, "keys", from->key_count);
    emit_pointer(to, "uses", from->use_count);
    emit_pointer(to, "parents", from->parent_count);
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
    if (to->lists) {
        emit_roots(to, &from->hierarchy);
    }
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
    const struct emitter emitter = {out, !compiled_fits_bits(scene),
                                    features_primitive_words(scene)};
    features_emit_assertions(out, scene);
    emit_tables(&emitter, scene);
    if (emitter.lists) {
        emit_hierarchy(&emitter, &scene->hierarchy);
    }
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
