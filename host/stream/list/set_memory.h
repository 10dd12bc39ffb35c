/* SPDX-License-Identifier: MIT */
/* The sets of primitives that a stream's rays have come to be inside of, each by a number. What is
 * known of a set is found once. */
#ifndef SUPERFRAME_SET_MEMORY_H
#define SUPERFRAME_SET_MEMORY_H

#include "stream/lanes.h"

/* A band whose rays come to be inside of more different sets is left to the image's row(). */
enum { SETS_MOST = 16384, SET_SLOTS = 4 * SETS_MOST };

/* Set 0 is empty. */
enum { SET_EMPTY = 0 };

/* Not found out yet, of a numbered set. */
#define SET_UNKNOWN UINT32_C(0xFFFFFFFF)

struct numbered_set {
    struct primitive_set set;
    uint32_t hash;
    uint32_t object;  /* that fills the place */
    uint32_t among;   /* the number of the set that a search for shadows begins with */
    uint32_t shadows; /* 1: something there keeps light off, of a set of a search for shadows */
};

struct set_memory {
    const struct scene *scene; /* of which the sets are */
    uint32_t count;
    bool is_full;              /* a set has found no room */
    uint32_t slots[SET_SLOTS]; /* by hash, the next free one on a clash: number + 1, 0: free */
    struct numbered_set sets[SETS_MOST];
};

/* Tells whether surfaces have room in a ray's path. */
bool set_memory_fits(const struct scene *scene);

/* Prepares for a band of a scene. Sets that are known from the bands before stay, if most of the
 * room is still free. */
void set_memory_begin(struct set_memory *memory, const struct scene *scene);

static inline bool set_memory_is_full(const struct set_memory *memory) {
    return memory->is_full;
}

uint32_t set_of_eye(struct set_memory *memory, const struct scene *scene);

/* Returns a set by its number. */
static inline const struct primitive_set *set_numbered(const struct set_memory *memory,
                                                       uint32_t number) {
    return &memory->sets[number].set;
}

/* Returns the number of the set behind a crossing: that of SET_EMPTY where there is no room. */
uint32_t set_behind(struct set_memory *memory, uint32_t number, const crossed_set *toggled);

/* Leaves of sets the primitives that a search for shadows keeps account of. */
void sets_for_shadows(struct set_memory *memory, const struct scene *scene,
                      const uint32_t inside[LANES], uint32_t among[LANES]);

/* A path has 24 bits for a surface. */
enum { PATH_SURFACE_NONE = 0xFFFFFF };

/* Returns surface and events of a ray's path in one word. The set that the ray is inside of says
 * its object. */
static inline uint32_t path_of(uint32_t surface, uint32_t object, uint32_t events) {
    (void)object;
    return (surface & PATH_SURFACE_NONE) | events << 24;
}

static inline uint32_t path_surface(uint32_t path) {
    uint32_t surface = path & PATH_SURFACE_NONE;
    return surface == PATH_SURFACE_NONE ? SURFACE_NONE : surface;
}

static inline uint32_t path_events(uint32_t path) {
    return path >> 24;
}

/* Returns the bin of the queue where a ray waits: rays outside of everything have one of their
 * own. */
static inline uint32_t path_bin(uint32_t path, uint32_t inside, uint32_t bins) {
    (void)path;
    return inside == SET_EMPTY ? 0 : 1 + inside % (bins - 1);
}

#endif
