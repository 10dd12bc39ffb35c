/* SPDX-License-Identifier: MIT */
/* Renders for the paper: a built-in scene, changed where a claim needs it, on the emulated board.
 */
#include "lab/paper/paper.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "board_ports.h"
#include "scene/load.h"

const uint8_t *paper_pixel(const struct paper_photo *photo, unsigned x, unsigned y) {
    return &photo->rgb[((size_t)y * photo->dots * PICTURE_WIDTH + x * photo->dots) * 3];
}

/* ---- Changes -------------------------------------------------------------------------------- */

static void swap_pattern(struct scene_material *material) {
    for (int i = 0; i < 3 && material->pattern.present; i++) {
        double colour = material->colour[i];
        material->colour[i] = material->pattern.colour[i];
        material->pattern.colour[i] = colour;
    }
}

/* Returns the material of a solid's first part that names one; -1: none does. Children have lower
 * numbers than their parents, so the walk ends. */
static int material_of(const struct scene_description *scene, int node) {
    int material = scene->nodes[node].material;
    while (material < 0 && scene->nodes[node].child_count > 0) {
        node = scene->nodes[node].children[0];
        material = scene->nodes[node].material;
    }
    return material;
}

static bool is_transparent(const struct scene_description *scene,
                           const struct scene_object *object) {
    int material = material_of(scene, object->solid);
    return material >= 0 && scene->materials[material].transparent;
}

/* Tells whether the change leaves an object in the scene. */
static bool stays(const struct paper_shot *shot, const struct scene_description *scene,
                  const struct scene_object *object) {
    switch (shot->change) {
    case PAPER_OUTLINE:
        return strcmp(object->name, shot->object) == 0;
    case PAPER_GLASS_OUTLINE:
        return is_transparent(scene, object);
    case PAPER_BARE:
    case PAPER_BARE_SWAPPED:
        return !is_transparent(scene, object);
    default:
        return true;
    }
}

/* Moves the objects that stay to the front; returns how many they are. */
static size_t keep_objects(const struct paper_shot *shot, struct scene_description *scene) {
    size_t kept = 0;
    for (size_t i = 0; i < scene->object_count; i++) {
        if (stays(shot, scene, &scene->objects[i])) {
            struct scene_object object = scene->objects[i];
            scene->objects[i] = scene->objects[kept];
            scene->objects[kept++] = object;
        }
    }
    return kept;
}

/* Makes a material white without any light, and opaque: nothing behind it is to be seen. */
static void make_silhouette(struct scene_material *material) {
    material->transparent = false;
    material->ambient = 1;
    material->ambient_is_own = true;
    material->diffuse = material->specular = 0;
    material->has_specular_table = false;
    material->pattern.present = false;
    material->casts_shadow = true;
    for (int i = 0; i < 3; i++) {
        material->colour[i] = 255;
        material->absorption[i] = 0;
    }
}

static void change_scene(const struct paper_shot *shot, struct scene_description *scene) {
    bool is_outline = shot->change == PAPER_OUTLINE || shot->change == PAPER_GLASS_OUTLINE;
    for (size_t i = 0; i < scene->material_count; i++) {
        if (is_outline) {
            make_silhouette(&scene->materials[i]);
        } else if (shot->change == PAPER_SWAPPED || shot->change == PAPER_BARE_SWAPPED) {
            swap_pattern(&scene->materials[i]);
        }
    }
    if (is_outline) {
        scene->depth = 0;
        scene->colour = COLOUR_FULL;
        memset(scene->background, 0, sizeof scene->background);
    }
}

