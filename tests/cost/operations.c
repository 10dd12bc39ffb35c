/* SPDX-License-Identifier: MIT */
/* Counts the operations of a ray, a shadow ray, a boundary and a test of each kind of primitive. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "real/lab/wrap_kinds.h"
#include "render/arithmetic.h"
#include "scene/description.h"
#include "stats/cost_model.h"

/* Renders rows of one to six solids of a kind, some opaque, with the arithmetic that counts, and
 * solves by least squares for what each event takes, of all renderings together: their events are
 * known, and differ in their proportions. Prints the rows of cost_operations,
 * host/stats/cost_tables.c.
 */

extern const struct arithmetic arithmetic_count;

typedef char kinds_are_those_of_the_host[(int)COST_KINDS == (int)WRAP_KINDS ? 1 : -1];

uint64_t count_operations[WRAP_KINDS + 1];

enum { COPIES_MOST = 6, DEPTHS = 3, EACH = COPIES_MOST * DEPTHS, TEXT_SIZE = 16384 };

static const struct {
    const char *name, *solid;
    double units; /* of cost_operations in one test */
} kinds[] = {
    {"box", "box = { min = (-1, -1, -1); max = (1, 1, 1); };", 1},
    {"turned box", "box = { min = (-1, -1, -1); max = (1, 1, 1); };", 1},
    {"ball", "ball = { radius = 1.2; };", 1},
    {"plane",
     "polyhedron = { planes = ( { normal = [0, 0, -1]; offset = 1; }, { normal = [0, 0, 1]; "
     "offset = 1; }, { normal = [2, 0, 1]; offset = 1.3; }, { normal = [-2, 0, 1]; offset = 1.3; "
     "}, "
     "{ normal = [0, 2, 1]; offset = 1.3; }, { normal = [0, -2, 1]; offset = 1.3; } ); };",
     6},
    {"quadric", "ellipsoid = { radii = (1.3, 1, 1.1); };", 1},
};

enum { KINDS = sizeof kinds / sizeof kinds[0], ROWS = KINDS * EACH };

/* One rendering: its events and its operations. */
struct sample {
    double events[COST_EVENTS];
    double operations[WRAP_KINDS];
};

/* Turned boxes are turned by angles of their own: what turns alike is turned once for each ray. */
static void write_scene(char *text, int kind, int copies, int depth) {
    const int turn = COST_BOX + kind == COST_TURNED_BOX ? 7 : 0;
    size_t used = (size_t)snprintf(
        text, TEXT_SIZE,
        "version = 1; size = [48, 30]; depth = %d; threshold = 0.001;\n"
        "camera = { eye = (1, -14, 6); look_at = (0, 0, 0); field_of_view = 40; };\n"
        "lights = ( { direction = (-0.4, 0.5, -1.0); } );\n"
        "materials = { glass = { colour = [9, 9, 9]; diffuse = 0.2; specular = 0.4; gloss = 60; "
        "ior = 1.5; }; stone = { colour = [99, 99, 99]; diffuse = 0.7; }; };\nobjects = (\n",
        depth);
    for (int i = 0; i < copies; i++) {
        used += (size_t)snprintf(
            text + used, TEXT_SIZE - used,
            "%s{ material = \"%s\"; solid = { union = ( { %s } ); rotate = [%d, %d, "
            "%d]; translate = (%g, %g, %g); }; }\n",
            i > 0 ? "," : "", i % 3 == 1 ? "stone" : "glass", kinds[kind].solid, turn * (3 + i),
            turn * (4 + i), turn * (5 + i), 2.7 * (i % 3) - 2.5, 3.1 * (i / 3) - 1.3,
            0.3 * i - 0.5);
    }
    (void)snprintf(text + used, TEXT_SIZE - used, ");\n");
}

