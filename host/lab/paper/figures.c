/* SPDX-License-Identifier: MIT */
/* The table of the paper's figures, and their rendering. */
#include "lab/paper/paper.h"

#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "scene/load.h"

/* In the paper's order. A scene that is not built in is left out of all results. */
const struct paper_figure paper_figures[] = {
    {"fig3a",
     "Fig. 3 (a)",
     "Three nested cubes of glass over a striped board at N = 5: the middle is dull, the board is "
     "not to be seen through it.",
     {.scene = "fig3", .overrides = {.has_depth = true, .depth = 5}}},
    {"fig3b",
     "Fig. 3 (b)",
     "The same at N = 10: the board shows through all ten boundaries.",
     {.scene = "fig3", .overrides = {.has_depth = true, .depth = 10}}},
    {"fig4a",
     "Fig. 4 (a)",
     "Three nested hollow cubes and a ball, N = 15, 640 x 400.",
     {.scene = "fig4a", .is_large = true}},
    {"fig4b",
     "Fig. 4 (b)",
     "The same without the outer cube, N = 10, 640 x 400.",
     {.scene = "fig4b", .is_large = true}},
    {"fig5",
     "Fig. 5",
     "A wineglass with an opaque ball and a transparent cube in a glass parallelepiped.",
     {.scene = "fig5"}},
    {"fig6a",
     "Fig. 6 (a)",
     "A wineglass with two different balls, in the 8 digital colours by a random dither.",
     {.scene = "fig6a"}},
    {"fig6b",
     "Fig. 6 (b)",
     "The same inside a transparent cover with a cavity.",
     {.scene = "fig6b"}},
    {"fig7-isolated",
     "Fig. 7, lowest curve",
     "The model of the lowest curve: two transparent objects that stand apart.",
     {.scene = "fig7-isolated"}},
    {"fig7-frustum",
     "Fig. 7, second curve",
     "The model of the second curve: a frustum of a pyramid with a cavity.",
     {.scene = "fig7-frustum"}},
    {"figA-4bits",
     "Fig. A, 4 bits",
     "Opaque, glossy objects with R, G and B cut to their upper 4 bits: bands.",
     {.scene = "figA", .overrides = {.has_colour = true, .colour = COLOUR_BITS, .colour_bits = 4}}},
    {"figA-5bits",
     "Fig. A, 5 bits",
     "The same with 5 bits: finer bands.",
     {.scene = "figA", .overrides = {.has_colour = true, .colour = COLOUR_BITS, .colour_bits = 5}}},
    {"figA-8bits",
     "Fig. A, 8 bits",
     "The same with all 8 bits.",
     {.scene = "figA", .overrides = {.has_colour = true, .colour = COLOUR_BITS, .colour_bits = 8}}},
    {NULL, NULL, NULL, {.scene = NULL}}};

int paper_make_figures(struct paper *paper) {
    int status = STATUS_DONE;
    for (int i = 0; paper_figures[i].file != NULL && status == STATUS_DONE; i++) {
        if (!scene_is_builtin(paper_figures[i].shot.scene)) {
            continue;
        }
        if (paper->figures[i] == NULL) {
            paper->figures[i] = malloc(sizeof *paper->figures[i]);
        }
        if (paper->figures[i] == NULL) {
            return failure("out of memory");
        }
        status = paper_shoot(paper, &paper_figures[i].shot, paper->figures[i]);
    }
    return status;
}

const struct paper_photo *paper_photo_of(const struct paper *paper, const char *file) {
    for (int i = 0; paper_figures[i].file != NULL; i++) {
        if (strcmp(paper_figures[i].file, file) == 0) {
            return paper->figures[i];
        }
    }
    return NULL;
}
