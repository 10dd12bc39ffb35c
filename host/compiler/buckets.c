/* SPDX-License-Identifier: MIT */
/* Entries of tables, found by a hash of what they are. */
#include "compiler/buckets.h"

#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/tables.h"
#include "splitmix64.h"

uint64_t bucket_key(uint64_t key, uint64_t part) {
    uint64_t state = key ^ part;
    return splitmix64(&state);
}

uint64_t bucket_key_of(uint64_t key, double number) {
    const double plain = number + 0.0; /* -0 becomes 0 */
    uint64_t bits;
    memcpy(&bits, &plain, sizeof bits);
    return bucket_key(key, bits);
}

static uint32_t *head_of(const struct buckets *buckets, uint32_t room, uint64_t key) {
    return &buckets->heads[key & (room - 1)];
}

/* Returns how many slots there is room for: at least one, and a power of two. */
static uint32_t room_of(uint32_t count) {
    uint32_t room = 1;
    while (room < count) {
        room *= 2;
    }
    return room;
}

/* Makes twice as many heads and hangs all slots on them; false if memory is out. */
static bool hang_anew(struct buckets *buckets, uint32_t room) {
    uint32_t *heads = malloc(room * sizeof *heads);
    if (heads == NULL) {
        return false;
    }
    memset(heads, 0xFF, room * sizeof *heads);
    free(buckets->heads);
    buckets->heads = heads;
    for (uint32_t i = 0; i < buckets->count; i++) {
        uint32_t *head = head_of(buckets, room, buckets->slots[i].key);
        buckets->slots[i].next = *head;
        *head = i;
    }
    return true;
}

bool buckets_add(struct buckets *buckets, uint64_t key, uint32_t entry) {
    if (!GROW(buckets->slots, buckets->count)) {
        return false;
    }
    const uint32_t room = room_of(buckets->count + 1);
    if ((buckets->count & (buckets->count - 1)) == 0 && !hang_anew(buckets, room)) {
        return false;
    }
    uint32_t *head = head_of(buckets, room, key);
    buckets->slots[buckets->count] = (struct bucket_slot){key, entry, *head};
    *head = buckets->count++;
    return true;
}

/* Returns the first slot from that one on, by the links, that has a key. */
static uint32_t find_from(const struct buckets *buckets, uint32_t slot, uint64_t key) {
    while (slot != COMPILED_NONE && buckets->slots[slot].key != key) {
        slot = buckets->slots[slot].next;
    }
    return slot;
}

uint32_t buckets_first(const struct buckets *buckets, uint64_t key) {
    return buckets->count == 0
               ? COMPILED_NONE
               : find_from(buckets, *head_of(buckets, room_of(buckets->count), key), key);
}

uint32_t buckets_next(const struct buckets *buckets, uint32_t slot) {
    return find_from(buckets, buckets->slots[slot].next, buckets->slots[slot].key);
}

void buckets_clear(struct buckets *buckets) {
    free(buckets->slots);
    free(buckets->heads);
    memset(buckets, 0, sizeof *buckets);
}