static bool take_sample(const char *text, int kind, struct sample *sample) {
    struct scene_error error = {""};
    struct render_counts counts;
    uint8_t rgb[3 * 640];
    memset(&counts, 0, sizeof counts);
    struct scene_description *description =
        scene_description_read("cost", text, strlen(text), &error);
    struct compiled_scene *compiled =
        description != NULL ? scene_compile(description, &error) : NULL;
    struct scene *scene = compiled != NULL ? arithmetic_count.load(compiled, &error) : NULL;
    bool is_made = scene != NULL;
    if (is_made) {
        memset(count_operations, 0, sizeof count_operations);
        for (uint16_t y = 0; y < compiled->height; y++) {
            arithmetic_count.image->row(scene, y, rgb, &counts);
        }
        sample->events[COST_RAY] = (double)counts.rays;
        sample->events[COST_SHADOW_RAY] = (double)counts.shadow_rays;
        sample->events[COST_NODE] = (double)counts.nodes;
        sample->events[COST_BOX + kind] = (double)counts.solid_tests * kinds[kind].units;
        for (int i = 0; i < WRAP_KINDS; i++) {
            sample->operations[i] = (double)count_operations[i];
        }
    } else {
        (void)fprintf(stderr, "%s\n", error.text);
    }
    free(scene);
    compiled_scene_free(compiled);
    scene_description_free(description);
    return is_made;
}

/* Least squares by the normal equations; each rendering weighs alike. */
static void solve(const struct sample *samples, int kind, double result[COST_EVENTS]) {
    double m[COST_EVENTS][COST_EVENTS + 1];
    memset(m, 0, sizeof m);
    for (int r = 0; r < ROWS; r++) {
        double weight = 1 / samples[r].events[COST_RAY];
        for (int i = 0; i < COST_EVENTS; i++) {
            double e = samples[r].events[i] * weight;
            for (int j = 0; j < COST_EVENTS; j++) {
                m[i][j] += e * samples[r].events[j] * weight;
            }
            m[i][COST_EVENTS] += e * samples[r].operations[kind] * weight;
        }
    }
    for (int i = 0; i < COST_EVENTS; i++) {
        for (int j = 0; j < COST_EVENTS; j++) {
            double factor = j == i ? 0 : m[j][i] / m[i][i];
            for (int k = i; k <= COST_EVENTS; k++) {
                m[j][k] -= factor * m[i][k];
            }
        }
    }
    for (int i = 0; i < COST_EVENTS; i++) {
        result[i] = m[i][COST_EVENTS] / m[i][i];
    }
}

static void print_row(const char *name, const double *row) {
    printf("    [COST_%s] = {", name);
    for (int i = 0; i < WRAP_KINDS; i++) {
        printf("%s%.2f", i > 0 ? ", " : "", row[i] > 0.005 ? row[i] : 0);
    }
    printf("},\n");
}

int main(void) {
    static const char *const names[] = {"RAY",        "SHADOW_RAY", "NODE",  "BOX",
                                        "TURNED_BOX", "BALL",       "PLANE", "QUADRIC"};
    static struct sample samples[ROWS];
    static char text[TEXT_SIZE];
    double table[COST_EVENTS][WRAP_KINDS];
    double worst = 0;
    memset(samples, 0, sizeof samples);
    for (int r = 0; r < ROWS; r++) {
        write_scene(text, r / EACH, 1 + r % COPIES_MOST, 1 + 3 * (r % EACH / COPIES_MOST));
        if (!take_sample(text, r / EACH, &samples[r])) {
            return 1;
        }
    }
    for (int operation = 0; operation < WRAP_KINDS; operation++) {
        double result[COST_EVENTS];
        solve(samples, operation, result);
        for (int i = 0; i < COST_EVENTS; i++) {
            table[i][operation] = result[i];
        }
        for (int r = 0; r < ROWS; r++) {
            double sum = 0, all = 0;
            for (int i = 0; i < COST_EVENTS; i++) {
                sum += result[i] * samples[r].events[i];
            }
            for (int i = 0; i < WRAP_KINDS; i++) {
                all += samples[r].operations[i];
            }
            worst = fmax(worst, fabs(sum - samples[r].operations[operation]) / all);
        }
    }
    for (int i = 0; i < COST_EVENTS; i++) {
        print_row(names[i], table[i]);
    }
    printf("/* largest residue: %.2f %% of a rendering's operations */\n", 100 * worst);
    return 0;
}
