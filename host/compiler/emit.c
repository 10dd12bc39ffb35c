/* SPDX-License-Identifier: MIT */
/* A compiled scene as C source. */
#include "compiler/emit.h"

#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>

#include <xxhash.h>

#include "compiler/features.h"

/* Numbers are written as hexadecimal floating constants, which every compiler reads exactly. */

static void emit_vector(FILE *out, const char *role, const double v[3]) {
    fprintf(out, "{%s(%a), %s(%a), %s(%a)}", role, v[0], role, v[1], role, v[2]);
}

/* Writes as many words of a set as the scene needs; an image that has more fills them with 0. */
static void emit_set(FILE *out, const struct compiled_set *set, int words) {
    fprintf(out, "{{");
    for (int i = 0; i < words; i++) {
        fprintf(out, "%s0x%08lXu", i ? ", " : "", (unsigned long)set->word[i]);
    }
    fprintf(out, "}}");
}

static const char *truth(bool value) {
    return value ? "true" : "false";
}

static void emit_frames(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct frame frames[] = {\n");
    for (int i = 0; i < scene->frame_count; i++) {
        fprintf(out, "    {");
        emit_vector(out, "REAL_LENGTH", scene->frames[i].origin);
        fprintf(out, ", {");
        for (int j = 0; j < 3; j++) {
            emit_vector(out, "REAL_UNIT", scene->frames[i].axis[j]);
            fprintf(out, "%s", j < 2 ? ", " : "}},\n");
        }
    }
    fprintf(out, "};\n");
}

static void emit_boxes(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct box boxes[] = {\n");
    for (int i = 0; i < scene->box_count; i++) {
        const struct compiled_box *box = &scene->boxes[i];
        fprintf(out, "    {");
        emit_vector(out, "REAL_LENGTH", box->minimum);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_LENGTH", box->maximum);
        fprintf(out, ",\n     {%u, %u, %u, %u, %u, %u}},\n", box->surface[0], box->surface[1],
                box->surface[2], box->surface[3], box->surface[4], box->surface[5]);
    }
    fprintf(out, "};\n");
}

static void emit_balls(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct ball balls[] = {\n");
    for (int i = 0; i < scene->ball_count; i++) {
        const struct compiled_ball *ball = &scene->balls[i];
        fprintf(out, "    {");
        emit_vector(out, "REAL_LENGTH", ball->centre);
        fprintf(out, ", REAL_AREA(%a), %u},\n", ball->radius * ball->radius, ball->surface);
    }
    fprintf(out, "};\n");
}

static void emit_polyhedra(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct polyhedron polyhedra[] = {\n");
    for (int i = 0; i < scene->polyhedron_count; i++) {
        fprintf(out, "    {%u, %u},\n", scene->polyhedra[i].first, scene->polyhedra[i].count);
    }
    fprintf(out, "};\n\nstatic const struct plane planes[] = {\n");
    for (int i = 0; i < scene->plane_count; i++) {
        const struct compiled_plane *plane = &scene->planes[i];
        fprintf(out, "    {");
        emit_vector(out, "REAL_UNIT", plane->normal);
        fprintf(out, ", REAL_LENGTH(%a), %u},\n", plane->offset, plane->surface);
    }
    fprintf(out, "};\n");
}

static void emit_quadrics(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct quadric quadrics[] = {\n");
    for (int i = 0; i < scene->quadric_count; i++) {
        const struct compiled_quadric *quadric = &scene->quadrics[i];
        fprintf(out, "    {");
        emit_vector(out, "REAL_LENGTH", quadric->centre);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_UNIT", quadric->square);
        fprintf(out, ",\n     REAL_LENGTH(%a), REAL_AREA(%a), REAL_AREA(%a),\n", quadric->linear,
                quadric->constant, quadric->reach * quadric->reach);
        fprintf(out, "     %u, %u, %u, %s, %s},\n", quadric->surface, quadric->box, quadric->cuts,
                truth(quadric->reach > 0), truth(quadric->left_for_good));
    }
    fprintf(out, "};\n");
}

static void emit_primitives(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct primitive primitives[] = {\n");
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        fprintf(out, "    {%u, %u, %u, %s, %u},\n", primitive->kind, primitive->index,
                primitive->frame, truth(primitive->left_for_good), primitive->enclosure);
    }
    fprintf(out, "};\n\nstatic const struct primitive_set surfaces[] = {\n");
    for (int i = 0; i < scene->surface_count; i++) {
        fprintf(out, "    ");
        emit_set(out, &scene->surfaces[i], features_primitive_words(scene));
        fprintf(out, ",\n");
    }
    fprintf(out, "};\n\nstatic const struct primitive_set hidden_by[] = {\n");
    for (int i = 0; i < scene->primitive_count; i++) {
        fprintf(out, "    ");
        emit_set(out, &scene->hidden_by[i], features_primitive_words(scene));
        fprintf(out, ",\n");
    }
    fprintf(out, "};\n");
}

static void emit_objects(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const uint8_t programs[] = {");
    for (int i = 0; i < scene->program_length; i++) {
        fprintf(out, "%s0x%02X,", i % 16 ? " " : "\n    ", scene->programs[i]);
    }
    fprintf(out, "\n};\n\nstatic const struct object objects[] = {\n");
    for (int i = 0; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        fprintf(out, "    {%u, %u, %u, %s, ", object->program, object->length, object->material,
                truth(object->in_shadow_test));
        emit_set(out, &object->uses, features_primitive_words(scene));
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
}

static void emit_materials(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct material materials[] = {\n");
    for (int i = 0; i < scene->material_count; i++) {
        const struct compiled_material *material = &scene->materials[i];
        fprintf(out, "    {");
        emit_vector(out, "REAL_COLOUR", material->colour);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_COLOUR", material->ambient);
        fprintf(out, ",\n     REAL_ENERGY(%a), REAL_ENERGY(%a), REAL_ENERGY(%a), %u,\n     ",
                material->ambient_share, material->diffuse, material->specular, material->gloss);
        fprintf(out, "%s, %s, %s, %s, %s, %u, %u, %u,\n     ", truth(material->transparent),
                truth(material->casts_shadow), truth(material->absorbs), truth(material->disperses),
                truth(material->tints), material->specular_table, material->pattern,
                material->optical);
        emit_vector(out, "REAL_INDEX", material->ior);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_INDEX", material->inverse_ior);
        fprintf(out, ",\n     REAL_ENERGY(%a), ", material->transmittance);
        emit_vector(out, "REAL_ENERGY", material->reflects);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_ENERGY", material->transmits);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_ENERGY", material->filter);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_EXTINCTION", material->absorption);
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
}

static void emit_patterns(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct pattern patterns[] = {\n");
    for (int i = 0; i < scene->pattern_count; i++) {
        const struct compiled_pattern *pattern = &scene->patterns[i];
        fprintf(out, "    {%u, %u, %u, ", pattern->axes, pattern->face_count, pattern->first_face);
        emit_vector(out, "REAL_LENGTH", pattern->origin);
        fprintf(out, ", ");
        emit_vector(out, "REAL_LENGTH", pattern->size);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_COLOUR", pattern->colour);
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
}

static void emit_pattern_faces(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct pattern_face pattern_faces[] = {\n");
    for (int i = 0; i < scene->pattern_face_count; i++) {
        const struct compiled_pattern_face *face = &scene->pattern_faces[i];
        fprintf(out, "    {%u, %u, %s, %s},\n", face->surface, face->axis, truth(face->odd_above),
                truth(face->odd_below));
    }
    fprintf(out, "};\n");
}

static void emit_specular_tables(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct specular_table specular_tables[] = {\n");
    for (int i = 0; i < scene->specular_table_count; i++) {
        const struct compiled_specular_table *table = &scene->specular_tables[i];
        for (int half = 0; half < 2; half++) {
            fprintf(out, half ? "     {" : "    {{");
            for (int j = 0; j < SCENE_SPECULAR_STEPS; j++) {
                const double value = half ? table->specular[j] : table->cosine[j];
                fprintf(out, "%s%s(%a)", j ? ", " : "", half ? "REAL_ENERGY" : "REAL_UNIT", value);
            }
            fprintf(out, half ? "}},\n" : "},\n");
        }
    }
    fprintf(out, "};\n");
}

static void emit_lights(FILE *out, const struct compiled_scene *scene) {
    fprintf(out, "\nstatic const struct light lights[] = {\n");
    for (int i = 0; i < scene->light_count; i++) {
        const struct compiled_light *light = &scene->lights[i];
        fprintf(out, "    {%s, %s, ", truth(light->parallel), truth(light->casts_shadows));
        emit_vector(out, "REAL_UNIT", light->towards);
        fprintf(out, ",\n     ");
        emit_vector(out, "REAL_LENGTH", light->position);
        fprintf(out, ", ");
        emit_vector(out, "REAL_COLOUR", light->colour);
        fprintf(out, "},\n");
    }
    fprintf(out, "};\n");
}

static void emit_camera(FILE *out, const struct compiled_camera *camera, int words) {
    fprintf(out, "    {");
    emit_vector(out, "REAL_LENGTH", camera->eye);
    fprintf(out, ",\n     ");
    emit_vector(out, "REAL_UNIT", camera->forward);
    fprintf(out, ",\n     ");
    emit_vector(out, "REAL_UNIT", camera->column);
    fprintf(out, ",\n     ");
    emit_vector(out, "REAL_UNIT", camera->row);
    fprintf(out, ",\n     ");
    emit_vector(out, "REAL_UNIT", camera->up);
    fprintf(out, ",\n     %u, ", camera->shift);
    emit_set(out, &camera->inside, words);
    fprintf(out, ", %u},\n", camera->object);
}

/* Returns a table's name, or "0" where it has no entries, as C99 has no empty arrays. */
static const char *table(int count, const char *name) {
    return count > 0 ? name : "0";
}

/* Names by enum compiled_show; firmware/targets/build.sh looks for the last one. */
static const char *const show_names[] = {[COMPILED_FULL] = "SHOW_FULL",
                                         [COMPILED_BITS] = "SHOW_BITS",
                                         [COMPILED_DITHER] = "SHOW_DITHER",
                                         [COMPILED_EXPOSURES] = "SHOW_EXPOSURES"};

static void emit_scene(FILE *out, const struct compiled_scene *scene, const char *name) {
    fprintf(out, "\nextern const struct scene scene_%s;\n\nconst struct scene scene_%s = {\n", name,
            name);
    fprintf(out, "    %u, %u, %u, REAL_ENERGY(%a),\n    ", scene->width, scene->height,
            scene->depth, scene->threshold);
    fprintf(out, "0, %s, %luu, %luu, %u,\n    ", truth(scene->estimates),
            (unsigned long)(scene->error * 65536 + 0.5), (unsigned long)scene->ray_budget,
            scene->brightest);
    emit_vector(out, "REAL_COLOUR", scene->background);
    fprintf(out, ",\n    %s, %s, %s, %s, REAL_LENGTH(%a), %d,\n", truth(scene->simple),
            truth(scene->filters), truth(scene->blinn), truth(scene->fades), scene->fade_start,
            scene->fade_exponent);
    emit_camera(out, &scene->camera, features_primitive_words(scene));
    fprintf(out, "    %u, %u, %u,\n", scene->primitive_count, scene->object_count,
            scene->light_count);
    fprintf(
        out,
        "    %s, %s, %s, %s, %s, %s, %s, %s, %s, %s, objects, materials, %s, %s, %s, %s,\n    ",
        table(scene->frame_count, "frames"), table(scene->primitive_count, "primitives"),
        table(scene->box_count, "boxes"), table(scene->ball_count, "balls"),
        table(scene->polyhedron_count, "polyhedra"), table(scene->plane_count, "planes"),
        table(scene->quadric_count, "quadrics"), table(scene->surface_count, "surfaces"),
        table(scene->primitive_count, "hidden_by"), table(scene->program_length, "programs"),
        table(scene->pattern_count, "patterns"), table(scene->pattern_face_count, "pattern_faces"),
        table(scene->specular_table_count, "specular_tables"), table(scene->light_count, "lights"));
    emit_set(out, &scene->shadow_primitives, features_primitive_words(scene));
    fprintf(out, ",\n    %s, %u, UINT32_C(%lu)};\n", show_names[scene->show], scene->show_bits,
            (unsigned long)scene->seed);
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
    void (*const emitters[])(FILE *, const struct compiled_scene *) = {
        emit_frames,    emit_primitives,    emit_boxes,           emit_balls,
        emit_polyhedra, emit_quadrics,      emit_objects,         emit_materials,
        emit_patterns,  emit_pattern_faces, emit_specular_tables, emit_lights};
    const int counts[] = {
        scene->frame_count,        scene->primitive_count,      scene->box_count,
        scene->ball_count,         scene->polyhedron_count,     scene->quadric_count,
        scene->object_count,       scene->material_count,       scene->pattern_count,
        scene->pattern_face_count, scene->specular_table_count, scene->light_count};
    for (size_t i = 0; i < sizeof emitters / sizeof emitters[0]; i++) {
        if (counts[i] > 0) {
            emitters[i](out, scene);
        }
    }
    emit_scene(out, scene, symbol);
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
