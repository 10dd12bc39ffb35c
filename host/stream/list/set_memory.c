/* SPDX-License-Identifier: MIT */
/* Numbers for sets of primitives, by a table of hashes. */
#include "set_memory.h"

#include <string.h>

#include "sets/list/walk.h"
#include "stream/surfaces.h"

/* Returns a primitive's part of a set's hash. The parts are put together by exclusive or. So what
 * is crossed changes the hash by its own part. */
static uint32_t part_of(entry_number primitive) {
    uint32_t part = (primitive + 1) * UINT32_C(0x9E3779B1);
    part ^= part >> 15;
    part *= UINT32_C(0x85EBCA77);
    return part ^ part >> 13;
}

static bool sets_are_equal(const struct primitive_set *a, const struct primitive_set *b) {
    bool are_equal = a->count == b->count;
    for (uint16_t i = 0; are_equal && i < a->count; i++) {
        are_equal = a->member[i] == b->member[i];
    }
    return are_equal;
}

/* Finds or adds a set. */
static uint32_t number_of(struct set_memory *memory, const struct primitive_set *set,
                          uint32_t hash) {
    uint32_t slot = hash % SET_SLOTS;
    for (; memory->slots[slot] != 0; slot = (slot + 1) % SET_SLOTS) {
        const struct numbered_set *known = &memory->sets[memory->slots[slot] - 1];
        if (known->hash == hash && sets_are_equal(&known->set, set)) {
            return memory->slots[slot] - 1;
        }
    }
    if (memory->count == SETS_MOST) {
        memory->is_full = true;
        return SET_EMPTY;
    }
    struct numbered_set *fresh = &memory->sets[memory->count];
    fresh->set.count = set->count;
    memcpy(fresh->set.member, set->member, set->count * sizeof set->member[0]);
    fresh->hash = hash;
    fresh->object = fresh->among = fresh->shadows = SET_UNKNOWN;
    memory->slots[slot] = ++memory->count;
    return memory->count - 1;
}

static uint32_t hash_of(const entry_number *members, uint16_t count) {
    uint32_t hash = 0;
    for (uint16_t i = 0; i < count; i++) {
        hash ^= part_of(members[i]);
    }
    return hash;
}

bool set_memory_fits(const struct scene *scene) {
    return surface_last(scene) < PATH_SURFACE_NONE;
}

void set_memory_begin(struct set_memory *memory, const struct scene *scene) {
    struct primitive_set empty;
    if (memory->scene == scene && !memory->is_full && memory->count < SETS_MOST / 2) {
        return;
    }
    memset(memory->slots, 0, sizeof memory->slots);
    memory->scene = scene;
    memory->count = 0;
    memory->is_full = false;
    set_clear(&empty);
    (void)number_of(memory, &empty, 0);
}

uint32_t set_of_eye(struct set_memory *memory, const struct scene *scene) {
    const struct primitive_set *inside = &scene->camera.inside;
    return number_of(memory, inside, hash_of(inside->member, inside->count));
}

uint32_t set_behind(struct set_memory *memory, uint32_t number, const crossed_set *toggled) {
    const struct numbered_set *before = &memory->sets[number];
    struct primitive_set set = before->set;
    set_toggle(&set, toggled);
    return number_of(memory, &set, before->hash ^ hash_of(toggled->member, toggled->count));
}

void sets_for_shadows(struct set_memory *memory, const struct scene *scene,
                      const uint32_t inside[restrict LANES], uint32_t among[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        uint32_t number = inside[i];
        if (memory->sets[number].among == SET_UNKNOWN) {
            struct primitive_set set = memory->sets[number].set;
            restrict_to_shadows(scene, &set);
            memory->sets[number].among = number_of(memory, &set, hash_of(set.member, set.count));
        }
        among[i] = memory->sets[number].among;
    }
}
