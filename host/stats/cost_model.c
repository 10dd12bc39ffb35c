/* SPDX-License-Identifier: MIT */
/* Seconds that a rendering would take on a machine, from what it did. */
#include "stats/cost_model.h"

#include <math.h>
#include <string.h>

struct cost_mix cost_mix_of(const struct compiled_scene *scene) {
    struct cost_mix mix = {0, 0, 0, 0, 0};
    double one = scene->primitive_count > 0 ? 1.0 / scene->primitive_count : 0;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        switch (primitive->kind) {
        case PRIMITIVE_BOX:
            *(primitive->frame == COMPILED_FRAME_WORLD ? &mix.box : &mix.turned_box) += one;
            break;
        case PRIMITIVE_BALL:
            mix.ball += one;
            break;
        case PRIMITIVE_POLYHEDRON:
            mix.polyhedron_plane += one * scene->polyhedra[primitive->index].count;
            break;
        case PRIMITIVE_QUADRIC:
            mix.quadric += one;
            break;
        }
    }
    return mix;
}

void cost_operations_of(const struct cost_events *events, const struct cost_mix *mix,
                        double operations[COST_KINDS]) {
    const double tests = (double)events->solid_tests;
    const double counts[COST_EVENTS] = {
        [COST_RAY] = (double)events->rays,
        [COST_SHADOW_RAY] = (double)events->shadow_rays,
        [COST_NODE] = (double)events->nodes,
        [COST_BOX] = tests * mix->box,
        [COST_TURNED_BOX] = tests * mix->turned_box,
        [COST_BALL] = tests * mix->ball,
        [COST_PLANE] = tests * mix->polyhedron_plane,
        [COST_QUADRIC] = tests * mix->quadric,
    };
    for (int kind = 0; kind < COST_KINDS; kind++) {
        operations[kind] = 0;
        for (int event = 0; event < COST_EVENTS; event++) {
            operations[kind] += counts[event] * cost_operations[event][kind];
        }
    }
}

static double clocks_each(const struct cost_target *target, const char *arithmetic) {
    return strcmp(arithmetic, "fx") == 0    ? target->clocks_fx
           : strcmp(arithmetic, "f32") == 0 ? target->clocks_f32
           : strcmp(arithmetic, "f64") == 0 ? target->clocks_f64
                                            : 0;
}

double cost_instructions(const char *code, const char *arithmetic, const struct cost_events *events,
                         const struct cost_mix *mix) {
    double operations[COST_KINDS];
    cost_operations_of(events, mix, operations);
    for (const struct cost_code *row = cost_codes; row->name != NULL; row++) {
        if (strcmp(row->name, code) == 0 && strcmp(row->arithmetic, arithmetic) == 0) {
            double instructions =
                row->overhead * (double)(events->rays + events->shadow_rays + events->nodes);
            for (int kind = 0; kind < COST_KINDS; kind++) {
                instructions += operations[kind] * row->instructions[kind];
            }
            return instructions;
        }
    }
    return NAN;
}

double cost_seconds(const struct cost_target *target, const char *arithmetic,
                    const struct cost_work *work) {
    const char *code = strcmp(arithmetic, "fx") == 0 ? target->code : target->float_code;
    double each = clocks_each(target, arithmetic);
    if (!(each > 0)) {
        return NAN;
    }
    double instructions = cost_instructions(code, arithmetic, &work->events, &work->mix);
    double clocks = instructions * each + (double)work->port_writes * target->port_clocks;
    return clocks / (target->megahertz * 1e6);
}
