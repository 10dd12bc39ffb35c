/* SPDX-License-Identifier: MIT */
/* The image: rows of a picture, and their way to the board. */
#include "image.h"

#include "board_driver.h"
#include "board_ports.h"
#include "camera.h"
#include "learn.h"
#include "show.h"
#include "tree.h"

#define IMAGE_TEXT(name)    IMAGE_TEXT_(name)
#define IMAGE_TEXT_(name)   #name
#define IMAGE_SYMBOL(name)  IMAGE_SYMBOL_(name)
#define IMAGE_SYMBOL_(name) image_##name

static void image_row(const struct scene *scene, uint16_t y, uint8_t *rgb,
                      struct render_counts *counts) {
    for (uint16_t x = 0; x < scene->width; x++) {
        const struct ray ray = camera_ray(scene, x, y);
        uint32_t worst = counts->estimated_error;
        struct colours colour = tree_colour(scene, &ray, counts, 0);
        if (counts->estimated_error > worst) {
            counts->worst_x = x;
            counts->worst_y = y;
        }
        *rgb++ = colour_level(colour.red);
        *rgb++ = colour_level(colour.green);
        *rgb++ = colour_level(colour.blue);
    }
}

static void draw_rows(const struct scene *scene, const struct drawing *drawing) {
    uint8_t rgb[3 * FEATURE_WIDTH];
    uint8_t dots = board_dots_a_pixel(scene->width, scene->height);
    uint16_t y = drawing->first;
    board_start(drawing->base);
    for (; y < drawing->last; y++) {
        if (drawing->source) {
            if (!drawing->source(drawing->context, y, rgb)) {
                return;
            }
        } else {
            struct render_counts ignored = {0};
            image_row(scene, y, rgb, &ignored);
        }
        if (FEATURE_SHOW) {
            show_row(scene, y, drawing->exposure, rgb);
        }
        if (FEATURE_SHOW && scene->show == SHOW_DITHER) {
            board_dots(drawing->base, y, rgb, scene->width);
        } else {
            board_row(drawing->base, y, rgb, scene->width, dots);
        }
    }
    if (y == scene->height) {
        board_blank(drawing->base, (uint16_t)(y * dots), BOARD_HEIGHT);
    }
}

static void image_draw(const struct scene *scene, const struct drawing *drawing) {
    if (!FEATURE_ESTIMATE || !scene->estimates || scene->estimate || drawing->source) {
        draw_rows(scene, drawing);
        return;
    }
    struct scene learned = *scene;
    struct estimate estimate;
    struct render_counts ignored = {0};
    learn_estimate(scene, &estimate, &ignored);
    learned.estimate = &estimate;
    draw_rows(&learned, drawing);
}

extern const struct image IMAGE_SYMBOL(REAL_NAME);

const struct image IMAGE_SYMBOL(REAL_NAME) = {IMAGE_TEXT(REAL_NAME), learn_estimate, image_row,
                                              image_draw};