/* Loads the shot's scene, changes and compiles it. NULL with *error filled on failure. */
static struct compiled_scene *compile_shot(const struct paper *paper, const struct paper_shot *shot,
                                           struct scene_error *error) {
    struct scene_description *scene = load_scene(shot->scene, error);
    if (scene == NULL) {
        return NULL;
    }
    scene_override(scene, &shot->overrides);
    scene->width = (int)(paper->width << shot->is_large);
    scene->height = (int)(paper->height << shot->is_large);
    size_t objects = scene->object_count;
    scene->object_count = keep_objects(shot, scene);
    change_scene(shot, scene);
    struct compiled_scene *compiled = scene_compile(scene, error);
    scene->object_count = objects; /* all of them are freed */
    scene_description_free(scene);
    return compiled;
}

/* ---- Rendering ------------------------------------------------------------------------------ */

/* Returns the processor time of this process with all its threads, in which the load of other
 * processes hardly shows. */
static double processor_seconds(void) {
    struct timespec used = {0, 0};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return (double)used.tv_sec + (double)used.tv_nsec * 1e-9;
}

/* A board, and the camera before its screen; NULL: there is none. */
struct studio {
    struct port_chain *chain;
    struct camera *camera;
};

static void take_exposure(void *context, unsigned exposure) {
    const struct studio *studio = context;
    port_chain_picture(studio->chain);
    camera_take(studio->camera, studio->chain->rgb, exposure);
}

static int render_shot(struct paper *paper, const struct compiled_scene *compiled,
                       struct studio *studio, struct render_totals *totals) {
    struct scene_error error;
    const struct render_job job = {.arithmetic = paper->arithmetic,
                                   .scene = compiled,
                                   .base = BOARD_FACTORY_BASE,
                                   .last_row = compiled->height,
                                   .jobs = paper->jobs,
                                   .stop = interrupt_noted(),
                                   .progress = progress_show_sum,
                                   .context = &paper->work,
                                   .exposed = studio->camera != NULL ? take_exposure : NULL,
                                   .exposed_context = studio};
    struct bus *bound = bus_bind(&studio->chain->hash.bus);
    double began = processor_seconds();
    bool is_rendered = render(&job, totals, &error);
    totals->seconds = processor_seconds() - began;
    (void)bus_bind(bound);
    paper->work.before = paper->work.now;
    if (!is_rendered) {
        return bad_input("%s", error.text);
    }
    if (*interrupt_noted() != 0) {
        complain("interrupted; nothing was written");
        return STATUS_SIGNAL + *interrupt_noted();
    }
    return STATUS_DONE;
}

static int shoot(struct paper *paper, const struct compiled_scene *compiled,
                 struct paper_photo *photo) {
    const struct board_desc desc = board_default_desc(BOARD_1987);
    const bool has_camera = compiled->show == SHOW_EXPOSURES;
    struct studio studio = {port_chain_new(&desc, true), has_camera ? camera_new(NULL) : NULL};
    int status = STATUS_FAILED;
    if (studio.chain == NULL || (has_camera && studio.camera == NULL)) {
        complain("out of memory");
    } else {
        status = render_shot(paper, compiled, &studio, &photo->totals);
    }
    if (status == STATUS_DONE) {
        photo->width = compiled->width;
        photo->height = compiled->height;
        photo->dots = board_dots_a_pixel(photo->width, photo->height);
        port_chain_picture(studio.chain);
        if (has_camera) {
            camera_develop(studio.camera);
        }
        memcpy(photo->rgb, has_camera ? studio.camera->rgb : studio.chain->rgb, PICTURE_BYTES);
    }
    camera_free(studio.camera);
    port_chain_free(studio.chain);
    return status;
}

int paper_shoot(struct paper *paper, const struct paper_shot *shot, struct paper_photo *photo) {
    struct scene_error error;
    memset(photo, 0, sizeof *photo);
    if (paper->is_planning) {
        paper->rows += paper->height << shot->is_large;
        return STATUS_DONE;
    }
    struct compiled_scene *compiled = compile_shot(paper, shot, &error);
    if (compiled == NULL) {
        return bad_input("%s", error.text);
    }
    int status = shoot(paper, compiled, photo);
    compiled_scene_free(compiled);
    return status;
}
