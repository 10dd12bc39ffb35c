/* SPDX-License-Identifier: MIT */
/* Seconds that a rendering would take on a machine, from what it did. */
#ifndef SUPERFRAME_COST_MODEL_H
#define SUPERFRAME_COST_MODEL_H

#include <stdint.h>

#include "compiler/tables.h"

/* Kinds of operations, as many as enum wrap_kind of firmware/real/lab/wrap_kinds.h has, in its
 * order. tests/cost/operations.c compares the two numbers. */
enum { COST_KINDS = 13 };

/* The events of a rendering. */
struct cost_events {
    uint64_t rays, shadow_rays, nodes, solid_tests;
};

/* The shares of a ray's tests by what is tested; all 0: no primitives. The sum is 1, but for the
 * factor of polyhedron_plane: the number of planes. */
struct cost_mix {
    double box, turned_box, ball, polyhedron_plane, quadric;
};

/* Returns the mix of a scene, each of whose primitives counts alike. A polyhedron counts as one
 * test of all its planes, so that its share is multiplied by their number. */
struct cost_mix cost_mix_of(const struct compiled_scene *scene);

/* The events of which operations are counted: by kind, on average for one event. */
enum cost_event {
    COST_RAY,
    COST_SHADOW_RAY,
    COST_NODE,
    COST_BOX,
    COST_TURNED_BOX,
    COST_BALL,
    COST_PLANE,
    COST_QUADRIC,
    COST_EVENTS
};

/* Measured: `make cost-operations` prints the table. */
extern const double cost_operations[COST_EVENTS][COST_KINDS];

/* Computes the operations of a whole rendering, by kind. */
void cost_operations_of(const struct cost_events *events, const struct cost_mix *mix,
                        double operations[COST_KINDS]);

/* A machine and what its instructions and ports take. */
struct cost_target {
    const char *name, *label;
    double megahertz;
    const char *source; /* of clocks and frequency */
    double port_clocks; /* of one OUT, or of one store to an adapter */
    /* Clocks of one instruction of an image in that arithmetic, on average; 0: no entry. */
    double clocks_fx, clocks_f32, clocks_f64;
    const char *code, *float_code; /* whose instructions are counted: rows of cost_codes */
};

/* Ended by a target without a name. */
extern const struct cost_target cost_targets[];

/* The instructions of one operation of each kind, as a compiler makes them. `overhead` is what a
 * whole image takes beside its operations (calls, loops, copies, sets), for each ray, shadow ray
 * and boundary. */
struct cost_code {
    const char *name, *arithmetic;
    double instructions[COST_KINDS];
    double overhead;
};

/* Measured: `make cost-instructions` prints the instructions, tests/cost/whole.sh the counts that
 * show the overhead. Ended by a row without a name. */
extern const struct cost_code cost_codes[];

/* Predicts the instructions of a rendering in an image of such code. Returns NaN where there is no
 * row for the code and arithmetic. */
double cost_instructions(const char *code, const char *arithmetic, const struct cost_events *events,
                         const struct cost_mix *mix);

/* The work of a rendering, for the predictions. */
struct cost_work {
    struct cost_events events;
    struct cost_mix mix;
    uint64_t port_writes;
};

/* Predicts the seconds of a rendering; NaN where the target has no entry for that arithmetic. */
double cost_seconds(const struct cost_target *target, const char *arithmetic,
                    const struct cost_work *work);

#endif
