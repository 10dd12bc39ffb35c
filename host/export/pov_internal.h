/* SPDX-License-Identifier: MIT */
/* What the parts of the POV-Ray export share. */
#ifndef SUPERFRAME_EXPORT_POV_INTERNAL_H
#define SUPERFRAME_EXPORT_POV_INTERNAL_H

#include "export/pov.h"

/* Longest name of a material in the source, with its NUL. */
enum { POV_NAME_SIZE = 48 };

/* Makes the name of a compiled material from the material's own name and number. People find the
 * material by its own name; the number keeps any two names apart. */
void export_pov_material_name(const struct scene_description *description,
                              const struct compiled_scene *scene, uint32_t material,
                              char name[POV_NAME_SIZE]);

/* Prints <x, y, z> so that the doubles can be read back. */
static inline void export_pov_vector(FILE *out, double x, double y, double z) {
    (void)fprintf(out, "<%.17g, %.17g, %.17g>", x, y, z);
}

/* Prints text on one line of a comment. */
static inline void export_pov_comment(FILE *out, const char *text) {
    (void)fputs("// ", out);
    for (; *text != '\0'; text++) {
        unsigned char letter = (unsigned char)*text;
        (void)fputc(letter < 0x20 || letter == 0x7F ? ' ' : letter, out);
    }
    (void)fputc('\n', out);
}

/* Writes a #declare of every material that an object uses. */
void export_pov_materials(FILE *out, const struct scene_description *description,
                          const struct compiled_scene *scene);

/* Writes every object, in the order of the table; false if memory is out. */
bool export_pov_objects(FILE *out, const struct scene_description *description,
                        const struct compiled_scene *scene);

/* Tells whether a face of one object lies on a face of another somewhere within these bounds. */
bool export_pov_touch(const struct compiled_scene *scene, uint32_t a, uint32_t b,
                      const double low[3], const double high[3]);

/* Tells whether faces of two of an object's own solids lie on each other. False for an opaque
 * union, where such a seam does not matter. */
bool export_pov_has_seam(const struct compiled_scene *scene, uint32_t object);

#endif
