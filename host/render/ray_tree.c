/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel: collected through the observer, printed indented or as a graph. */
#include "render/ray_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"

/* Makes room for one more entry; false where there is none to be had. */
static bool make_room(void **entries, size_t *room, size_t count, size_t size) {
    if (count < *room) {
        return true;
    }
    size_t more = *room ? 2 * *room : 64;
    void *larger = more <= 4 * (size_t)RAY_TREE_NODES_MOST ? realloc(*entries, more * size) : NULL;
    if (!larger) {
        return false;
    }
    *entries = larger;
    *room = more;
    return true;
}

static void collect_node(void *context, const struct observed_node *node) {
    struct ray_tree *tree = context;
    void *nodes = tree->nodes;
    if (node->number == 1) {
        tree->node_count = tree->end_count = 0; /* the pixel begins, or begins again */
    }
    if (tree->out_of_memory ||
        !make_room(&nodes, &tree->node_room, tree->node_count, sizeof *node)) {
        tree->out_of_memory = true;
        return;
    }
    tree->nodes = nodes;
    tree->nodes[tree->node_count++] = *node;
}

static void collect_end(void *context, const struct observed_end *end) {
    struct ray_tree *tree = context;
    void *ends = tree->ends;
    if (tree->out_of_memory || !make_room(&ends, &tree->end_room, tree->end_count, sizeof *end)) {
        tree->out_of_memory = true;
        return;
    }
    tree->ends = ends;
    tree->ends[tree->end_count++] = *end;
}

bool ray_tree_grow(struct ray_tree *tree, const struct arithmetic *arithmetic,
                   const struct scene *scene, uint16_t x, uint16_t y) {
    memset(tree, 0, sizeof *tree);
    const struct pixel_observer observer = {tree, collect_node, collect_end};
    arithmetic->pixel(scene, x, y, tree->intensity, &tree->counts, &observer);
    return !tree->out_of_memory;
}

void ray_tree_free(struct ray_tree *tree) {
    free(tree->nodes);
    free(tree->ends);
    memset(tree, 0, sizeof *tree);
}

/* Names a branch by the paper's letters: S for what the mirror direction brings, T for what comes
 * through. */
static const char *kind_text(enum observed_kind kind, uint8_t channel) {
    static const char *const refracted[] = {"T red", "T green", "T blue", "T"};
    static const char *const reflected[] = {"S red", "S green", "S blue", "S"};
    return kind == OBSERVED_EYE         ? "eye"
           : kind == OBSERVED_REFLECTED ? reflected[channel]
                                        : refracted[channel];
}

static const char *why_text(enum observed_why why) {
    static const char *const texts[] = {"leaves the scene", "at the depth level",
                                        "below the threshold", "has no weight",
                                        "at the end of the budget of rays"};
    return texts[why];
}

static double largest(const double weight[3]) {
    return fmax(weight[0], fmax(weight[1], weight[2]));
}

static const char *object_text(const struct compiled_scene *compiled, uint32_t object) {
    const char *name = compiled->object_names[object];
    return name[0] ? name : "object";
}

static void indent(FILE *out, unsigned depth) {
    fprintf(out, "%*s", (int)(2 * depth), "");
}

/* Returns rho or tau: the weight of a branch as a share of the weight of the node where it
 * began. */
static double coefficient(const struct ray_tree *tree, uint32_t parent, const double weight[3]) {
    double whole = parent > 0 ? largest(tree->nodes[parent - 1].weight) : 1;
    return whole > 0 ? largest(weight) / whole : 0;
}

static void print_node(FILE *out, const struct ray_tree *tree, const struct observed_node *node,
                       const struct compiled_scene *compiled) {
    indent(out, node->events);
    fprintf(out, "%s %u: %s -> %s, surface %u, distance %.6g, own (%.3f, %.3f, %.3f)",
            kind_text(node->kind, node->channel), (unsigned)node->number,
            object_text(compiled, node->before), object_text(compiled, node->after), node->surface,
            ldexp(node->distance, -compiled->exponent), node->local[0], node->local[1],
            node->local[2]);
    if (node->kind != OBSERVED_EYE) {
        fprintf(out, ", %s %.6f", node->kind == OBSERVED_REFLECTED ? "rho" : "tau",
                coefficient(tree, node->parent, node->weight));
    }
    fprintf(out, ", weight %.6f\n", largest(node->weight));
}

static void print_end(FILE *out, const struct ray_tree *tree, const struct observed_end *end,
                      unsigned depth) {
    indent(out, depth);
    fprintf(out, "%s: %s, weight %.6f\n", kind_text(end->kind, end->channel), why_text(end->why),
            largest(end->weight));
    (void)tree;
}

/* The children of each node as linked lists, in the order in which the children were reached.
 * first_child[i] is of node i, next_sibling[j] of node j. */
struct links {
    uint32_t *first_child, *next_sibling; /* by number; 0: none */
    uint32_t *first_end;                  /* index + 1 into ends, by number */
    uint32_t *next_end;                   /* by index + 1 */
};

static bool make_links(const struct ray_tree *tree, struct links *links) {
    size_t nodes = tree->node_count + 1, ends = tree->end_count + 1;
    links->first_child = calloc(nodes, sizeof *links->first_child);
    links->next_sibling = calloc(nodes, sizeof *links->next_sibling);
    links->first_end = calloc(nodes, sizeof *links->first_end);
    links->next_end = calloc(ends, sizeof *links->next_end);
    if (!links->first_child || !links->next_sibling || !links->first_end || !links->next_end) {
        return false;
    }
    for (size_t i = tree->node_count; i > 0; i--) {
        const struct observed_node *node = &tree->nodes[i - 1];
        links->next_sibling[i] = links->first_child[node->parent];
        links->first_child[node->parent] = (uint32_t)i;
    }
    for (size_t i = tree->end_count; i > 0; i--) {
        const struct observed_end *end = &tree->ends[i - 1];
        links->next_end[i] = links->first_end[end->parent];
        links->first_end[end->parent] = (uint32_t)i;
    }
    return true;
}

