/* SPDX-License-Identifier: MIT */
/* Fig. 7: cost against the depth level, and both readings of the formula. */
#include "lab/paper/curves.h"

#include <math.h>

#include "base/complain.h"
#include "scene/load.h"

/* From the lowest curve of the paper's figure to the highest two. */
static const char *const scenes[PAPER_CURVES][2] = {
    {"fig7-isolated", "two objects apart"},
    {"fig7-frustum", "frustum with a cavity"},
    {"fig4a", "nested cubes and ball (Fig. 4a)"},
    {"fig5", "wineglass in a parallelepiped (Fig. 5)"},
};

const char *paper_cost_name(enum paper_cost cost) {
    return cost == PAPER_RAYS ? "rays" : "solid tests";
}

const double *paper_costs(const struct paper_curve *curve, enum paper_cost cost) {
    return cost == PAPER_RAYS ? curve->rays : curve->tests;
}

static int make_curve(struct paper *paper, struct paper_curve *curve) {
    int status = STATUS_DONE;
    for (int depth = 0; depth < PAPER_DEPTHS && status == STATUS_DONE; depth++) {
        const struct paper_shot shot = {.scene = curve->scene,
                                        .overrides = {.has_depth = true, .depth = depth}};
        struct paper_photo *photo = paper->scratch[0];
        status = paper_shoot(paper, &shot, photo);
        curve->rays[depth] = (double)(photo->totals.rays + photo->totals.shadow_rays);
        curve->tests[depth] = (double)photo->totals.solid_tests;
    }
    return status;
}

int paper_make_curves(struct paper *paper) {
    int status = STATUS_DONE;
    for (int i = 0; i < PAPER_CURVES && status == STATUS_DONE; i++) {
        struct paper_curve *curve = &paper->curves[i];
        curve->scene = scenes[i][0];
        curve->label = scenes[i][1];
        curve->is_made = scene_is_builtin(curve->scene);
        if (curve->is_made) {
            status = make_curve(paper, curve);
        }
    }
    return status;
}

struct paper_fit paper_fit_curve(const struct paper_curve *curve, enum paper_cost cost,
                                 enum paper_reading reading) {
    const double *costs = paper_costs(curve, cost);
    double depths[PAPER_DEPTHS], values[PAPER_DEPTHS];
    for (int i = 0; i < PAPER_DEPTHS; i++) {
        double relative = costs[i] / costs[0];
        depths[i] = i;
        values[i] = reading == PAPER_READING_RATIO ? relative : log10(relative) + 1;
    }
    return paper_fit_form(depths, values, PAPER_DEPTHS);
}
