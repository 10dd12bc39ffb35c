/* SPDX-License-Identifier: MIT */
/* The page tables of a program, which the emulated CPU does not follow. */
#include "boot/paging.h"

enum { ENTRIES = 1024, PAGE_BYTES = 4096, PRESENT = 1, FIRST_MIB = 0x100000 };

/* Returns an entry of a table; 0, which is not present, where no memory is. */
static uint32_t entry_at(const uint8_t *memory, uint32_t memory_bytes, uint32_t table,
                         uint32_t index) {
    uint32_t place = (table & ~(uint32_t)(PAGE_BYTES - 1)) + 4 * index;
    if (place > memory_bytes - 4) {
        return 0;
    }
    const uint8_t *bytes = memory + place;
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

bool paging_is_identity(const uint8_t *memory, uint32_t memory_bytes, uint32_t directory,
                        struct paging_fault *fault) {
    for (uint32_t i = 0; i < ENTRIES; i++) {
        uint32_t table = entry_at(memory, memory_bytes, directory, i);
        if (i > 0 && (table & PRESENT) == 0) {
            continue;
        }
        for (uint32_t j = 0; j < ENTRIES; j++) {
            uint32_t page = (table & PRESENT) != 0 ? entry_at(memory, memory_bytes, table, j) : 0;
            bool is_there = (page & PRESENT) != 0;
            fault->linear = (i * ENTRIES + j) * PAGE_BYTES;
            fault->physical = page & ~(uint32_t)(PAGE_BYTES - 1);
            fault->is_missing = !is_there;
            if (is_there ? fault->physical != fault->linear : fault->linear < FIRST_MIB) {
                return false;
            }
        }
    }
    return true;
}
