/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: primitives, and postfix programs as CSG. */
#include <string.h>

#include "compiler/tree.h"
#include "export/pov_internal.h"

/* How far a bounding box stands off its object, in scaled units, so that rounding can't cut the
 * object. */
#define BOUND_MARGIN 0x1p-6

/* An object, and how its operations are to be written. */
struct pov_tree {
    const struct compiled_scene *scene;
    bool transparent;
    struct csg_tree csg;
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
    for (uint32_t i = 0; i < polyhedron->count; i++) {
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

/* Writes the matrix from a frame's coordinates to the world's:
 * point = origin + sum of local_i axis_i. */
static void write_frame(FILE *out, const struct compiled_scene *scene, uint32_t frame,
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

/* Writes the planes that cut a quadric as a solid of their own. POV-Ray 3.7 works out bounds for a
 * quadric from planes beside it, and errs with hyperboloids. */
static void write_cuts(FILE *out, const struct compiled_scene *scene,
                       const struct compiled_quadric *quadric, uint32_t frame, int level) {
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

/* Writes a primitive without the closing brace, so that an object of one primitive can go on with
 * its material. */
static void write_primitive(FILE *out, const struct compiled_scene *scene, uint32_t index,
                            int level) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    const struct compiled_ball *ball;
    switch (primitive->kind) {
    case PRIMITIVE_BALL:
        ball = &scene->balls[primitive->index];
        (void)fputs("sphere { ", out);
        export_pov_vector(out, ball->centre[0], ball->centre[1], ball->centre[2]);
        (void)fprintf(out, ", %.17g", ball->radius);
        break;
    case PRIMITIVE_POLYHEDRON:
        write_polyhedron(out, scene, &scene->polyhedra[primitive->index], level);
        break;
    case PRIMITIVE_QUADRIC:
        write_quadric(out, scene, primitive, level);
        break;
    case PRIMITIVE_BOX:
        write_box(out, &scene->boxes[primitive->index]);
        break;
    }
    if (primitive->kind == PRIMITIVE_BOX && primitive->frame != COMPILED_FRAME_WORLD) {
        write_frame(out, scene, primitive->frame, scene->frames[primitive->frame].origin, level);
    }
    (void)fputc(' ', out);
}

/* Names an operation. A transparent object needs a merge, which has no inner faces. Nobody sees the
 * inner faces of an opaque object, and a union, which does not look for them, is faster. */
static const char *operation_name(const struct pov_tree *tree, uint32_t code) {
    if (code == COMPILED_UNION) {
        return tree->transparent ? "merge" : "union";
    }
    return code == COMPILED_INTERSECTION ? "intersection" : "difference";
}

static void write_node(FILE *out, const struct pov_tree *tree, uint32_t index, int level);

static void write_operand(FILE *out, const struct pov_tree *tree, uint32_t index, int level) {
    indent(out, level);
    write_node(out, tree, index, level);
    (void)fputs("}\n", out);
}

/* Writes the operands of a chain (a op b) op c in order. In POV-Ray such a chain is one
 * operation. */
static void write_operands(FILE *out, const struct pov_tree *tree, uint32_t index, int level) {
    const struct csg_node *node = &tree->csg.nodes[index];
    if (tree->csg.nodes[node->left].code == node->code) {
        write_operands(out, tree, node->left, level);
    } else {
        write_operand(out, tree, node->left, level);
    }
    write_operand(out, tree, node->right, level);
}

/* Writes a node and, by recursion, all below it. A file's solids nest at most SCENE_NESTING_MOST
 * levels deep. */
static void write_node(FILE *out, const struct pov_tree *tree, uint32_t index, int level) {
    uint32_t code = tree->csg.nodes[index].code;
    if (csg_is_leaf(&tree->csg, index)) {
        write_primitive(out, tree->scene, code, level);
        return;
    }
    (void)fprintf(out, "%s {\n", operation_name(tree, code));
    write_operands(out, tree, index, level + 1);
    indent(out, level);
}

/* Writes the bounds of an object: POV-Ray finds none of quadrics and slanted planes by itself. A
 * box or a ball needs none. */
static void write_bounds(FILE *out, const struct compiled_scene *scene,
                         const struct compiled_object *object) {
    uint32_t first = scene->programs[object->program];
    bool is_simple = object->length == 1 && (scene->primitives[first].kind == PRIMITIVE_BOX ||
                                             scene->primitives[first].kind == PRIMITIVE_BALL);
    const struct bounds *bounds = &object->bounds;
    if (is_simple || !bounds_are_finite(bounds)) {
        return;
    }
    (void)fputs("    bounded_by { box { ", out);
    export_pov_vector(out, bounds->low[0] - BOUND_MARGIN, bounds->low[1] - BOUND_MARGIN,
                      bounds->low[2] - BOUND_MARGIN);
    (void)fputs(", ", out);
    export_pov_vector(out, bounds->high[0] + BOUND_MARGIN, bounds->high[1] + BOUND_MARGIN,
                      bounds->high[2] + BOUND_MARGIN);
    (void)fputs(" } }\n", out);
}

static void write_object(FILE *out, const struct pov_tree *tree,
                         const struct compiled_object *object, const char *modifiers) {
    write_node(out, tree, tree->csg.root, 0);
    (void)fprintf(out, "\n%s", modifiers);
    write_bounds(out, tree->scene, object);
    (void)fputs("}\n\n", out);
}

/* Writes the opaque twin of a transparent object that casts a shadow. POV-Ray lets light through
 * what is transparent; shadow rays alone can meet the twin. */
static void write_shadow(FILE *out, const struct pov_tree *tree,
                         const struct compiled_object *object) {
    (void)fputs("// its shadow\n", out);
    write_object(out, tree, object,
                 "    texture { pigment { rgb 0 } }\n    no_image\n    no_reflection\n");
}

bool export_pov_objects(FILE *out, const struct scene_description *description,
                        const struct compiled_scene *scene) {
    char name[POV_NAME_SIZE], modifiers[POV_NAME_SIZE + 80];
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        const struct compiled_material *material = &scene->materials[object->material];
        struct pov_tree tree;
        memset(&tree, 0, sizeof tree);
        tree.scene = scene;
        tree.transparent = material->transparent;
        if (!csg_read(scene, object, &tree.csg)) {
            return false;
        }
        export_pov_material_name(description, scene, object->material, name);
        (void)snprintf(modifiers, sizeof modifiers, "    material { %s }\n%s%s", name,
                       material->transparent ? "    no_shadow\n" : "",
                       material->absorbs ? "    hollow\n" : "");
        export_pov_comment(out, scene->object_names[i]);
        write_object(out, &tree, object, modifiers);
        if (material->transparent && material->casts_shadow) {
            write_shadow(out, &tree, object);
        }
        csg_free(&tree.csg);
    }
    return true;
}
