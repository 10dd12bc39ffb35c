/* SPDX-License-Identifier: MIT */
/* A scene as source for POV-Ray 3.7. */
#ifndef SUPERFRAME_EXPORT_POV_H
#define SUPERFRAME_EXPORT_POV_H

#include <stdbool.h>
#include <stdio.h>

#include "compiler/tables.h"

/* Tells whether POV-Ray can show the scene as it is. If not, *error names what POV-Ray can't show,
 * and where. The compiled scene has to be that of the description. */
bool export_pov_check(const struct scene_description *description,
                      const struct compiled_scene *scene, struct scene_error *error);

/* Writes a scene that passed export_pov_check(), in scaled coordinates; see docs/pov-export.md. The
 * numbers are exact: read back, they are the same doubles. Whether the writes succeeded is for
 * ferror() to say; false: memory is out. */
bool export_pov_write(FILE *out, const struct scene_description *description,
                      const struct compiled_scene *scene);

#endif
