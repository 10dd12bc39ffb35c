/* SPDX-License-Identifier: MIT */
/* One form of a scene, drawn in one arithmetic. */
#include "rendering.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "write.h"

/* ---- Reading and compiling ------------------------------------------------------------------ */

/* Maps the compiled materials to the syntax's by their names in the file, "m0", "m1". */
static void map_materials(struct form *form, const struct scene_description *description) {
    form->materials[0] = ORACLE_AIR;
    for (uint32_t i = 1; i < form->compiled->material_count; i++) {
        const char *name = description->materials[form->compiled->materials[i].file].name;
        form->materials[i] = (int)strtol(name + 1, NULL, 10);
    }
}

bool form_start(struct form *form, const struct syntax *syntax) {
    char *text = malloc(RENDERING_TEXT_MOST);
    struct scene_description *description = NULL;
    form->syntax = syntax;
    form->compiled = NULL;
    if (text == NULL || syntax->is_full || !write_scene(syntax, text, RENDERING_TEXT_MOST)) {
        (void)snprintf(form->error.text, sizeof form->error.text, "too large for the generator");
    } else {
        description = scene_description_read("scene", text, strlen(text), &form->error);
    }
    if (description != NULL) {
        description->error = syntax->error;
        form->compiled = scene_compile(description, &form->error);
        if (form->compiled != NULL) {
            map_materials(form, description);
        }
        scene_description_free(description);
    }
    free(text);
    return form->compiled != NULL;
}

void form_end(struct form *form) {
    compiled_scene_free(form->compiled);
    form->compiled = NULL;
}

/* ---- Signatures ----------------------------------------------------------------------------- */

/* A node as later ones need it: boundaries that are invisible hand on what came to them. */
struct node_note {
    uint64_t hash;
    uint8_t kind, channel, events;
    bool is_handed_on;
    double where[3];
};

struct painter {
    struct form *form;
    const struct oracle *oracle;
    int invisible, x, y;
    struct rendering *picture;
    struct rendering_pixel *pixel;
    bool is_empty;           /* nothing is in the pixel's way */
    struct node_note *notes; /* by the nodes' numbers */
    size_t note_room;
};

static uint64_t mixed(uint64_t hash, uint64_t value) {
    hash = (hash ^ value) * UINT64_C(0x9FB21C651E98DF25);
    return hash ^ hash >> 29;
}

static int seen_material(const struct painter *painter, int material) {
    return material == painter->invisible ? ORACLE_AIR : material;
}

static int material_of(const struct painter *painter, uint32_t object) {
    const struct compiled_scene *compiled = painter->form->compiled;
    return painter->form->materials[compiled->objects[object].material];
}

/* Adds a node to the pixel's signature. The sum does not depend on the order of nodes; entered or
 * left is which of the two materials is the air. */
static void sign(struct painter *painter, const struct observed_node *node,
                 struct node_note *note) {
    const struct node_note *parent = node->parent > 0 ? &painter->notes[node->parent] : NULL;
    int before = seen_material(painter, material_of(painter, node->before));
    int after = seen_material(painter, material_of(painter, node->after));
    bool inherits = parent != NULL && parent->is_handed_on;
    note->kind = inherits ? parent->kind : (uint8_t)node->kind;
    note->channel = inherits ? parent->channel : node->channel;
    note->is_handed_on = before == after;
    note->hash = parent != NULL ? parent->hash : UINT64_C(0x243F6A8885A308D3);
    if (!note->is_handed_on) {
        uint64_t step = (uint64_t)note->kind << 24 | (uint64_t)note->channel << 16 |
                        (uint64_t)(before + 2) << 8 | (uint64_t)(after + 2);
        note->hash = mixed(note->hash, step);
        painter->pixel->signature += note->hash;
    }
}

/* ---- The oracle ----------------------------------------------------------------------------- */

/* Beyond this, in scaled units, what has no end may be cut off. */
#define WORLD_SURE 1000.0

static bool is_in_world(const double p[3]) {
    return fabs(p[0]) < WORLD_SURE && fabs(p[1]) < WORLD_SURE && fabs(p[2]) < WORLD_SURE;
}

