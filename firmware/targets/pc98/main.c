/* SPDX-License-Identifier: MIT */
/* The picture on a PC-9801: rows, progress on the text screen, Esc, and whether a board is there.
 */
#include "board_ports.h"
#include "image.h"
#include "machine.h"
#include "outp.h"
#include "scene.h"

enum { TITLE_ROW = 0, PROGRESS_ROW = 1, MESSAGE_ROW = 2 };

/* The build names them: -DTARGET_IMAGE=image_fx -DTARGET_SCENE=scene_fig3
 * -DTARGET_TITLE='"fig3"'. */
extern const struct image TARGET_IMAGE;
extern const struct scene TARGET_SCENE;

void pc98_main(void);

enum answer { ANSWER_UNKNOWN, ANSWER_RIGHT, ANSWER_WRONG };

struct run {
    const struct scene *scene;
    enum answer answer; /* of the board to what was drawn */
    bool is_ended;      /* by Esc */
    uint8_t last[3];    /* the dot that was drawn last */
};

/* Looks for the board by its own picture: what was drawn last must be read back. Reads leave the
 * trace of the writes as it is on every other target. An empty slot reads FFh, so a white dot tells
 * nothing. */
static void look_for_board(struct run *run) {
    uint16_t drawn = (uint16_t)(run->last[0] + run->last[1] + run->last[2]);
    if (run->answer != ANSWER_UNKNOWN || drawn == 3 * 0xFF) {
        return;
    }
    bool is_same = inp(BOARD_FACTORY_BASE + BOARD_RED) == run->last[0] &&
                   inp(BOARD_FACTORY_BASE + BOARD_GREEN) == run->last[1] &&
                   inp(BOARD_FACTORY_BASE + BOARD_BLUE) == run->last[2];
    run->answer = is_same ? ANSWER_RIGHT : ANSWER_WRONG;
    if (!is_same) {
        (void)text_put(MESSAGE_ROW, 0,
                       "No SuperFrame board answers at 00D0h; drawing all the same.");
    }
}

/* Notes the last dot of a line: the picture's last pixel, or the black to the right of the picture.
 */
static void note_last_dot(struct run *run, const uint8_t *rgb) {
    uint16_t width = TARGET_SCENE.width;
    bool is_full = width * board_dots_a_pixel(width, TARGET_SCENE.height) == BOARD_WIDTH;
    for (uint8_t i = 0; i < 3; i++) {
        run->last[i] = is_full ? rgb[3 * (width - 1) + i] : 0;
    }
}

static bool next_row(void *context, uint16_t y, uint8_t *rgb) {
    struct run *run = context;
    struct render_counts counts = {.rays = 0};
    if (y > 0) {
        look_for_board(run);
    }
    if (escape_pressed()) {
        run->is_ended = true;
        return false;
    }
    uint8_t column = text_put(PROGRESS_ROW, 0, "row ");
    column = text_put_number(PROGRESS_ROW, column, (uint16_t)(y + 1));
    column = text_put(PROGRESS_ROW, column, " of ");
    (void)text_put_number(PROGRESS_ROW, column, TARGET_SCENE.height);
    TARGET_IMAGE.row(run->scene, y, rgb, &counts);
    note_last_dot(run, rgb);
    return true;
}

/* Leaves the picture alone on the screen. Each key shows the text, or hides it again. */
static void show_without_text(void) {
    bool is_shown = false;
    text_show(is_shown);
    while (key_wait()) {
        is_shown = !is_shown;
        text_show(is_shown);
    }
}

void pc98_main(void) {
    struct scene scene = TARGET_SCENE;
    struct estimate estimate;
    struct run run = {.scene = &scene};
    const struct drawing drawing = {.base = BOARD_FACTORY_BASE,
                                    .last = TARGET_SCENE.height,
                                    .source = next_row,
                                    .context = &run};
    text_clear();
    (void)text_put(TITLE_ROW, 0, "superframe: " TARGET_TITLE "; Esc ends it");
    if (FEATURE_ESTIMATE && scene.estimates) {
        /* The radiance of pruned branches is learned before the first row. */
        struct render_counts counts = {.rays = 0};
        TARGET_IMAGE.learn(&TARGET_SCENE, &estimate, &counts);
        scene.estimate = &estimate;
    }
    TARGET_IMAGE.draw(&scene, &drawing);
    (void)text_put(PROGRESS_ROW, 0, run.is_ended ? "Ended by Esc.       " : "The picture is done.");
    if (!run.is_ended && run.answer != ANSWER_WRONG) {
        show_without_text();
    }
}
