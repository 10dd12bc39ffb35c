/* SPDX-License-Identifier: MIT */
/* A multiple exposure: the emulated camera in front of the board's screen. */
#ifndef SUPERFRAME_CAMERA_H
#define SUPERFRAME_CAMERA_H

#include <stdbool.h>
#include <stdint.h>

#include "picture.h"
#include "picture/sink.h"
#include "render/render.h"

/* Eight 8-colour pictures, one for each bit, are photographed on one film; the k-th is exposed for
 * 2^k units of time. The film adds up: what all eight show at 255 is exposed 255 units long, and is
 * white. */
struct camera {
    uint32_t film[PICTURE_BYTES];                /* level times 2^k, summed */
    uint8_t rgb[PICTURE_BYTES];                  /* the developed picture */
    struct picture_sink *kept[RENDER_EXPOSURES]; /* NULL: not kept */
    char *names[RENDER_EXPOSURES];
    char *made_folder; /* the folder that was made; NULL: it was there before, or there is none */
    bool has_failed;   /* a picture could not be written; the reason is printed */
};

/* Returns the name of one of the kept pictures, 0..7, in new memory; NULL: out of memory. */
char *camera_exposure_name(const char *folder, unsigned exposure);

/* Makes a camera with a blank film. folder: where each picture is kept as exposure-0.png to
 * exposure-7.png; NULL: nowhere. Returns NULL, with the reason printed, if memory is out or the
 * folder can't be written. Give the result to camera_free(). */
struct camera *camera_new(const char *folder);

/* Photographs a screen of PICTURE_BYTES as exposure 0..7. */
void camera_take(struct camera *camera, const uint8_t *screen, unsigned exposure);

/* Puts the kept pictures into their places. False, with the reason printed, if one can't be. */
bool camera_commit(struct camera *camera);

/* Develops the film into camera->rgb. */
void camera_develop(struct camera *camera);

/* Frees the camera, and gives up what was not committed. Harmless on NULL. */
void camera_free(struct camera *camera);

#endif
