/* SPDX-License-Identifier: MIT */
/* Translation validation: checks the scene compiler's tables against the description. */
#ifndef SUPERFRAME_VALIDATE_H
#define SUPERFRAME_VALIDATE_H

#include "compiler/tables.h"

/* The outcome of one step. */
struct validation {
    unsigned points; /* samples that were compared between description and tables */
    unsigned near;   /* samples, object by object, that lay too near to a face to be judged */
    unsigned faults; /* whatever disagreed */
    char first[400]; /* the first fault in words: the object, its line, a place in the file's
                        coordinates */
};

/* Checks the tables after a step against the description, at a fixed set of sampled points, rays
 * and paths to lights. Compares which objects a point lies in, and checks whatever the step or
 * those before it claim. Those claims are bounds, reach, surfaces, what hides what, enclosures,
 * shadows and the eye. Returns true if nothing disagrees, and fills *validation in either case.
 * Faces nearer than 2^-26 of a scaled unit count as one place. A finished scene is at
 * STEP_ENCLOSURES. */
bool compiled_scene_agrees(const struct scene_description *description,
                           const struct compiled_scene *scene, enum compile_step step,
                           struct validation *validation);

/* An observer's context: one report a step, summed over all times that the step is taken. Steps
 * that were not reached stay at 0 points. */
struct validations {
    const struct scene_description *description;
    struct validation of[STEP_COUNT];
};

/* Checks a scene that is being compiled: struct compile_observer's `look`, for a context of struct
 * validations. */
void validations_look(void *context, enum compile_step step, const struct compiled_scene *scene);

/* Names a step in one word. */
const char *compile_step_name(enum compile_step step);

#endif
