/* SPDX-License-Identifier: MIT */
/* The object that fills a place, by the primitives that the place is in. */
#ifndef SUPERFRAME_OBJECTS_H
#define SUPERFRAME_OBJECTS_H

#include "program.h"

/* Programs of so few codes are run as they are. */
enum { PROGRAM_SHORT = 16, PLACES_MOST = 2 * SET_MOST };

/* The results of a program's codes that are true, in the order of the codes. */
struct results {
    uint16_t count;
    struct {
        run_first place;
        uint8_t sides; /* bit 0: what stands left of an operation; bit 1: right; 0: a primitive */
    } of[PLACES_MOST];
};

/* Adds a result of one side, or joins it to the other side's. Returns false where there is no
 * room. */
static inline bool add_result(struct results *results, run_first place, uint8_t sides) {
    uint16_t i = results->count;
    while (i > 0 && place < results->of[i - 1].place) {
        i--;
    }
    if (i > 0 && results->of[i - 1].place == place) {
        results->of[i - 1].sides |= sides;
        return true;
    }
    if (results->count == PLACES_MOST) {
        return false;
    }
    for (uint16_t j = results->count++; j > i; j--) {
        results->of[j] = results->of[j - 1];
    }
    results->of[i].place = place;
    results->of[i].sides = sides;
    return true;
}

/* Lists the places in an object's program of the primitives that a place is inside of. Returns
 * false where there is no room. */
static inline bool find_results(const struct scene *scene, entry_number object,
                                const struct primitive_set *inside, struct results *results) {
    results->count = 0;
    for (uint16_t i = 0; i < inside->count; i++) {
        const struct lead *lead = &scene->leads[inside->member[i]];
        run_count low = 0, high = lead->use_count;
        while (low < high) {
            run_count middle = low + (high - low) / 2;
            if (scene->uses[lead->use + middle].object < object) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        for (; low < lead->use_count && scene->uses[lead->use + low].object == object; low++) {
            if (!add_result(results, scene->uses[lead->use + low].place, 0)) {
                return false;
            }
        }
    }
    return true;
}

static inline bool operation_holds(program_code code, uint8_t sides) {
    return code == PROGRAM_UNION          ? sides != 0
           : code == PROGRAM_INTERSECTION ? sides == 3
           : code == PROGRAM_DIFFERENCE   ? sides == 1
                                          : true;
}

/* Tells whether a place is in an object. Every operation makes nothing of nothing. So only those
 * above what holds the place are looked at, and a program's length costs nothing. */
static inline bool object_holds(const struct scene *scene, entry_number number,
                                const struct primitive_set *inside) {
    const struct object *object = &scene->objects[number];
    const program_code *program = &scene->programs[object->program];
    struct results results;
    if (object->length <= PROGRAM_SHORT || !find_results(scene, number, inside, &results)) {
        return program_holds(program, object->length, inside);
    }
    uint16_t done = 0;
    while (done < results.count) {
        run_first place = results.of[done].place;
        uint8_t sides = results.of[done].sides;
        done++;
        if (!operation_holds(program[place], sides)) {
            continue;
        }
        run_first parent = scene->parents[object->program + place];
        if (parent == PLACE_ROOT) {
            return true;
        }
        if (!add_result(&results, parent >> 1, (uint8_t)(1u << (parent & 1)))) {
            return program_holds(program, object->length, inside);
        }
    }
    return false;
}

/* Returns the object that fills a place: the last one that the place is in. With shadow_only, only
 * objects in the shadow test count. */
static inline entry_number object_at(const struct scene *scene, const struct primitive_set *inside,
                                     bool shadow_only) {
    entry_number last = OBJECT_AIR;
    for (uint16_t i = 0; i < inside->count; i++) {
        const struct lead *lead = &scene->leads[inside->member[i]];
        for (run_count j = 0; j < lead->key_count; j++) {
            entry_number number = scene->keys[lead->key + j];
            if (number > last && (!shadow_only || scene->objects[number].in_shadow_test) &&
                object_holds(scene, number, inside)) {
                last = number;
            }
        }
    }
    return last;
}

/* Returns the object that fills a place behind a crossing. */
static inline entry_number object_behind(const struct scene *scene, entry_number before,
                                         const crossed_set *toggled,
                                         const struct primitive_set *inside) {
    (void)before;
    (void)toggled;
    return object_at(scene, inside, false);
}

#endif