/* Asks the oracle about one point, which the renderer says is of that material. */
static void ask(struct painter *painter, const double p[3], int material, const char *what) {
    struct rendering *picture = painter->picture;
    if (picture->is_wrong || !is_in_world(p)) {
        return;
    }
    int found = oracle_material(painter->oracle, p);
    picture->segments += found != ORACLE_UNKNOWN;
    if (found == ORACLE_UNKNOWN || found == material) {
        return;
    }
    const struct compiled_scene *compiled = painter->form->compiled;
    picture->is_wrong = true;
    picture->wrong_x = painter->x;
    picture->wrong_y = painter->y;
    (void)snprintf(picture->wrong, sizeof picture->wrong,
                   "%s is m%d by the renderer, m%d by membership (-1: air), at %.6g %.6g %.6g",
                   what, material, found, ldexp(p[0], -compiled->exponent) + compiled->centre[0],
                   ldexp(p[1], -compiled->exponent) + compiled->centre[1],
                   ldexp(p[2], -compiled->exponent) + compiled->centre[2]);
}

static void ask_between(struct painter *painter, const double from[3], const double to[3],
                        int material, const char *what) {
    static const double shares[] = {0.5, 0.21, 0.83};
    for (int i = 0; i < 3; i++) {
        double p[3];
        for (int j = 0; j < 3; j++) {
            p[j] = from[j] + shares[i] * (to[j] - from[j]);
        }
        ask(painter, p, material, what);
    }
}

/* Beyond so many events, one in so many nodes is asked about: they are most, and much alike. */
enum { EVENTS_ALL = 2, EVERY = 4 };

static void ask_node(struct painter *painter, const struct observed_node *node) {
    const double *from =
        node->parent > 0 ? painter->notes[node->parent].where : painter->form->compiled->camera.eye;
    double behind[3];
    if (node->events > EVENTS_ALL && node->number % EVERY != 0) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        behind[i] = node->where[i] - 2.5 * painter->oracle->tolerance * node->normal[i];
    }
    ask_between(painter, from, node->where, material_of(painter, node->before), "a segment");
    if (oracle_is_smooth(painter->oracle, node->where, node->normal)) {
        ask(painter, behind, material_of(painter, node->after), "the place behind a boundary");
    }
}

/* Asks along an eye ray that leaves the scene; the ray is reckoned anew from the file's camera. */
static void ask_leaving(struct painter *painter) {
    const struct syntax *syntax = painter->form->syntax;
    double forward[3], right[3], up[3], to[3], length = 0, side = 0;
    for (int i = 0; i < 3; i++) {
        forward[i] = syntax->look_at[i] - syntax->eye[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        right[i] = forward[j] * syntax->up[k] - forward[k] * syntax->up[j];
        length += forward[i] * forward[i];
        side += right[i] * right[i];
    }
    double pitch = 2 * tan(syntax->field_of_view * 0.0087266462599716477) / syntax->width;
    double column = (painter->x + 0.5 - syntax->width / 2.0) * pitch;
    double row = (painter->y + 0.5 - syntax->height / 2.0) * pitch;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        up[i] = (right[j] * forward[k] - right[k] * forward[j]) / sqrt(side * length);
    }
    for (int n = 1; n <= 16; n++) {
        for (int i = 0; i < 3; i++) {
            double d = forward[i] / sqrt(length) + column * right[i] / sqrt(side) - row * up[i];
            to[i] = painter->form->compiled->camera.eye[i] + 100.0 * n * d;
        }
        ask(painter, to, ORACLE_AIR, "an eye ray that leaves");
    }
}

/* ---- Where paths end ------------------------------------------------------------------------ */

/* By this share a weight may be off the threshold: fx has steps of 2^-16 and more. */
#define THRESHOLD_OFF 0.03

static void tell(struct painter *painter, const char *what, int events, double weight) {
    struct rendering *picture = painter->picture;
    if (!picture->is_wrong) {
        picture->is_wrong = true;
        picture->wrong_x = painter->x;
        picture->wrong_y = painter->y;
        (void)snprintf(picture->wrong, sizeof picture->wrong,
                       "%s, after %d events, with a weight of %.6g; the scene has depth level %d "
                       "and threshold %.6g",
                       what, events, weight, painter->form->syntax->depth,
                       painter->form->syntax->threshold);
    }
}

static double largest(const double weight[3]) {
    return fmax(weight[0], fmax(weight[1], weight[2]));
}

/* Holds a path that goes on to what the file says of depth and threshold. A material may have
 * absorbed on the way here what it took to begin. */
static void check_going_on(struct painter *painter, const struct observed_node *node) {
    const struct syntax *syntax = painter->form->syntax;
    double weight = largest(node->weight);
    if (node->events > syntax->depth) {
        tell(painter, "a path goes on beyond the depth level", node->events, weight);
    }
    if (node->events > 0 && material_of(painter, node->before) == ORACLE_AIR &&
        weight < syntax->threshold * (1 - THRESHOLD_OFF)) {
        tell(painter, "a path goes on below the threshold", node->events, weight);
    }
}

