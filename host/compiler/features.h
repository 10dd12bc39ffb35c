/* SPDX-License-Identifier: MIT */
/* What a scene requires of an image of the firmware, as a feature_set.h and as assertions. */
#ifndef SUPERFRAME_EMIT_FEATURES_H
#define SUPERFRAME_EMIT_FEATURES_H

#include <stdio.h>

#include "compiler/tables.h"

/* Tells whether paths go through a transparent material; the air around does not count. */
bool features_has_transparency(const struct compiled_scene *scene);

/* Tells whether paths go into a material whose three indices of refraction differ. */
bool features_has_dispersion(const struct compiled_scene *scene);

/* Returns how many words of a primitive set the scene fills, at least one. */
uint32_t features_primitive_words(const struct compiled_scene *scene);

/* Writes a feature_set.h with which an image holds what the scene requires and nothing else. The
 * name goes into the first comment of the file. Returns 0, or -1 where writing failed. */
int features_emit(FILE *out, const struct compiled_scene *scene, const char *name);

/* Writes an assertion for each feature that the scene requires. A compiler that builds the tables
 * for an image without the feature stops at an array named image_lacks_FEATURE_ and the feature. */
void features_emit_assertions(FILE *out, const struct compiled_scene *scene);

/* Calls take() with each feature, in the order of feature_set.h, and with what the scene requires
 * of the feature: 0 is nothing. */
void features_tell(const struct compiled_scene *scene,
                   void (*take)(void *context, const char *name, int value), void *context);

#endif
