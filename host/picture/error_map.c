/* SPDX-License-Identifier: MIT */
/* A picture of where two pictures differ, and by how much. */
#include "picture/error_map.h"

/* One LSB is what rounding makes, and is to be told at once from more. */
const struct difference_step difference_steps[DIFFERENCE_STEPS] = {
    {0, {0, 0, 0}, "black"},      {1, {0, 0, 170}, "blue"}, {2, {0, 170, 0}, "green"},
    {4, {255, 220, 0}, "yellow"}, {9, {230, 0, 0}, "red"},  {33, {255, 255, 255}, "white"}};

void difference_picture(const uint8_t *a, const uint8_t *b, size_t pixels, uint8_t *rgb) {
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        unsigned worst = 0;
        for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
            unsigned off = a[i] > b[i] ? (unsigned)(a[i] - b[i]) : (unsigned)(b[i] - a[i]);
            worst = off > worst ? off : worst;
        }
        int step = DIFFERENCE_STEPS - 1;
        while (worst < difference_steps[step].from) {
            step--;
        }
        for (int i = 0; i < 3; i++) {
            rgb[3 * pixel + (size_t)i] = difference_steps[step].rgb[i];
        }
    }
}
