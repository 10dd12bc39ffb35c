/* SPDX-License-Identifier: MIT */
/* The page tables of a program, which the emulated CPU does not follow. */
#ifndef SUPERFRAME_BOOT_PAGING_H
#define SUPERFRAME_BOOT_PAGING_H

#include <stdbool.h>
#include <stdint.h>

/* What is wrong with page tables that do not leave every address as it is. */
struct paging_fault {
    uint32_t linear, physical;
    bool is_missing; /* a page below 1 MiB is not there: `physical` means nothing */
};

/* Tells whether the page tables map every page below 1 MiB, and every other page that they have, to
 * itself. directory: CR3. memory: the first memory_bytes of the machine. Otherwise *fault is the
 * first page that is not. Source: the Intel 386 manual, 5.2. */
bool paging_is_identity(const uint8_t *memory, uint32_t memory_bytes, uint32_t directory,
                        struct paging_fault *fault);

#endif
