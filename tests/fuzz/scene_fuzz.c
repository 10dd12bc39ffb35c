/* SPDX-License-Identifier: MIT */
/* Fuzzes the way of a scene's text through reader and compiler to three rows in fx and f32, the
 * latter in both forms of sets: it is refused in lines that name the file or show it, or no ray
 * leaks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "render/arithmetic.h"

enum {
    WIDTH_MOST = 16,
    HEIGHT_MOST = 12,
    DEPTH_MOST = 5,
    ROWS = 3,
    INTENSITY_MOST = 32768,
    INSTANCES_MOST = 4000,     /* parts of parts may be a million solids, which take their time */
    SOLID_TESTS_MOST = 1000000 /* no further row is begun beyond these: 128 lights cost time */
};

static const char path[] = "fuzz.scene";

static void check_refusal(const struct scene_error *error) {
    const char *line = error->text, *end;
    unsigned refusals = 0;
    assert(*line != ' ');
    for (; line != NULL; line = end) {
        end = strchr(line, '\n');
        end = end == NULL ? NULL : end + 1;
        if (*line != ' ') {
            refusals++;
            assert(strncmp(line, path, sizeof path - 1) == 0 && line[sizeof path - 1] == ':');
        }
        for (; *line != '\n' && *line != '\0'; line++) {
            assert((unsigned char)*line >= 0x20 && *line != 0x7F);
        }
    }
    assert(refusals <= SCENE_REFUSALS_MOST && strlen(error->text) < sizeof error->text - 1);
}

/* Checks that the pixels of a row are numbers; a NaN would be black on the board. */
static void check_intensities(const struct scene *scene, const struct compiled_scene *compiled,
                              const struct arithmetic *arithmetic, unsigned y) {
    struct render_counts counts = {0};
    for (unsigned x = 0; x < compiled->width; x++) {
        double intensity[3];
        arithmetic->pixel(scene, (uint16_t)x, (uint16_t)y, intensity, &counts, NULL);
        for (int i = 0; i < 3; i++) {
            assert(intensity[i] >= 0 && intensity[i] <= INTENSITY_MOST);
        }
    }
}

static void draw(const struct compiled_scene *compiled, const struct arithmetic *arithmetic) {
    struct scene_error error = {""};
    struct render_counts counts = {0};
    uint8_t rgb[3 * WIDTH_MOST];
    struct scene *scene = arithmetic->load(compiled, &error);
    if (scene == NULL) {
        check_refusal(&error);
        return;
    }
    for (unsigned i = 0; i < ROWS && counts.solid_tests < SOLID_TESTS_MOST; i++) {
        arithmetic->image->row(scene, (uint16_t)((compiled->height - 1U) * i / (ROWS - 1)), rgb,
                               &counts);
    }
    check_intensities(scene, compiled, arithmetic, compiled->height / 2U);
    assert(counts.rays >= compiled->width);
    assert(counts.leaked_rays == 0);
    free(scene);
}

static int least(int a, int b) {
    return a < b ? a : b;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    struct scene_error error = {""};
    struct scene_description *description =
        scene_description_read(path, (const char *)bytes, count, &error);
    if (description == NULL) {
        check_refusal(&error);
        return 0;
    }
    description->width = least(description->width, WIDTH_MOST);
    description->height = least(description->height, HEIGHT_MOST);
    description->depth = least(description->depth, DEPTH_MOST);
    struct compiled_scene *compiled = NULL;
    if (description->instances <= INSTANCES_MOST) {
        compiled = scene_compile(description, &error);
        if (compiled == NULL) {
            check_refusal(&error);
        }
    }
    if (compiled != NULL) {
        draw(compiled, &arithmetic_fx);
        draw(compiled, &arithmetic_f32);
        draw(compiled, &arithmetic_f32_many);
        compiled_scene_free(compiled);
    }
    scene_description_free(description);
    return 0;
}
