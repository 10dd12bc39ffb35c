/* SPDX-License-Identifier: MIT */
/* The abstract syntax of a generated scene: building and walking it. */
#include "syntax.h"

#include <string.h>

int syntax_add(struct syntax *syntax, enum syntax_kind kind) {
    if (syntax->solid_count == SYNTAX_SOLIDS_MOST) {
        syntax->is_full = true;
        return SYNTAX_SOLIDS_MOST - 1;
    }
    struct syntax_solid *solid = &syntax->solids[syntax->solid_count];
    memset(solid, 0, sizeof *solid);
    solid->kind = kind;
    solid->material = -1;
    for (int i = 0; i < 3; i++) {
        solid->scale[i] = 1;
    }
    return syntax->solid_count++;
}

void syntax_adopt(struct syntax *syntax, int parent, int child) {
    struct syntax_solid *solid = &syntax->solids[parent];
    if (solid->child_count == SYNTAX_CHILDREN_MOST || parent == child) {
        syntax->is_full = true;
        return;
    }
    solid->children[solid->child_count++] = child;
}

int syntax_combine(struct syntax *syntax, enum syntax_kind kind, int left, int right) {
    int solid = syntax_add(syntax, kind);
    syntax_adopt(syntax, solid, left);
    syntax_adopt(syntax, solid, right);
    return solid;
}

int syntax_copy(struct syntax *syntax, int solid) {
    int copy = syntax_add(syntax, SYNTAX_UNION);
    if (syntax->is_full) {
        return copy;
    }
    syntax->solids[copy] = syntax->solids[solid];
    for (int i = 0; i < syntax->solids[solid].child_count; i++) {
        syntax->solids[copy].children[i] = syntax_copy(syntax, syntax->solids[solid].children[i]);
    }
    return copy;
}

int syntax_push_down(struct syntax *syntax, int solid, enum syntax_kind kind) {
    int below = syntax_add(syntax, kind);
    if (!syntax->is_full) {
        struct syntax_solid blank = syntax->solids[below];
        syntax->solids[below] = syntax->solids[solid];
        syntax->solids[solid] = blank;
    }
    return below;
}

void syntax_plane(struct syntax *syntax, int solid, double x, double y, double z, double offset) {
    struct syntax_solid *polyhedron = &syntax->solids[solid];
    if (polyhedron->plane_count == SYNTAX_PLANES_MOST) {
        syntax->is_full = true;
        return;
    }
    struct syntax_plane plane = {{x, y, z}, offset};
    polyhedron->planes[polyhedron->plane_count++] = plane;
}

void syntax_insert_object(struct syntax *syntax, int at, int material, int solid) {
    if (syntax->object_count == SYNTAX_OBJECTS_MOST) {
        syntax->is_full = true;
        return;
    }
    struct syntax_object *place = &syntax->objects[at];
    memmove(place + 1, place, (size_t)(syntax->object_count - at) * sizeof *place);
    place->material = material;
    place->solid = solid;
    syntax->object_count++;
}

int syntax_add_object(struct syntax *syntax, int material, int solid) {
    syntax_insert_object(syntax, syntax->object_count, material, solid);
    return syntax->object_count - 1;
}

int syntax_add_part(struct syntax *syntax, int solid) {
    if (syntax->part_count == SYNTAX_PARTS_MOST) {
        syntax->is_full = true;
        return 0;
    }
    syntax->parts[syntax->part_count] = solid;
    return syntax->part_count++;
}

struct syntax_light *syntax_add_light(struct syntax *syntax) {
    if (syntax->light_count == SYNTAX_LIGHTS_MOST) {
        syntax->is_full = true;
        return &syntax->lights[0];
    }
    struct syntax_light *light = &syntax->lights[syntax->light_count++];
    memset(light, 0, sizeof *light);
    return light;
}

/* Appends a solid and all below it, each once. */
static int list_below(const struct syntax *syntax, int solid, int *list, int count) {
    for (int i = 0; i < count; i++) {
        if (list[i] == solid) {
            return count;
        }
    }
    const struct syntax_solid *root = &syntax->solids[solid];
    list[count++] = solid;
    if (root->kind == SYNTAX_PART) {
        count = list_below(syntax, syntax->parts[root->part], list, count);
    }
    for (int i = 0; i < root->child_count; i++) {
        count = list_below(syntax, root->children[i], list, count);
    }
    return count;
}

int syntax_list(const struct syntax *syntax, int list[SYNTAX_SOLIDS_MOST]) {
    int count = 0;
    for (int i = 0; i < syntax->object_count; i++) {
        count = list_below(syntax, syntax->objects[i].solid, list, count);
    }
    return count;
}

bool syntax_names_material(const struct syntax *syntax, int solid) {
    int list[SYNTAX_SOLIDS_MOST];
    int count = list_below(syntax, solid, list, 0);
    for (int i = 0; i < count; i++) {
        if (syntax->solids[list[i]].material >= 0) {
            return true;
        }
    }
    return false;
}

bool syntax_uses_material(const struct syntax *syntax, int material) {
    for (int i = 0; i < syntax->object_count; i++) {
        if (syntax->objects[i].material == material) {
            return true;
        }
    }
    for (int i = 0; i < syntax->solid_count; i++) {
        if (syntax->solids[i].material == material) {
            return true;
        }
    }
    return false;
}

bool syntax_has_endless(const struct syntax *syntax) {
    for (int i = 0; i < syntax->object_count; i++) {
        if (syntax->solids[syntax->objects[i].solid].kind == SYNTAX_HALF_SPACE) {
            return true;
        }
    }
    return false;
}
