/* SPDX-License-Identifier: MIT */
/* One pixel of an image of the firmware as a host sees it: in doubles, with its tree of rays. */
#include "render/per_arithmetic/observe.h"

#include "camera.h"
#include "tree.h"

typedef char observed_matches_tree[(int)OBSERVED_REFRACTED == (int)BRANCH_REFRACTED &&
                                           (int)OBSERVED_NOTHING == (int)END_NOTHING &&
                                           (int)OBSERVED_BUDGET == (int)END_BUDGET &&
                                           (int)OBSERVED_DEPTH == (int)END_DEPTH &&
                                           (int)OBSERVED_ALL_CHANNELS == (int)CHANNEL_ALL
                                       ? 1
                                       : -1];

static void weights(const struct energies *from, double to[3]) {
    to[0] = ENERGY_VALUE(from->red);
    to[1] = ENERGY_VALUE(from->green);
    to[2] = ENERGY_VALUE(from->blue);
}

static void levels(const struct colours *from, double to[3]) {
    to[0] = COLOUR_VALUE(from->red);
    to[1] = COLOUR_VALUE(from->green);
    to[2] = COLOUR_VALUE(from->blue);
}

static void see_node(void *context, uint32_t number, const struct branch *branch,
                     const struct hit *hit, const struct colours *local) {
    const struct pixel_observer *observer = context;
    struct observed_node node;
    node.number = number;
    node.parent = branch->parent;
    node.kind = (enum observed_kind)branch->kind;
    node.channel = branch->channel;
    node.events = branch->events;
    node.before = hit->before;
    node.after = hit->after;
    node.primitive = hit->primitive;
    node.face = hit->face;
    node.surface = hit->surface;
    node.leaving = hit->leaving;
    node.distance = LENGTH_VALUE(hit->t);
    node.where[0] = LENGTH_VALUE(hit->where.x);
    node.where[1] = LENGTH_VALUE(hit->where.y);
    node.where[2] = LENGTH_VALUE(hit->where.z);
    node.normal[0] = UNIT_VALUE(hit->normal.x);
    node.normal[1] = UNIT_VALUE(hit->normal.y);
    node.normal[2] = UNIT_VALUE(hit->normal.z);
    weights(&branch->weight, node.weight);
    levels(local, node.local);
    observer->node(observer->context, &node);
}

static void see_end(void *context, uint32_t parent, enum branch_kind kind, uint8_t channel,
                    struct energies weight, enum branch_end why) {
    const struct pixel_observer *observer = context;
    struct observed_end end;
    end.parent = parent;
    end.kind = (enum observed_kind)kind;
    end.channel = channel;
    weights(&weight, end.weight);
    end.why = (enum observed_why)why;
    observer->end(observer->context, &end);
}

void observe_pixel(const struct scene *scene, uint16_t x, uint16_t y, double intensity[3],
                   struct render_counts *counts, const struct pixel_observer *observer) {
    const struct pixel_observer nobody = {0, 0, 0};
    struct pixel_observer copy = observer ? *observer : nobody;
    const struct tree_observer relay = {&copy, see_node, see_end};
    const struct ray ray = camera_ray(scene, x, y);
    struct colours colour = tree_colour(scene, &ray, counts, observer ? &relay : 0);
    levels(&colour, intensity);
}
