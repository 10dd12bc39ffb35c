/* SPDX-License-Identifier: MIT */
/* The table of the paper's claims. */
#include "lab/paper/claims.h"

#include <string.h>

#include "base/complain.h"
#include "scene/load.h"

enum { SCENES_MOST = 4 };

struct claim_entry {
    const char *title, *says;
    const char *scenes[SCENES_MOST + 1]; /* that are rendered for it; ended by NULL */
    int (*measure)(struct paper *paper, struct paper_claim *claim);
};

static const struct claim_entry entries[PAPER_CLAIMS] = {
    {"Fig. 3: depth level and transparency",
     "At N = 5 the middle looks dull and the striped board behind it cannot be made out; at N = 10 "
     "it is wholly visible.",
     {"fig3"},
     paper_claim_depth},
    {"Fig. 4: nested cubes",
     "The computing time of (a), N = 15, is more than 2 times that of (b), N = 10. In (b) the "
     "middle object is a dull red. The white ball looks coloured, and what it mirrors differs "
     "between the two.",
     {"fig4a", "fig4b"},
     paper_claim_nested},
    {"Fig. 6: the outer cover",
     "(b) takes about 3 times as long as (a), because of the cover.",
     {"fig6a", "fig6b"},
     paper_claim_cover},
    {"Fig. 7: cost against depth level",
     "The relative time against N follows log10(C1 N^C2 + 1) + 1 with whole numbers C1 and C2. The "
     "curves are ordered: two objects apart, the frustum, then the two of many objects. The time "
     "is not proportional to N.",
     {"fig7-isolated", "fig7-frustum", "fig4a", "fig5"},
     paper_claim_formula},
    {"Picture size",
     "640 x 400 takes about 4 times as long as 320 x 200, and the relative time hardly depends on "
     "the size.",
     {"fig7-frustum"},
     paper_claim_size},
    {"Depth level that is enough",
     "Transparency shows, but for a part of the board, once N is above 2 for simple models; 4 to 5 "
     "is enough for these; 10 for three nested cubes.",
     {"fig7-isolated", "fig7-frustum", "fig3"},
     paper_claim_visibility},
    {"Fig. A: Mach bands",
     "Bands are visible at 4 and 5 bits of each primary, and not at 8.",
     {"figA"},
     paper_claim_bands},
    {"The threshold",
     "A threshold on the product of reflectances and transmittances ends the search whatever N "
     "is.",
     {"fig3"},
     paper_claim_threshold},
    {"Multiple exposure",
     "Eight 8-colour pictures, each showing one bit of R, G and B, add up to the full-colour "
     "picture on one photograph (the weights 2^k are read in).",
     {"fig3"},
     paper_claim_exposures},
};

/* Finds a scene of a claim that is not built in; NULL: all are. */
static const char *find_missing(const struct claim_entry *entry) {
    const char *const *scene = entry->scenes;
    while (*scene != NULL && scene_is_builtin(*scene)) {
        scene++;
    }
    return *scene;
}

int paper_make_claims(struct paper *paper) {
    int status = STATUS_DONE;
    for (int i = 0; i < PAPER_CLAIMS && status == STATUS_DONE; i++) {
        struct paper_claim *claim = &paper->claims[i];
        memset(claim, 0, sizeof *claim);
        claim->title = entries[i].title;
        claim->says = entries[i].says;
        const char *missing = find_missing(&entries[i]);
        if (missing != NULL) {
            paper_say(claim->why, "The scene %s is not built in.", missing);
        } else {
            status = entries[i].measure(paper, claim);
        }
    }
    return status;
}
