/* SPDX-License-Identifier: MIT */
/* Fuzzes floppies in files: what is read has a first sector, what is refused has a reason. The
 * first byte of the input says how many zeros follow the rest, which is what the file begins with.
 */
#include <string.h>

#include "boot/disk_image.h"
#include "fuzz.h"

enum { FDI_BYTES = 4096 + PC98_DISK_BYTES };

static struct pc98_disk disk;
static uint8_t file[FDI_BYTES];

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    static const size_t sizes[] = {0, PC98_DISK_BYTES, FDI_BYTES};
    struct input input = {bytes, count};
    char reason[240] = "";
    size_t size = sizes[take_byte(&input) % 3];
    const uint8_t *begin;
    size_t used = take_bytes(&input, sizeof file, &begin);
    memset(&disk, 0, sizeof disk);
    memset(file, 0, sizeof file);
    if (used > 0) {
        memcpy(file, begin, used);
    }
    bool is_read = disk_image_read(file, used > size ? used : size, &disk, reason, sizeof reason);
    assert(memchr(reason, '\0', sizeof reason) != NULL);
    assert(is_read == (reason[0] == '\0'));
    assert(!is_read || disk.status[0] == DISK_DONE);
    return 0;
}
