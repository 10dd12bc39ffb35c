/* SPDX-License-Identifier: MIT */
/* Entries of tables, found by a hash of what they are. */
#ifndef SUPERFRAME_BUCKETS_H
#define SUPERFRAME_BUCKETS_H

#include <stdbool.h>
#include <stdint.h>

/* All zero: nothing is in it. */
struct buckets {
    struct bucket_slot *slots; /* grows as base/grow.h says */
    uint32_t *heads; /* slots by the low bits of keys; as many as there is room for slots */
    uint32_t count;
};

/* An entry under a key. Different things may have one key: who looks compares them. */
struct bucket_slot {
    uint64_t key;
    uint32_t entry;
    uint32_t next; /* slot with the same head, or COMPILED_NONE */
};

/* Returns the key of what has that key and one more part. */
uint64_t bucket_key(uint64_t key, uint64_t part);

/* Does so for a number that is not NaN; 0 and -0 are the same. */
uint64_t bucket_key_of(uint64_t key, double number);

/* Puts an entry under a key; false if memory is out. */
bool buckets_add(struct buckets *buckets, uint64_t key, uint32_t entry);

/* Returns a slot with an entry that has the key, and the next one; COMPILED_NONE where there is no
 * more. They come in no order. */
uint32_t buckets_first(const struct buckets *buckets, uint64_t key);
uint32_t buckets_next(const struct buckets *buckets, uint32_t slot);

/* Frees all memory and leaves nothing in it. */
void buckets_clear(struct buckets *buckets);

#endif
