/* SPDX-License-Identifier: MIT */
/* A multiple exposure: the emulated camera in front of the board's screen. */
#ifndef SUPERFRAME_EXPOSURES_H
#define SUPERFRAME_EXPOSURES_H

#include <stdbool.h>
#include <stdint.h>

#include "base/output.h"
#include "board/port_chain.h"
#include "render/render.h"

/* Eight 8-colour pictures, one for each bit, are photographed on one film; the k-th is exposed for
 * 2^k units of time. The film adds up: what all eight show at 255 is exposed 255 units long, and is
 * white. */
struct exposures {
    struct port_chain *chain;
    uint32_t film[PICTURE_BYTES]; /* level times 2^k, summed */
    uint8_t rgb[PICTURE_BYTES];   /* the developed picture */
    struct output kept[RENDER_EXPOSURES];
    char *names[RENDER_EXPOSURES];
    char *made_folder; /* the folder that was made; NULL: it was there before, or there is none */
    bool failed;       /* a picture could not be written; the reason is printed */
};

/* Returns the name of one of the kept pictures, 0..7, in new memory; NULL: out of memory. */
char *exposure_name(const char *folder, unsigned exposure);

/* Makes a camera with a blank film in front of the chain's board. folder: where each picture is
 * kept as exposure-0.png to exposure-7.png; NULL: nowhere. Returns NULL, with the reason printed,
 * if memory is out or the folder can't be written. Give the result to exposures_free(). */
struct exposures *exposures_new(struct port_chain *chain, const char *folder);

/* Photographs what the board shows now; a render_job's `exposed`. context is the struct
 * exposures. */
void exposures_take(void *context, unsigned exposure);

/* Puts the kept pictures into their places. False, with the reason printed, if one can't be. */
bool exposures_commit(struct exposures *exposures);

/* Develops the film into exposures->rgb. */
void exposures_develop(struct exposures *exposures);

/* Gives up what was not committed. Harmless on NULL. */
void exposures_free(struct exposures *exposures);

#endif
