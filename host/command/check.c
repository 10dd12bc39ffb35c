/* SPDX-License-Identifier: MIT */
/* superframe check: reads and analyses a scene and says what it requires. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "command/command.h"
#include "compiler/features.h"
#include "compiler/requirements.h"
#include "render/arithmetic.h"
#include "render/remarks.h"
#include "scene/load.h"
#include "validate/validate.h"

/* Holds the options that `check` alone takes. */
struct check_options {
    struct options common;
    bool validates; /* holds the tables against the scene after each step of the compiler */
};

static void print_description(const struct scene_description *scene) {
    size_t opaque = 0;
    for (size_t i = 0; i < scene->material_count; i++) {
        opaque += !scene->materials[i].transparent;
    }
    (void)printf("title       %s\n", scene->title != NULL ? scene->title : "");
    (void)printf("picture     %d x %d pixels, depth level %d, threshold %g\n", scene->width,
                 scene->height, scene->depth, scene->threshold);
    (void)printf("contents    %zu objects of %zu CSG nodes, %zu materials (%zu opaque), "
                 "%zu lights\n",
                 scene->object_count, scene->node_count, scene->material_count, opaque,
                 scene->light_count);
}

/* Prints how the scene was scaled, with lengths in the file's own unit. */
static void print_scaling(const struct compiled_scene *compiled) {
    (void)printf("scaling     centre (%g, %g, %g), times 2^%d: +-512 scaled units are +-%g\n",
                 compiled->centre[0], compiled->centre[1], compiled->centre[2], compiled->exponent,
                 ldexp(512, -compiled->exponent));
}

static void print_indices(const struct compiled_scene *compiled) {
    double least = HUGE_VAL, most = 0;
    for (unsigned i = 1; i < compiled->material_count; i++) { /* 0 is the air */
        if (compiled->materials[i].transparent) {
            least = fmin(least, compiled->materials[i].ior[1]);
            most = fmax(most, compiled->materials[i].ior[1]);
        }
    }
    if (most > 0) {
        (void)printf("refraction  indices %g to %g\n", least, most);
    }
}

static void print_tables(const struct compiled_scene *compiled) {
    unsigned boxes = 0;
    for (unsigned i = 0; i < compiled->primitive_count; i++) {
        boxes += compiled->primitives[i].kind == PRIMITIVE_BOX;
    }
    (void)printf("tables      %u primitives (%u boxes, %u balls), %u surfaces, %u codes of "
                 "programs\n",
                 compiled->primitive_count, boxes, compiled->ball_count, compiled->surface_count,
                 compiled->program_length);
}

static void print_done(const char *what, unsigned count, const char *one, const char *many) {
    (void)printf("%-11s %u %s\n", what, count, count == 1 ? one : many);
}

/* Prints what the scene compiler made of the solids, so that a ray asks fewer of them. */
static void print_optimisations(const struct compiled_scene *compiled) {
    const struct compiled_report *report = &compiled->report;
    print_done("shared", report->shared, "solid is the same as another one",
               "solids are the same as others");
    print_done("simplified", report->simplified, "operation of CSG says nothing",
               "operations of CSG say nothing");
    print_done("fused", report->fused, "solid is taken in by its neighbour",
               "solids are taken in by their neighbours");
    print_done("bounded", report->bounded, "solid ends where nothing more of it is seen",
               "solids end where nothing more of them is seen");
    print_done("hidden", report->hidden, "primitive cannot be met from within another one",
               "pairs of primitives cannot be met one from within the other");
}

/* Tells whether each arithmetic can hold the scene: fx is the one whose ranges are narrow. json:
 * NULL for words. Returns STATUS_BAD_INPUT where one can't. */
static int tell_arithmetics(struct json *json, const struct compiled_scene *compiled) {
    int status = STATUS_DONE;
    for (size_t i = 0; arithmetics_built[i] != NULL; i++) {
        struct scene_error error;
        const char *name = arithmetics_built[i]->image->name;
        struct scene *scene =
            arithmetic_for(arithmetics_built[i], compiled)->load(compiled, &error);
        if (scene == NULL) {
            status =
                json != NULL ? STATUS_BAD_INPUT : bad_input("%s (--arith %s)", error.text, name);
        }
        if (json != NULL) {
            json_flag(json, name, scene != NULL);
        } else {
            (void)printf("%-11s %s\n", name, scene != NULL ? "holds it" : "can't hold it");
        }
        free(scene);
    }
    return status;
}

/* Reports for each step of the compiler what its tables were compared with, and what did not agree.
 * json: NULL for words. Returns STATUS_NOT_HELD where something did not. */
static int tell_validations(struct json *json, const struct validations *validations) {
    int status = STATUS_DONE;
    for (int i = 0; i < STEP_COUNT; i++) {
        const struct validation *step = &validations->of[i];
        const char *name = compile_step_name((enum compile_step)i);
        status = step->faults > 0 ? STATUS_NOT_HELD : status;
        if (json != NULL) {
            json_begin_object(json, NULL);
            json_text(json, "step", name);
            json_count(json, "points", step->points);
            json_count(json, "faults", step->faults);
            json_text(json, "first", step->faults > 0 ? step->first : NULL);
            json_end_object(json);
        } else if (step->faults > 0) {
            (void)printf("validated   %s: %u points, %u disagree: %s\n", name, step->points,
                         step->faults, step->first);
        } else {
            (void)printf("validated   %s: %u points agree\n", name, step->points);
        }
    }
    return status;
}

