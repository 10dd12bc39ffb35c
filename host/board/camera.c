/* SPDX-License-Identifier: MIT */
/* A multiple exposure: the emulated camera in front of the board's screen. */
#include "board/camera.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/path.h"
#include "png_file.h"

enum { FULL_EXPOSURE = 255, NEW_FOLDER_MODE = 0777 };

char *exposure_name(const char *folder, unsigned exposure) {
    char name[32];
    (void)snprintf(name, sizeof name, "exposure-%u.png", exposure);
    return path_join(folder, name);
}

static bool make_folder(struct exposures *exposures, const char *folder) {
    if (mkdir(folder, NEW_FOLDER_MODE) == 0) {
        exposures->made_folder = malloc(strlen(folder) + 1);
        if (exposures->made_folder != NULL) {
            strcpy(exposures->made_folder, folder);
            interrupt_guard(exposures->made_folder);
        }
        return true;
    }
    if (errno != EEXIST) {
        complain("%s: cannot be made: %s", folder, strerror(errno));
        return false;
    }
    return true;
}

static void drop_folder(struct exposures *exposures) {
    interrupt_release(exposures->made_folder);
    free(exposures->made_folder);
    exposures->made_folder = NULL;
}

/* Opens all eight before the work begins: a place that can't be written is known at once. */
static bool open_kept(struct exposures *exposures, const char *folder) {
    if (!make_folder(exposures, folder)) {
        return false;
    }
    for (unsigned i = 0; i < RENDER_EXPOSURES; i++) {
        exposures->names[i] = exposure_name(folder, i);
        if (exposures->names[i] == NULL) {
            complain("out of memory");
            return false;
        }
        if (!output_open(&exposures->kept[i], exposures->names[i])) {
            return false;
        }
    }
    return true;
}

struct exposures *exposures_new(struct port_chain *chain, const char *folder) {
    struct exposures *exposures = calloc(1, sizeof *exposures);
    if (exposures == NULL) {
        complain("out of memory");
        return NULL;
    }
    exposures->chain = chain;
    if (folder != NULL && !open_kept(exposures, folder)) {
        exposures_free(exposures);
        return NULL;
    }
    return exposures;
}

void exposures_take(void *context, unsigned exposure) {
    struct exposures *exposures = context;
    struct port_chain *chain = exposures->chain;
    struct output *kept = &exposures->kept[exposure];
    port_chain_picture(chain);
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        exposures->film[i] += (uint32_t)chain->rgb[i] << exposure;
    }
    struct png_error error;
    if (kept->file != NULL &&
        write_png(kept->file, chain->rgb, PICTURE_WIDTH, PICTURE_HEIGHT, &error) != PNG_OK) {
        output_complain(kept, error.message);
        exposures->failed = true;
    }
}

bool exposures_commit(struct exposures *exposures) {
    for (unsigned i = 0; i < RENDER_EXPOSURES && !exposures->failed; i++) {
        exposures->failed = exposures->kept[i].file != NULL && !output_commit(&exposures->kept[i]);
    }
    if (!exposures->failed) {
        drop_folder(exposures); /* the folder stays */
    }
    return !exposures->failed;
}

void exposures_develop(struct exposures *exposures) {
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        exposures->rgb[i] = (uint8_t)((exposures->film[i] + FULL_EXPOSURE / 2) / FULL_EXPOSURE);
    }
}

void exposures_free(struct exposures *exposures) {
    if (exposures == NULL) {
        return;
    }
    for (unsigned i = 0; i < RENDER_EXPOSURES; i++) {
        output_discard(&exposures->kept[i]);
        free(exposures->names[i]);
    }
    if (exposures->made_folder != NULL) {
        (void)rmdir(exposures->made_folder); /* removes the folder only if it is empty */
        drop_folder(exposures);
    }
    free(exposures);
}
