/* SPDX-License-Identifier: MIT */
/* Finds the objects that a primitive takes part in: its places in their programs, and those of
 * which it is a key. */
#include <math.h>
#include <stdlib.h>

#include "compiler/compiler_internal.h"

/* What a program's code is as a tree; places count from the program's first code. */
struct code {
    uint32_t left, right; /* of an operation */
    double size;          /* how much space its keys take, more or less */
    bool is_key;          /* the place above needs the keys of this one */
};

static bool is_operation(uint32_t code) {
    return code >= COMPILED_UNION;
}

/* Returns the surface of a primitive's bounds within the world. */
static double size_of(const struct compiled_scene *scene, uint32_t primitive) {
    struct bounds bounds = primitive_bounds(scene, primitive);
    double side[3];
    for (int i = 0; i < 3; i++) {
        side[i] = fmin(bounds.high[i], COMPILE_WORLD) - fmax(bounds.low[i], -COMPILE_WORLD);
    }
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
}

/* Reads a program as a tree and notes what takes each code's result. `stack` has room for all
 * codes. */
static void read_program(const struct compiled_scene *scene, const struct compiled_object *object,
                         struct code *codes, uint32_t *stack, uint32_t *parents) {
    uint32_t depth = 0;
    for (uint32_t i = 0; i < object->length; i++) {
        uint32_t code = scene->programs[object->program + i];
        codes[i].is_key = false;
        if (is_operation(code)) {
            uint32_t right = stack[--depth], left = stack[--depth];
            codes[i].left = left;
            codes[i].right = right;
            parents[left] = 2 * i;
            parents[right] = 2 * i + 1;
            codes[i].size = code == COMPILED_UNION ? codes[left].size + codes[right].size
                            : code == COMPILED_INTERSECTION
                                ? fmin(codes[left].size, codes[right].size)
                                : codes[left].size;
        } else {
            codes[i].size = size_of(scene, code);
        }
        stack[depth++] = i;
    }
    parents[object->length - 1] = COMPILED_PLACE_ROOT;
    codes[object->length - 1].is_key = true;
}

/* Marks the places whose primitives are keys. A place in an intersection lies in both sides: the
 * keys of the smaller one do. */
static void mark_keys(const struct compiled_scene *scene, const struct compiled_object *object,
                      struct code *codes) {
    for (uint32_t i = object->length; i-- > 0;) {
        uint32_t code = scene->programs[object->program + i];
        if (!codes[i].is_key || !is_operation(code)) {
            continue;
        }
        bool right_is_smaller = codes[codes[i].right].size < codes[codes[i].left].size;
        bool takes_right =
            code == COMPILED_UNION || (code == COMPILED_INTERSECTION && right_is_smaller);
        bool takes_left = code != COMPILED_INTERSECTION || !right_is_smaller;
        codes[codes[i].left].is_key = takes_left;
        codes[codes[i].right].is_key = takes_right;
    }
}

/* Adds a key to a primitive's run, unless the run ends in it. The first pass counts, the second one
 * writes. */
static void add_key(struct compiled_hierarchy *to, uint32_t *last, uint32_t primitive,
                    uint32_t object, bool writes) {
    struct compiled_lead *lead = &to->leads[primitive];
    if (last[primitive] == object) {
        return;
    }
    last[primitive] = object;
    if (writes) {
        to->keys[lead->key + lead->key_count] = object;
    }
    lead->key_count++;
}

/* What the passes over all programs work in. */
struct work {
    const struct compiled_scene *scene;
    struct compiled_hierarchy *to;
    struct code *codes; /* by code of the programs */
    uint32_t *stack;
    uint32_t *last; /* by primitive: the object that was its last key; 0: none yet */
};

static void read_programs(const struct work *work) {
    for (uint32_t i = 1; i < work->scene->object_count; i++) {
        const struct compiled_object *object = &work->scene->objects[i];
        struct code *codes = &work->codes[object->program];
        read_program(work->scene, object, codes, work->stack, &work->to->parents[object->program]);
        mark_keys(work->scene, object, codes);
    }
}

/* Adds all uses and keys to the runs of their primitives. The first pass counts, the second one
 * writes. */
static void add_uses(const struct work *work, bool writes) {
    const struct compiled_scene *scene = work->scene;
    struct compiled_hierarchy *to = work->to;
    for (uint32_t number = 1; number < scene->object_count; number++) {
        const struct compiled_object *object = &scene->objects[number];
        for (uint32_t i = 0; i < object->length; i++) {
            uint32_t code = scene->programs[object->program + i];
            if (is_operation(code)) {
                continue;
            }
            struct compiled_lead *lead = &to->leads[code];
            if (writes) {
                to->uses[lead->use + lead->use_count] = (struct compiled_use){number, i};
            }
            lead->use_count++;
            if (work->codes[object->program + i].is_key) {
                add_key(to, work->last, code, number, writes);
            }
        }
    }
}

/* Turns counts into the places where runs begin, and forgets the counts. */
static void begin_runs(const struct work *work) {
    struct compiled_hierarchy *to = work->to;
    for (uint32_t i = 0; i < work->scene->primitive_count; i++) {
        struct compiled_lead *lead = &to->leads[i];
        lead->key = to->key_count;
        lead->use = to->use_count;
        to->key_count += lead->key_count;
        to->use_count += lead->use_count;
        lead->key_count = lead->use_count = 0;
        work->last[i] = 0;
    }
}

/* Fills in the keys, uses and parents; false if memory is out. */
static bool make_uses(const struct work *work) {
    struct compiled_hierarchy *to = work->to;
    read_programs(work);
    add_uses(work, false);
    begin_runs(work);
    to->keys = calloc((size_t)to->key_count + 1, sizeof *to->keys);
    to->uses = calloc((size_t)to->use_count + 1, sizeof *to->uses);
    if (to->keys == NULL || to->uses == NULL) {
        return false;
    }
    add_uses(work, true);
    return true;
}

bool compile_uses(struct compiler *compiler) {
    const struct compiled_scene *scene = compiler->scene;
    struct compiled_hierarchy *to = &compiler->scene->hierarchy;
    const size_t codes = (size_t)scene->program_length + 1;
    const struct work work = {scene, to, calloc(codes, sizeof *work.codes),
                              calloc(codes, sizeof *work.stack),
                              calloc((size_t)scene->primitive_count + 1, sizeof *work.last)};
    to->parent_count = scene->program_length;
    to->parents = calloc(codes, sizeof *to->parents);
    const bool is_made = work.codes != NULL && work.stack != NULL && work.last != NULL &&
                         to->parents != NULL && make_uses(&work);
    free(work.codes);
    free(work.stack);
    free(work.last);
    return is_made || compile_fail_memory(compiler);
}
