/* SPDX-License-Identifier: MIT */
/* Floppies in files: raw, D88 and FDI are read, others are named. */
#ifndef SUPERFRAME_DISK_IMAGE_H
#define SUPERFRAME_DISK_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "boot/pc98_disk.h"

/* So many bytes of a file are enough to read it, or to tell what it is instead. */
enum { DISK_IMAGE_BYTES_MOST = 0x400000 };

/* Reads a 2HD disk of 77 x 2 x 8 sectors of 1024 bytes from a file's bytes. *disk is all zero
 * before. Of a D88 file with several disks the first is read. Sectors that a D88 has not, or has as
 * damaged, are so on the disk too. Returns false, with one English sentence in `reason`, for what
 * is no such disk, and for a file that ends too early. Sources of the formats: the descriptions
 * that come with the emulators M88 (D88), Anex86 (FDI, HDI) and T98-Next (NFD, NHD). */
bool disk_image_read(const uint8_t *bytes, size_t count, struct pc98_disk *disk, char *reason,
                     size_t reason_size);

#endif
