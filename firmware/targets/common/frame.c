/* SPDX-License-Identifier: MIT */
/* One frame of the scene that a target was built for. */
#include "frame.h"

#include "board_ports.h"
#include "image.h"
#include "port_records.h"
#include "scene.h"

enum { EXPOSURES = 8 };

/* The build names both: -DTARGET_IMAGE=image_fx -DTARGET_SCENE=scene_fig3. */
extern const struct image TARGET_IMAGE;
extern const struct scene TARGET_SCENE;

/* Draws a multiple exposure eight times, whole: there is no memory for a picture to repeat. */
void frame_draw(void) {
    uint8_t drawings = TARGET_SCENE.show == SHOW_EXPOSURES ? EXPOSURES : 1;
    for (uint8_t i = 0; i < drawings; i++) {
        const struct drawing drawing = {
            .base = BOARD_FACTORY_BASE, .last = TARGET_SCENE.height, .exposure = i};
        TARGET_IMAGE.draw(&TARGET_SCENE, &drawing);
    }
    port_records_flush();
}