static void free_links(struct links *links) {
    free(links->first_child);
    free(links->next_sibling);
    free(links->first_end);
    free(links->next_end);
}

static void print_ends(FILE *out, const struct ray_tree *tree, const struct links *links,
                       uint32_t number, unsigned depth) {
    for (uint32_t i = links->first_end[number]; i != 0; i = links->next_end[i]) {
        print_end(out, tree, &tree->ends[i - 1], depth);
    }
}

/* Prints depth first, without recursion. Next comes a node's first child, else its next sibling,
 * else that of the nearest ancestor that has one. */
int ray_tree_print(FILE *out, const struct ray_tree *tree, const struct compiled_scene *compiled) {
    struct links links;
    bool good = make_links(tree, &links);
    uint32_t at = good ? links.first_child[0] : 0;
    if (good) {
        print_ends(out, tree, &links, 0, 0);
    }
    while (at != 0) {
        const struct observed_node *node = &tree->nodes[at - 1];
        print_node(out, tree, node, compiled);
        print_ends(out, tree, &links, at, node->events + 1u);
        uint32_t next = links.first_child[at];
        while (next == 0 && at != 0) {
            next = links.next_sibling[at];
            at = tree->nodes[at - 1].parent;
        }
        at = next;
    }
    fprintf(out, "intensity (%.4f, %.4f, %.4f) of %u nodes\n", tree->intensity[0],
            tree->intensity[1], tree->intensity[2], (unsigned)tree->node_count);
    free_links(&links);
    return good && !ferror(out) ? 0 : -1;
}

/* Prints a text for Graphviz's quotes, in which a quote and a backslash need a backslash before
 * them. */
static void print_quotable(FILE *out, const char *text) {
    for (; *text != '\0'; text++) {
        fprintf(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    }
}

static void print_dot_node(FILE *out, const struct ray_tree *tree, const struct observed_node *node,
                           const struct compiled_scene *compiled) {
    unsigned number = node->number;
    fprintf(out, "    %u [label=\"%u\", tooltip=\"", number, number);
    print_quotable(out, object_text(compiled, node->before));
    fprintf(out, " -> ");
    print_quotable(out, object_text(compiled, node->after));
    fprintf(out, "\"];\n    %u -> %u [label=\"%s %.4f\"];\n", number, (unsigned)node->parent,
            kind_text(node->kind, node->channel), coefficient(tree, node->parent, node->weight));
}

int ray_tree_print_dot(FILE *out, const struct ray_tree *tree,
                       const struct compiled_scene *compiled) {
    fprintf(out, "digraph rays {\n    node [shape=circle];\n    0 [shape=plaintext, "
                 "label=\"I\"];\n");
    for (size_t i = 0; i < tree->node_count; i++) {
        print_dot_node(out, tree, &tree->nodes[i], compiled);
    }
    for (size_t i = 0; i < tree->end_count; i++) {
        const struct observed_end *end = &tree->ends[i];
        fprintf(out, "    e%zu [shape=plaintext, label=\"%s\"];\n", i, why_text(end->why));
        fprintf(out, "    e%zu -> %u [style=dotted, label=\"%s %.4f\"];\n", i,
                (unsigned)end->parent, kind_text(end->kind, end->channel),
                coefficient(tree, end->parent, end->weight));
    }
    fprintf(out, "}\n");
    return ferror(out) ? -1 : 0;
}

static void write_three(struct json *json, const char *key, const double three[3]) {
    json_begin_list(json, key);
    for (int i = 0; i < 3; i++) {
        json_real(json, NULL, three[i]);
    }
    json_end_list(json);
}

static void write_node(struct json *json, const struct ray_tree *tree,
                       const struct observed_node *node, const struct compiled_scene *compiled) {
    json_begin_object(json, NULL);
    json_count(json, "number", node->number);
    json_count(json, "parent", node->parent);
    json_text(json, "kind", kind_text(node->kind, node->channel));
    json_text(json, "before", object_text(compiled, node->before));
    json_text(json, "after", object_text(compiled, node->after));
    json_count(json, "events", node->events);
    write_three(json, "weight", node->weight);
    json_real(json, "coefficient", coefficient(tree, node->parent, node->weight));
    json_end_object(json);
}

int ray_tree_print_json(FILE *out, const struct ray_tree *tree,
                        const struct compiled_scene *compiled) {
    struct json json = {.out = out};
    json_begin_object(&json, NULL);
    write_three(&json, "intensity", tree->intensity);
    json_begin_list(&json, "nodes");
    for (size_t i = 0; i < tree->node_count; i++) {
        write_node(&json, tree, &tree->nodes[i], compiled);
    }
    json_end_list(&json);
    json_begin_list(&json, "ends");
    for (size_t i = 0; i < tree->end_count; i++) {
        const struct observed_end *end = &tree->ends[i];
        json_begin_object(&json, NULL);
        json_count(&json, "parent", end->parent);
        json_text(&json, "kind", kind_text(end->kind, end->channel));
        json_text(&json, "why", why_text(end->why));
        write_three(&json, "weight", end->weight);
        json_end_object(&json);
    }
    json_end_list(&json);
    json_end_object(&json);
    return ferror(out) ? -1 : 0;
}
