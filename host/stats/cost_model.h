/* SPDX-License-Identifier: MIT */
/* Seconds that a rendering would take on a machine, from what it did. */
#ifndef SUPERFRAME_COST_MODEL_H
#define SUPERFRAME_COST_MODEL_H

#include <stdint.h>

#include "compiler/tables.h"

/* Kinds of operations: as many as enum wrap_kind of firmware/real/lab/wrap_kinds.h has, in its
 * order; tests/cost/operations.c holds the two numbers against each other. */
enum { COST_KINDS = 13 };

/* What a rendering did. */
struct cost_events {
    uint64_t rays, shadow_rays, nodes, solid_tests;
};

/* Which share of a ray's tests is against what; the sum is 1 (all 0: no primitives). */
struct cost_mix {
    double box, turned_box, ball, polyhedron_plane, quadric;
};

/* Each primitive of the scene counts alike; a polyhedron as one test of all its planes, so that
 * its share is multiplied by their number. */
struct cost_mix cost_mix_of(const struct compiled_scene *scene);

/* What is counted of one event: operations by kind, on average. */
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

/* Operations by kind of a whole rendering. */
void cost_operations_of(const struct cost_events *events, const struct cost_mix *mix,
                        double operations[COST_KINDS]);

/* A machine and what it takes. */
struct cost_target {
    const char *name, *label;
    double megahertz;
    const char *source; /* of clocks and frequency */
    double port_clocks; /* of one OUT, or of one store to an adapter */
    /* What one instruction of an image in that arithmetic takes on average; 0: no entry. */
    double clocks_fx, clocks_f32, clocks_f64;
    const char *code, *float_code; /* whose instructions are counted: rows of cost_codes */
};

/* Ended by one without a name. */
extern const struct cost_target cost_targets[];

/* Instructions of one operation of each kind, as a compiler makes them, and what a whole image
 * takes beside its operations (calls, loops, copies, sets) for each ray, shadow ray and boundary.
 */
struct cost_code {
    const char *name, *arithmetic;
    double instructions[COST_KINDS];
    double overhead;
};

/* Measured: `make cost-instructions` prints the instructions, tests/cost/whole.sh what shows the
 * overhead. Ended by one without a name. */
extern const struct cost_code cost_codes[];

/* Instructions of a rendering in an image of such code; NaN where there is no row for it. */
double cost_instructions(const char *code, const char *arithmetic, const struct cost_events *events,
                         const struct cost_mix *mix);

/* What a rendering did, for the predictions. */
struct cost_work {
    struct cost_events events;
    struct cost_mix mix;
    uint64_t port_writes;
};

/* Seconds; NaN where there is no entry for that arithmetic. */
double cost_seconds(const struct cost_target *target, const char *arithmetic,
                    const struct cost_work *work);

#endif