/* Holds the end of a path to what the file says: nothing else ends a path. */
static void check_end(struct painter *painter, const struct observed_end *end) {
    const struct syntax *syntax = painter->form->syntax;
    double weight = largest(end->weight);
    int events = end->parent > 0 ? painter->notes[end->parent].events : 0;
    switch (end->why) {
    case OBSERVED_LEFT:
        break;
    case OBSERVED_DEPTH:
        if (events != syntax->depth) {
            tell(painter, "a path ends by its depth", events, weight);
        }
        break;
    case OBSERVED_THRESHOLD:
        if (weight > syntax->threshold * (1 + THRESHOLD_OFF)) {
            tell(painter, "a path ends by the threshold", events, weight);
        }
        break;
    case OBSERVED_NOTHING:
        if (weight > 0) {
            tell(painter, "a path ends as if it had no weight", events, weight);
        }
        break;
    case OBSERVED_BUDGET:
        tell(painter, "a path ends by a budget that the file does not have", events, weight);
        break;
    }
}

/* ---- Drawing -------------------------------------------------------------------------------- */

static void see_node(void *context, const struct observed_node *node) {
    struct painter *painter = context;
    if (node->number >= painter->note_room) {
        size_t room = 2 * (size_t)node->number + 64;
        struct node_note *larger = realloc(painter->notes, room * sizeof *larger);
        if (larger == NULL) {
            abort();
        }
        painter->notes = larger;
        painter->note_room = room;
    }
    struct node_note *note = &painter->notes[node->number];
    memcpy(note->where, node->where, sizeof note->where);
    note->events = node->events;
    sign(painter, node, note);
    check_going_on(painter, node);
    ask_node(painter, node);
}

static void see_end(void *context, const struct observed_end *end) {
    struct painter *painter = context;
    check_end(painter, end);
    if (end->why == OBSERVED_DEPTH) {
        painter->pixel->is_cut_by_depth = true;
    }
    if (end->why == OBSERVED_LEFT && end->kind == OBSERVED_EYE) {
        painter->is_empty = true;
        ask_leaving(painter);
    }
}

static void draw_pixel(struct painter *painter, const struct arithmetic *arithmetic,
                       const struct scene *scene) {
    struct rendering *picture = painter->picture;
    const struct pixel_observer observer = {painter, see_node, see_end};
    struct render_counts counts;
    double intensity[3];
    painter->pixel = &picture->pixels[painter->y * picture->width + painter->x];
    memset(painter->pixel, 0, sizeof *painter->pixel);
    memset(&counts, 0, sizeof counts);
    painter->is_empty = false;
    arithmetic->pixel(scene, (uint16_t)painter->x, (uint16_t)painter->y, intensity, &counts,
                      &observer);
    for (int i = 0; i < 3; i++) {
        painter->pixel->level[i] = (int)floor(fmin(fmax(intensity[i], 0), 255) + 0.5);
    }
    for (int i = 0; i < 3 && painter->is_empty; i++) {
        if (fabs(painter->pixel->level[i] - painter->form->syntax->background[i]) > 0.5) {
            tell(painter, "what shows nothing has not the background's colour", 0, 1);
        }
    }
    picture->leaked += counts.leaked_rays;
}

static double tolerance_of(const struct arithmetic *arithmetic) {
    bool is_coarse =
        strcmp(arithmetic->image->name, "fx") == 0 || strcmp(arithmetic->image->name, "f32") == 0;
    return is_coarse ? 0.05 : 0.002;
}

bool rendering_draw(struct form *form, const struct arithmetic *arithmetic, int invisible,
                    struct rendering *picture) {
    struct oracle *oracle = malloc(sizeof *oracle);
    arithmetic = arithmetic_for(arithmetic, form->compiled);
    struct scene *scene = arithmetic->load(form->compiled, &form->error);
    bool good =
        oracle != NULL && scene != NULL &&
        oracle_start(oracle, form->syntax, form->compiled->centre, form->compiled->exponent);
    if (good) {
        struct painter painter = {form, oracle, invisible, 0, 0, picture, NULL, false, NULL, 0};
        oracle->tolerance = tolerance_of(arithmetic);
        memset(picture, 0, sizeof *picture);
        picture->width = form->syntax->width;
        picture->height = form->syntax->height;
        for (painter.y = 0; painter.y < picture->height; painter.y++) {
            for (painter.x = 0; painter.x < picture->width; painter.x++) {
                draw_pixel(&painter, arithmetic, scene);
            }
        }
        free(painter.notes);
    }
    free(scene);
    free(oracle);
    return good;
}
