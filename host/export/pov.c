/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: settings, camera, lights, and the order of the file. */
#include <math.h>

#include "export/pov_internal.h"

/* POV-Ray's parallel light shines from a plane. The plane lies behind all of the world, which ends
 * at 1024 scaled units. */
#define LIGHT_DISTANCE 16384.0

/* POV-Ray visits no surface at all where adc_bailout is 1. */
#define BAILOUT_MOST 0.9999999

static void write_colour(FILE *out, const double levels[3]) {
    (void)fputs("rgb ", out);
    export_pov_vector(out, levels[0] / 255, levels[1] / 255, levels[2] / 255);
}

static void write_head(FILE *out, const struct scene_description *description,
                       const struct compiled_scene *scene) {
    export_pov_comment(out, description->title != NULL ? description->title : "");
    (void)fprintf(out,
                  "// For POV-Ray 3.7, made by superframe export. Coordinates: (those of the scene "
                  "file - centre) * 2^%d,\n// centre (%.17g, %.17g, %.17g). The picture that "
                  "superframe renders:\n//   povray +I<this file> +O<picture.png> +W%u +H%u -A -D "
                  "File_Gamma=1.0\n\n",
                  scene->exponent, scene->centre[0], scene->centre[1], scene->centre[2],
                  scene->width, scene->height);
    (void)fprintf(out,
                  "#version 3.7;\n"
                  "global_settings {\n"
                  "    assumed_gamma 1.0\n"
                  "    max_trace_level %d // the ray from the eye, and N = %d events after it\n"
                  "    adc_bailout %.17g\n"
                  "}\n",
                  scene->depth_asked + 1, scene->depth_asked, fmin(scene->threshold, BAILOUT_MOST));
    (void)fputs("background { ", out);
    write_colour(out, scene->background);
    (void)fputs(" }\n\n", out);
}

/* Writes a camera with the firmware's rays. Of dot (x, y) of a w x h picture, the firmware's ray is
 * forward + (2x+1-w) column + (2y+1-h) row. POV-Ray's ray is
 * direction + ((x+1/2)/w - 1/2) right + (1/2 - (y+1/2)/h) up. */
static void write_camera(FILE *out, const struct compiled_scene *scene) {
    const struct compiled_camera *camera = &scene->camera;
    double across = ldexp(2.0 * scene->width, -camera->shift);
    double down = -ldexp(2.0 * scene->height, -camera->shift);
    (void)fputs("camera {\n    perspective\n    location ", out);
    export_pov_vector(out, camera->eye[0], camera->eye[1], camera->eye[2]);
    (void)fputs("\n    direction ", out);
    export_pov_vector(out, camera->forward[0], camera->forward[1], camera->forward[2]);
    (void)fputs("\n    right ", out);
    export_pov_vector(out, camera->column[0] * across, camera->column[1] * across,
                      camera->column[2] * across);
    (void)fputs("\n    up ", out);
    export_pov_vector(out, camera->row[0] * down, camera->row[1] * down, camera->row[2] * down);
    (void)fputs("\n}\n\n", out);
}

static void write_lights(FILE *out, const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->light_count; i++) {
        const struct compiled_light *light = &scene->lights[i];
        (void)fputs("light_source {\n    ", out);
        if (light->parallel) {
            export_pov_vector(out, light->towards[0] * LIGHT_DISTANCE,
                              light->towards[1] * LIGHT_DISTANCE,
                              light->towards[2] * LIGHT_DISTANCE);
        } else {
            export_pov_vector(out, light->position[0], light->position[1], light->position[2]);
        }
        (void)fputs(", ", out);
        write_colour(out, light->colour);
        (void)fputs(light->parallel ? "\n    parallel\n    point_at <0, 0, 0>\n" : "\n", out);
        (void)fputs("    media_interaction off\n    media_attenuation off\n}\n", out);
    }
    (void)fputc('\n', out);
}

bool export_pov_write(FILE *out, const struct scene_description *description,
                      const struct compiled_scene *scene) {
    write_head(out, description, scene);
    write_camera(out, scene);
    write_lights(out, scene);
    export_pov_materials(out, description, scene);
    return export_pov_objects(out, description, scene);
}
