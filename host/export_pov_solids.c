/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: primitives, and postfix programs as CSG. */
#include <math.h>
#include <string.h>

#include "export_pov_internal.h"

/* How far an object's bounding box stands off it, in scaled units: rounding can't cut it. */
#define BOUND_MARGIN 0x1p-6

/* A node of an object's tree: a primitive, or an operation on two nodes before it. */
struct pov_node {
    uint8_t code;
    uint8_t left, right; /* of an operation */
};

/* An object's tree; the root is the last node. */
struct pov_tree {
    const struct compiled_scene *scene;
    bool transparent;
    struct pov_node nodes[256];
};

static void indent(FILE *out, int levels) {
    (void)fprintf(out, "%*s", 4 * levels, "");
}

static void write_box(FILE *out, const struct compiled_box *box) {
    (void)fputs("box { ", out);
    export_pov_vector(out, box->minimum[0], box->minimum[1], box->minimum[2]);
    (void)fputs(", ", out);
    export_pov_vector(out, box->maximum[0], box->maximum[1], box->maximum[2]);
}

static void write_polyhedron(FILE *out, const struct compiled_scene *scene,
                             const struct compiled_polyhedron *polyhedron, int level) {
    (void)fputs("intersection {\n", out);
    for (int i = 0; i < polyhedron->count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        indent(out, level + 1);
        (void)fputs("plane { ", out);
        export_pov_vector(out, plane->normal[0], plane->normal[1], plane->normal[2]);
        (void)fprintf(out, ", %.17g }\n", plane->offset);
    }
    indent(out, level);
}

static void write_curve(FILE *out, const struct compiled_quadric *quadric) {
    (void)fputs("quadric { ", out);
    export_pov_vector(out, quadric->square[0], quadric->square[1], quadric->square[2]);
    (void)fputs(", <0, 0, 0>, ", out);
    export_pov_vector(out, 0, 0, 2 * quadric->linear);
    (void)fprintf(out, ", %.17g", quadric->constant);
}

/* From a frame's coordinates to the world's: point = origin + sum of local_i axis_i. */
static void write_frame(FILE *out, const struct compiled_scene *scene, uint8_t frame,
                        const double origin[3], int level) {
    (void)fputc('\n', out);
    indent(out, level + 1);
    (void)fputs("matrix <", out);
    for (int i = 0; i < 3; i++) {
        const double *axis = compiled_axis(scene, frame, i);
        (void)fprintf(out, "%.17g, %.17g, %.17g, ", axis[0], axis[1], axis[2]);
    }
    (void)fprintf(out, "%.17g, %.17g, %.17g>", origin[0], origin[1], origin[2]);
}

/* The planes that cut a quadric, as a solid of their own: POV-Ray 3.7 works out bounds for a
 * quadric from planes beside it, and errs with hyperboloids. */
static void write_cuts(FILE *out, const struct compiled_scene *scene,
                       const struct compiled_quadric *quadric, uint8_t frame, int level) {
    const struct compiled_box *box = &scene->boxes[quadric->box];
    indent(out, level);
    (void)fputs("intersection {\n", out);
    for (int i = 0; i < 6; i++) {
        const double *axis = compiled_axis(scene, frame, i % 3);
        double sign = i < 3 ? -1 : 1;
        if ((quadric->cuts >> i % 3 & 1) != 0) {
            indent(out, level + 1);
            (void)fputs("plane { ", out);
            export_pov_vector(out, sign * axis[0], sign * axis[1], sign * axis[2]);
            (void)fprintf(out, ", %.17g }\n", i < 3 ? -box->minimum[i] : box->maximum[i - 3]);
        }
    }
    indent(out, level);
    (void)fputs("}\n", out);
}

static void write_quadric(FILE *out, const struct compiled_scene *scene,
                          const struct compiled_primitive *primitive, int level) {
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    bool is_cut = quadric->cuts != 0;
    if (is_cut) {
        (void)fputs("intersection {\n", out);
        indent(out, level + 1);
    }
    write_curve(out, quadric);
    write_frame(out, scene, primitive->frame, quadric->centre, is_cut ? level + 1 : level);
    if (is_cut) {
        (void)fputs(" }\n", out);
        write_cuts(out, scene, quadric, primitive->frame, level + 1);
        indent(out, level);
    }
}

/* Without the closing brace, so that an object of one primitive can go on with its material. */
static void write_primitive(FILE *out, const struct compiled_scene *scene, uint8_t index,
                            int level) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    const struct compiled_ball *ball;
    switch (primitive->kind) {
    case KIND_BALL:
        ball = &scene->balls[primitive->index];
        (void)fputs("sphere { ", out);
        export_pov_vector(out, ball->centre[0], ball->centre[1], ball->centre[2]);
        (void)fprintf(out, ", %.17g", ball->radius);
        break;
    case KIND_POLYHEDRON:
        write_polyhedron(out, scene, &scene->polyhedra[primitive->index], level);
        break;
    case KIND_QUADRIC:
        write_quadric(out, scene, primitive, level);
        break;
    default:
        write_box(out, &scene->boxes[primitive->index]);
        break;
    }
    if (primitive->kind == KIND_BOX && primitive->frame != WORLD_FRAME) {
        write_frame(out, scene, primitive->frame, scene->frames[primitive->frame].origin, level);
    }
    (void)fputc(' ', out);
}

