/* SPDX-License-Identifier: MIT */
/* Prints the instructions that the cost model predicts: predict SCENE CODE ARITHMETIC */

/* CODE is a row of cost_codes: m0, m3, m4f, i386, i387, x86_64. What the rendering does comes from
 * standard input, as tests/cost/whole.sh prints it. */

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/load.h"
#include "stats/cost_model.h"

int main(int argc, char **argv) {
    struct scene_overrides overrides;
    struct scene_error error;
    struct cost_events events;
    memset(&overrides, 0, sizeof overrides);
    struct compiled_scene *scene =
        argc == 4 ? load_compiled_scene(argv[1], &overrides, &error) : NULL;
    if (scene == NULL ||
        scanf("nodes %" SCNu64 " rays %" SCNu64 " shadow_rays %" SCNu64 " solid_tests %" SCNu64,
              &events.nodes, &events.rays, &events.shadow_rays, &events.solid_tests) != 4) {
        fprintf(stderr, "usage: whole.sh ... | %s SCENE CODE ARITHMETIC\n", argv[0]);
        compiled_scene_free(scene);
        return 2;
    }
    struct cost_mix mix = cost_mix_of(scene);
    compiled_scene_free(scene);
    double instructions = cost_instructions(argv[2], argv[3], &events, &mix);
    printf("%.0f\n", instructions);
    return instructions > 0 ? 0 : 1;
}
