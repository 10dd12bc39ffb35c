/* SPDX-License-Identifier: MIT */
/* What a scene requires of an image of the firmware, as a feature_set.h and as assertions. */
#ifndef SUPERFRAME_EMIT_FEATURES_H
#define SUPERFRAME_EMIT_FEATURES_H

#include <stdio.h>

#include "compiler/tables.h"

/* Return true if paths go through a transparent material, the air apart; or into one whose three
 * indices differ. */
bool features_has_transparency(const struct compiled_scene *scene);
bool features_has_dispersion(const struct compiled_scene *scene);

/* Words of a primitive set that the scene fills, at least one. */
int features_primitive_words(const struct compiled_scene *scene);

/* Writes a feature_set.h with which an image holds what the scene requires and nothing else; name
 * goes into its first comment. 0, or -1 where writing failed. */
int features_emit(FILE *out, const struct compiled_scene *scene, const char *name);

/* Writes an assertion for each feature that the scene requires: a compiler that builds the tables
 * for an image that lacks one stops there, at an array called image_lacks_ and the feature. */
void features_emit_assertions(FILE *out, const struct compiled_scene *scene);

/* Calls take() with each feature, in the order of feature_set.h, and what the scene requires of it:
 * 0 is nothing. */
void features_tell(const struct compiled_scene *scene,
                   void (*take)(void *context, const char *name, int value), void *context);

#endif