static int print_check(const struct scene_description *scene, const struct compiled_scene *compiled,
                       const struct validations *validations) {
    print_description(scene);
    print_scaling(compiled);
    print_indices(compiled);
    print_tables(compiled);
    print_optimisations(compiled);
    requirements_print(stdout, compiled);
    remarks_print(stdout, compiled);
    int held = validations != NULL ? tell_validations(NULL, validations) : STATUS_DONE;
    int status = tell_arithmetics(NULL, compiled);
    return status != STATUS_DONE ? status : held;
}

/* ---- JSON ----------------------------------------------------------------------------------- */

static void write_description(struct json *json, const struct scene_description *scene) {
    json_text(json, "title", scene->title);
    json_count(json, "width", (uint64_t)scene->width);
    json_count(json, "height", (uint64_t)scene->height);
    json_count(json, "depth", (uint64_t)scene->depth);
    json_real(json, "threshold", scene->threshold);
    json_count(json, "objects", scene->object_count);
    json_count(json, "csg_nodes", scene->node_count);
    json_count(json, "materials", scene->material_count);
    json_count(json, "lights", scene->light_count);
}

static void write_tables(struct json *json, const struct compiled_scene *compiled) {
    const struct compiled_report *report = &compiled->report;
    json_begin_list(json, "centre");
    for (int i = 0; i < 3; i++) {
        json_real(json, NULL, compiled->centre[i]);
    }
    json_end_list(json);
    json_real(json, "scale", ldexp(1, compiled->exponent));
    json_count(json, "primitives", compiled->primitive_count);
    json_count(json, "surfaces", compiled->surface_count);
    json_count(json, "program_bytes", compiled->program_length);
    json_count(json, "shared", report->shared);
    json_count(json, "simplified", report->simplified);
    json_count(json, "fused", report->fused);
    json_count(json, "bounded", report->bounded);
    json_count(json, "hidden", report->hidden);
    json_count(json, "nesting", (uint64_t)requirements_nesting(compiled));
}

static void write_feature(void *context, const char *feature, int value) {
    json_count(context, feature, (uint64_t)value);
}

static void write_requirements(struct json *json, const struct compiled_scene *compiled) {
    json_begin_object(json, "requires");
    features_tell(compiled, write_feature, json);
    json_end_object(json);
    json_begin_list(json, "dead");
    for (unsigned i = 0; i < compiled->dead_count; i++) {
        json_begin_object(json, NULL);
        json_text(json, "what", compiled->dead[i].what);
        json_text(json, "why", compiled->dead[i].why);
        json_end_object(json);
    }
    json_end_list(json);
}

static int write_check(const struct scene_description *scene, const struct compiled_scene *compiled,
                       const struct validations *validations) {
    struct json json = {.out = stdout};
    json_begin_object(&json, NULL);
    write_description(&json, scene);
    write_tables(&json, compiled);
    write_requirements(&json, compiled);
    int held = STATUS_DONE;
    if (validations != NULL) {
        json_begin_list(&json, "validated");
        held = tell_validations(&json, validations);
        json_end_list(&json);
    }
    json_begin_object(&json, "arithmetics");
    int status = tell_arithmetics(&json, compiled);
    json_end_object(&json);
    json_end_object(&json);
    return status != STATUS_DONE ? status : held;
}

/* ---- The command ---------------------------------------------------------------------------- */

static int run_check(const struct options *options) {
    struct scene_error error;
    struct scene_description *scene =
        load_scene_with(options->operands[0], &options->overrides, &error);
    if (scene == NULL) {
        return bad_input("%s", error.text);
    }
    const bool validates = ((const struct check_options *)options)->validates;
    struct validations validations = {.description = scene};
    const struct compile_observer observer = {validations_look, &validations};
    struct compiled_scene *compiled =
        scene_compile_observed(scene, validates ? &observer : NULL, &error);
    const struct validations *found = validates ? &validations : NULL;
    int status = compiled == NULL ? bad_input("%s", error.text)
                 : options->json  ? write_check(scene, compiled, found)
                                  : print_check(scene, compiled, found);
    compiled_scene_free(compiled);
    scene_description_free(scene);
    return status;
}

static const struct option_group group_own = {
    "Result", OPTION_ENTRIES({.name = "validate",
                              FLAG_IN(struct check_options, validates),
                              .help = "hold the tables against the scene after each step of the "
                                      "compiler; exit status 3 if not"})};

const struct command command_check = {
    .name = "check",
    COMMAND_OPERANDS("SCENE", 1, 1, OPERANDS_SCENES),
    .summary = "Read and analyse a scene; say what it requires.",
    .size = sizeof(struct check_options),
    .groups = OPTION_GROUPS(&group_own, &group_json, &group_scene),
    .examples = COMMAND_EXAMPLES("check fig3", "check my.scene --validate"),
    .run = run_check};
