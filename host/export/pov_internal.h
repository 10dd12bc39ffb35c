/* SPDX-License-Identifier: MIT */
/* What the parts of the POV-Ray export share. */
#ifndef SUPERFRAME_EXPORT_POV_INTERNAL_H
#define SUPERFRAME_EXPORT_POV_INTERNAL_H

#include "export/pov.h"

/* Longest name of a material in the source, with its NUL. */
enum { POV_NAME_SIZE = 48 };

/* The name of a compiled material: its own, so that people find it, and its number, so that there
 * is one of it. */
void export_pov_material_name(const struct scene_description *description,
                              const struct compiled_scene *scene, uint8_t material,
                              char name[POV_NAME_SIZE]);

/* Prints <x, y, z> so that the doubles can be read back. */
void export_pov_vector(FILE *out, double x, double y, double z);

/* Prints text on one line of a comment. */
void export_pov_comment(FILE *out, const char *text);

/* #declare's every material that an object uses. */
void export_pov_materials(FILE *out, const struct scene_description *description,
                          const struct compiled_scene *scene);

/* Every object, in the order of the table. */
void export_pov_objects(FILE *out, const struct scene_description *description,
                        const struct compiled_scene *scene);

/* Whether a face of one object lies on a face of another somewhere within these bounds. */
bool export_pov_touch(const struct compiled_scene *scene, uint8_t a, uint8_t b, const double low[3],
                      const double high[3]);

/* Whether faces of two of an object's own solids lie on each other, so that it matters. */
bool export_pov_has_seam(const struct compiled_scene *scene, uint8_t object);

#endif