/* A merge has no inner faces, which of an opaque object nobody sees and which a union is faster
 * without looking for. */
static const char *operation_name(const struct pov_tree *tree, uint8_t code) {
    if (code == CODE_UNION) {
        return tree->transparent ? "merge" : "union";
    }
    return code == CODE_INTERSECTION ? "intersection" : "difference";
}

static void write_node(FILE *out, const struct pov_tree *tree, uint8_t index, int level);

/* The operands of a chain (a op b) op c, which is one operation of POV-Ray's, in order. */
static void write_operands(FILE *out, const struct pov_tree *tree, uint8_t index, int level) {
    uint8_t chain[256] = {0};
    int count = 0;
    uint8_t code = tree->nodes[index].code;
    while (tree->nodes[index].code == code) {
        chain[count++] = tree->nodes[index].right;
        index = tree->nodes[index].left;
    }
    chain[count++] = index;
    while (count > 0) {
        indent(out, level);
        write_node(out, tree, chain[--count], level);
        (void)fputs("}\n", out);
    }
}

/* As deep as solids may be nested: 32 levels. */
static void write_node(FILE *out, const struct pov_tree *tree, uint8_t index, int level) {
    const struct pov_node *node = &tree->nodes[index];
    if (node->code < CODE_UNION) {
        write_primitive(out, tree->scene, node->code, level);
        return;
    }
    (void)fprintf(out, "%s {\n", operation_name(tree, node->code));
    write_operands(out, tree, index, level + 1);
    indent(out, level);
}

/* The tree of a postfix program; returns its root. */
static uint8_t read_program(struct pov_tree *tree, const struct compiled_object *object) {
    uint8_t stack[256] = {0};
    int depth = 0;
    for (uint8_t i = 0; i < object->length; i++) {
        struct pov_node *node = &tree->nodes[i];
        node->code = tree->scene->programs[object->program + i];
        node->left = node->right = 0;
        if (node->code >= CODE_UNION) {
            node->right = stack[--depth];
            node->left = stack[--depth];
        }
        stack[depth++] = i;
    }
    return (uint8_t)(object->length - 1);
}

static bool is_bounded(const struct compiled_object *object) {
    for (int i = 0; i < 3; i++) {
        if (!isfinite(object->low[i]) || !isfinite(object->high[i])) {
            return false;
        }
    }
    return true;
}

/* POV-Ray finds no bounds of quadrics and slanted planes by itself. A box or a ball needs none. */
static void write_bounds(FILE *out, const struct compiled_scene *scene,
                         const struct compiled_object *object) {
    uint8_t first = scene->programs[object->program];
    bool is_simple = object->length == 1 && (scene->primitives[first].kind == KIND_BOX ||
                                             scene->primitives[first].kind == KIND_BALL);
    if (is_simple || !is_bounded(object)) {
        return;
    }
    (void)fputs("    bounded_by { box { ", out);
    export_pov_vector(out, object->low[0] - BOUND_MARGIN, object->low[1] - BOUND_MARGIN,
                      object->low[2] - BOUND_MARGIN);
    (void)fputs(", ", out);
    export_pov_vector(out, object->high[0] + BOUND_MARGIN, object->high[1] + BOUND_MARGIN,
                      object->high[2] + BOUND_MARGIN);
    (void)fputs(" } }\n", out);
}

static void write_object(FILE *out, const struct pov_tree *tree, uint8_t root,
                         const struct compiled_object *object, const char *modifiers) {
    write_node(out, tree, root, 0);
    (void)fprintf(out, "\n%s", modifiers);
    write_bounds(out, tree->scene, object);
    (void)fputs("}\n\n", out);
}

/* POV-Ray lets light through what is transparent. What casts a shadow none the less has an opaque
 * twin that shadow rays alone can meet. */
static void write_shadow(FILE *out, const struct pov_tree *tree, uint8_t root,
                         const struct compiled_object *object) {
    (void)fputs("// its shadow\n", out);
    write_object(out, tree, root, object,
                 "    texture { pigment { rgb 0 } }\n    no_image\n    no_reflection\n");
}

void export_pov_objects(FILE *out, const struct scene_description *description,
                        const struct compiled_scene *scene) {
    char name[POV_NAME_SIZE], modifiers[POV_NAME_SIZE + 80];
    for (uint8_t i = 1; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        const struct compiled_material *material = &scene->materials[object->material];
        struct pov_tree tree;
        memset(&tree, 0, sizeof tree);
        tree.scene = scene;
        tree.transparent = material->transparent;
        uint8_t root = read_program(&tree, object);
        export_pov_material_name(description, object->material, name);
        (void)snprintf(modifiers, sizeof modifiers, "    material { %s }\n%s%s", name,
                       material->transparent ? "    no_shadow\n" : "",
                       material->absorbs ? "    hollow\n" : "");
        export_pov_comment(out, scene->object_names[i]);
        write_object(out, &tree, root, object, modifiers);
        if (material->transparent && material->casts_shadow) {
            write_shadow(out, &tree, root, object);
        }
    }
}
