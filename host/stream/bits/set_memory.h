/* SPDX-License-Identifier: MIT */
/* What a stream knows of sets of primitives that are single words, one bit a primitive. */
#ifndef SUPERFRAME_SET_MEMORY_H
#define SUPERFRAME_SET_MEMORY_H

#include "stream/lanes.h"

/* A scene of more primitives is left to the image's row(). */
enum { STREAM_PRIMITIVES_MOST = 32 };

/* One for each surface that a scene may have; the last one is no surface. */
enum { TOUCHES = 256 };

struct set_memory {
    uint32_t touches[TOUCHES]; /* by surface: the primitives that it bounds */
};

/* Tells whether sets and surfaces of a scene have room here. */
bool set_memory_fits(const struct scene *scene);

/* Prepares for a band of a scene. */
void set_memory_begin(struct set_memory *memory, const struct scene *scene);

/* Returns the primitives that a surface bounds; none for SURFACE_NONE. */
static inline uint32_t touches_of(const struct set_memory *memory, uint32_t surface) {
    return memory->touches[surface % TOUCHES];
}

/* Tells whether a set has found no room: the band is void then. */
static inline bool set_memory_is_full(const struct set_memory *memory) {
    (void)memory;
    return false;
}

static inline uint32_t set_of_eye(struct set_memory *memory, const struct scene *scene) {
    (void)memory;
    return scene->camera.inside.word[0];
}

/* Leaves of sets the primitives that a search for shadows keeps account of. */
static inline void sets_for_shadows(struct set_memory *memory, const struct scene *scene,
                                    const uint32_t inside[restrict LANES],
                                    uint32_t among[restrict LANES]) {
    const uint32_t those = scene->shadow_primitives.word[0];
    (void)memory;
    for (int i = 0; i < LANES; i++) {
        among[i] = inside[i] & those;
    }
}

/* Returns surface, object and events of a ray's path in one word. */
static inline uint32_t path_of(uint32_t surface, uint32_t object, uint32_t events) {
    return surface | object << 16 | events << 24;
}

static inline uint32_t path_surface(uint32_t path) {
    return path & 0xFFFF;
}

/* Returns the bin of the queue where a ray waits: rays in one object meet the same primitives. */
static inline uint32_t path_bin(uint32_t path, uint32_t inside, uint32_t bins) {
    (void)inside;
    return (path >> 16 & 0xFF) % bins;
}

static inline uint32_t path_object(uint32_t path) {
    return path >> 16 & 0xFF;
}

static inline uint32_t path_events(uint32_t path) {
    return path >> 24;
}

#endif
