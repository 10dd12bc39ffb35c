/* SPDX-License-Identifier: MIT */
/* A multiple exposure: the emulated camera in front of the board's screen. */
#include "board/camera.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/path.h"

enum { FULL_EXPOSURE = 255, NEW_FOLDER_MODE = 0777 };

char *camera_exposure_name(const char *folder, unsigned exposure) {
    char name[32];
    (void)snprintf(name, sizeof name, "exposure-%u.png", exposure);
    return path_join(folder, name);
}

static bool make_folder(struct camera *camera, const char *folder) {
    if (mkdir(folder, NEW_FOLDER_MODE) == 0) {
        camera->made_folder = malloc(strlen(folder) + 1);
        if (camera->made_folder != NULL) {
            strcpy(camera->made_folder, folder);
            interrupt_guard(camera->made_folder);
        }
        return true;
    }
    if (errno != EEXIST) {
        complain("%s: cannot be made: %s", folder, strerror(errno));
        return false;
    }
    return true;
}

static void drop_folder(struct camera *camera) {
    interrupt_release(camera->made_folder);
    free(camera->made_folder);
    camera->made_folder = NULL;
}

/* Opens all eight before the work begins: a place that can't be written is known at once. */
static bool open_kept(struct camera *camera, const char *folder) {
    if (!make_folder(camera, folder)) {
        return false;
    }
    for (unsigned i = 0; i < RENDER_EXPOSURES; i++) {
        camera->names[i] = camera_exposure_name(folder, i);
        if (camera->names[i] == NULL) {
            complain("out of memory");
            return false;
        }
        camera->kept[i] = png_sink_open(camera->names[i]);
        if (camera->kept[i] == NULL) {
            return false;
        }
    }
    return true;
}

struct camera *camera_new(const char *folder) {
    struct camera *camera = calloc(1, sizeof *camera);
    if (camera == NULL) {
        complain("out of memory");
        return NULL;
    }
    if (folder != NULL && !open_kept(camera, folder)) {
        camera_free(camera);
        return NULL;
    }
    return camera;
}

void camera_take(struct camera *camera, const uint8_t *screen, unsigned exposure) {
    const struct shown_picture picture = {screen, PICTURE_WIDTH, PICTURE_HEIGHT};
    struct picture_sink *kept = camera->kept[exposure];
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        camera->film[i] += (uint32_t)screen[i] << exposure;
    }
    if (kept != NULL && !kept->operations->show(kept, &picture)) {
        camera->has_failed = true;
    }
}

bool camera_commit(struct camera *camera) {
    for (unsigned i = 0; i < RENDER_EXPOSURES && !camera->has_failed; i++) {
        struct picture_sink *kept = camera->kept[i];
        camera->has_failed = kept != NULL && !kept->operations->commit(kept);
    }
    if (!camera->has_failed) {
        drop_folder(camera); /* the folder stays */
    }
    return !camera->has_failed;
}

void camera_develop(struct camera *camera) {
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        camera->rgb[i] = (uint8_t)((camera->film[i] + FULL_EXPOSURE / 2) / FULL_EXPOSURE);
    }
}

void camera_free(struct camera *camera) {
    if (camera == NULL) {
        return;
    }
    for (unsigned i = 0; i < RENDER_EXPOSURES; i++) {
        picture_sink_close(camera->kept[i]);
        free(camera->names[i]);
    }
    if (camera->made_folder != NULL) {
        (void)rmdir(camera->made_folder); /* removes the folder only if it is empty */
        drop_folder(camera);
    }
    free(camera);
}
