/* SPDX-License-Identifier: MIT */
/* Floppies in files: raw, D88 and FDI are read, others are named. */
#include "boot/disk_image.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define ALLOWED   "allowed are a raw image of 1261568 bytes, a D88 and an FDI of such a disk"
#define HARD_DISK ", a hard disk's; floppies are taken: " ALLOWED
#define EXPORT    "; HxC's own program exports a raw one"
#define CONVERT   "; Virtual Floppy Image Converter for instance makes one of these of it"

enum { TRACKS = PC98_CYLINDERS * PC98_HEADS };

/* A file's bytes, and where the reason of a refusal goes. */
struct image {
    const uint8_t *bytes;
    size_t count;
    char *reason;
    size_t reason_size;
};

static uint32_t word(const struct image *image, size_t at) {
    return image->bytes[at] | (uint32_t)image->bytes[at + 1] << 8;
}

static uint32_t long_word(const struct image *image, size_t at) {
    return word(image, at) | word(image, at + 2) << 16;
}

/* Says why the file is refused, in one English sentence. Returns false. */
static bool refuse(const struct image *image, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

static bool refuse(const struct image *image, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(image->reason, image->reason_size, format, arguments);
    va_end(arguments);
    return false;
}

/* ---- D88 ------------------------------------------------------------------------------------- */

/* Offsets in the header of a disk, and in that of a sector. */
enum {
    D88_PROTECTED = 0x1A,
    D88_MEDIUM = 0x1B,
    D88_SIZE = 0x1C,
    D88_TRACKS = 0x20,
    D88_SHORT_HEADER = 0x2A0,
    D88_HEADER = 0x2B0,
    D88_2HD = 0x20,
    SECTOR_COUNT = 4,
    SECTOR_DENSITY = 6,
    SECTOR_STATUS = 8,
    SECTOR_SIZE = 14,
    SECTOR_HEADER = 16
};

/* Returns where the first track lies that the header names; 0: it names none. */
static uint32_t d88_first_track(const struct image *image) {
    for (size_t i = 0; i < TRACKS; i++) {
        uint32_t offset = long_word(image, D88_TRACKS + 4 * i);
        if (offset != 0) {
            return offset;
        }
    }
    return 0;
}

static bool is_d88(const struct image *image) {
    if (image->count < D88_SHORT_HEADER || (image->bytes[D88_MEDIUM] & 0x0F) != 0 ||
        image->bytes[D88_MEDIUM] > 0x40 || (image->bytes[D88_PROTECTED] & 0xEF) != 0) {
        return false;
    }
    uint32_t first = d88_first_track(image);
    return (first == D88_SHORT_HEADER || first == D88_HEADER) &&
           long_word(image, D88_SIZE) >= first;
}

static bool refuse_track(const struct image *image, unsigned track, const char *what) {
    return refuse(image, "a D88 image: cylinder %u, head %u %s", track / PC98_HEADS,
                  track % PC98_HEADS, what);
}

/* Reads the sector whose header lies at `at`, which is in the file. */
static bool read_d88_sector(const struct image *image, size_t at, unsigned track,
                            struct pc98_disk *disk) {
    const uint8_t *header = image->bytes + at;
    if (header[0] != track / PC98_HEADS || header[1] != track % PC98_HEADS || header[2] < 1 ||
        header[2] > PC98_SECTORS || header[3] != PC98_SECTOR_LENGTH ||
        header[SECTOR_DENSITY] != 0 || word(image, at + SECTOR_SIZE) != PC98_SECTOR_BYTES) {
        return refuse_track(image, track,
                            "has sectors of another format than 8 of 1024 bytes; " ALLOWED);
    }
    size_t sector = (size_t)track * PC98_SECTORS + header[2] - 1;
    memcpy(disk->bytes + sector * PC98_SECTOR_BYTES, header + SECTOR_HEADER, PC98_SECTOR_BYTES);
    disk->status[sector] = header[SECTOR_STATUS];
    return true;
}

/* Reads a track that begins at `at`. */
static bool read_d88_track(const struct image *image, size_t at, unsigned track,
                           struct pc98_disk *disk) {
    unsigned sectors = 1;
    memset(disk->status + (size_t)track * PC98_SECTORS, DISK_NO_SECTOR, PC98_SECTORS);
    for (unsigned i = 0; i < sectors; i++) {
        if (at > image->count || image->count - at < SECTOR_HEADER ||
            image->count - at - SECTOR_HEADER < word(image, at + SECTOR_SIZE)) {
            return refuse_track(image, track, "is past the end of the file: it ends too early");
        }
        sectors = word(image, at + SECTOR_COUNT);
        if (!read_d88_sector(image, at, track, disk)) {
            return false;
        }
        at += SECTOR_HEADER + PC98_SECTOR_BYTES;
    }
    return true;
}

static bool read_d88(const struct image *image, struct pc98_disk *disk) {
    if (image->bytes[D88_MEDIUM] != D88_2HD) {
        return refuse(image, "a D88 image of another disk than a 2HD one (medium %02Xh); " ALLOWED,
                      image->bytes[D88_MEDIUM]);
    }
    disk->is_protected = image->bytes[D88_PROTECTED] != 0;
    memset(disk->status, DISK_NO_ADDRESS_MARK, sizeof disk->status);
    for (unsigned track = 0; track < TRACKS; track++) {
        uint32_t offset = long_word(image, D88_TRACKS + 4 * track);
        if (offset != 0 && !read_d88_track(image, offset, track, disk)) {
            return false;
        }
    }
    return true;
}

/* ---- FDI ------------------------------------------------------------------------------------- */

/* Offsets in the header, which HDI has too, for hard disks. */
enum {
    FDI_HEADER_SIZE = 0x08,
    FDI_DATA_SIZE = 0x0C,
    FDI_SECTOR_SIZE = 0x10,
    FDI_SECTORS = 0x14,
    FDI_HEADS = 0x18,
    FDI_CYLINDERS = 0x1C,
    FDI_HEADER_LEAST = 0x20,
    FLOPPY_HEADS_MOST = 2,
    FLOPPY_CYLINDERS_MOST = 85
};

/* Tells whether the header's numbers agree with each other. */
static bool is_anex86(const struct image *image) {
    if (image->count < FDI_HEADER_LEAST || long_word(image, 0) != 0 ||
        long_word(image, FDI_HEADER_SIZE) < FDI_HEADER_LEAST) {
        return false;
    }
    uint64_t tracks =
        (uint64_t)long_word(image, FDI_HEADS) * long_word(image, FDI_CYLINDERS) & UINT32_MAX;
    uint64_t track = (uint64_t)long_word(image, FDI_SECTOR_SIZE) * long_word(image, FDI_SECTORS);
    return tracks > 0 && track > 0 && track <= UINT32_MAX &&
           tracks * track == long_word(image, FDI_DATA_SIZE);
}

static bool read_fdi(const struct image *image, struct pc98_disk *disk) {
    uint32_t header = long_word(image, FDI_HEADER_SIZE);
    uint32_t size = long_word(image, FDI_SECTOR_SIZE), sectors = long_word(image, FDI_SECTORS);
    uint32_t heads = long_word(image, FDI_HEADS), cylinders = long_word(image, FDI_CYLINDERS);
    if (heads > FLOPPY_HEADS_MOST || cylinders > FLOPPY_CYLINDERS_MOST) {
        return refuse(image, "an HDI image" HARD_DISK);
    }
    if (size != PC98_SECTOR_BYTES || sectors != PC98_SECTORS || heads != PC98_HEADS ||
        cylinders != PC98_CYLINDERS) {
        return refuse(image,
                      "an FDI image of %" PRIu32 " x %" PRIu32 " x %" PRIu32 " sectors of %" PRIu32
                      " bytes, not 77 x 2 x 8 of 1024; " ALLOWED,
                      cylinders, heads, sectors, size);
    }
    if (header > image->count || image->count - header < PC98_DISK_BYTES) {
        return refuse(image, "an FDI image that ends too early: %zu bytes, %" PRIu64 " are said",
                      image->count, (uint64_t)header + PC98_DISK_BYTES);
    }
    memcpy(disk->bytes, image->bytes + header, PC98_DISK_BYTES);
    return true;
}

/* ---- Others ---------------------------------------------------------------------------------- */

/* What files begin with that are no disk, or one that is not read. */
static const struct {
    size_t offset;
    const char *text;
    const char *what; /* and what to do about it */
} known[] = {
    {0, "T98FDDIMAGE.R", "an NFD image; " ALLOWED CONVERT},
    {0, "T98HDDIMAGE.R", "an NHD image" HARD_DISK},
    {0, "VFD1.", "a VFD image; " ALLOWED CONVERT},
    {0, "VHD1.", "a VHD image" HARD_DISK},
    {0, "conectix", "a VHD image" HARD_DISK},
    {0, "IMD ", "an ImageDisk image; " ALLOWED},
    {0, "HXCPICFE", "an HFE image; " ALLOWED EXPORT},
    {0, "HXCHFEV3", "an HFE image; " ALLOWED EXPORT},
    {0, "SCP", "an SCP image of the flux; " ALLOWED "; HxC's program exports a raw one"},
    {0, "PK\003\004", "a ZIP archive; unpack it first"},
    {0, "\037\213", "a gzip file; unpack it first"},
    {0, "7z\274\257", "a 7z archive; unpack it first"},
    {0, "Rar!", "a RAR archive; unpack it first"},
    {2, "-lh", "an LHA archive; unpack it first"},
};

/* Raw images of other disks, by their bytes. */
static const struct {
    size_t count;
    const char *what;
} sizes[] = {
    {1474560, "a raw image of 1.44 MB (80 x 2 x 18 sectors of 512 bytes); " ALLOWED},
    {1228800, "a raw image of 1.2 MB (80 x 2 x 15 sectors of 512 bytes); " ALLOWED},
    {737280, "a raw image of 720 KB (80 x 2 x 9 sectors of 512 bytes); " ALLOWED},
    {655360, "a raw image of 640 KB (80 x 2 x 8 sectors of 512 bytes); " ALLOWED},
};

/* Tells whether the file is a DCP image: a type, 161 marks for tracks and for all, then tracks. */
static bool is_dcp(const struct image *image) {
    enum { MARKS = 161, HEADER = 162 };
    unsigned ones = 0;
    if (image->count < HEADER || image->bytes[0] == 0 || image->bytes[0] > 0x21 ||
        (image->count - HEADER) % 128 != 0) {
        return false;
    }
    for (unsigned i = 1; i <= MARKS; i++) {
        if (image->bytes[i] > 1) {
            return false;
        }
        ones += image->bytes[i];
    }
    return ones > 0;
}

/* Says what the file is, as far as its content tells, and returns false. */
static bool name_it(const struct image *image) {
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        size_t length = strlen(known[i].text);
        if (image->count >= known[i].offset + length &&
            memcmp(image->bytes + known[i].offset, known[i].text, length) == 0) {
            return refuse(image, "%s", known[i].what);
        }
    }
    if (is_dcp(image)) {
        return refuse(image, "a DCP image; " ALLOWED CONVERT);
    }
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        if (image->count == sizes[i].count) {
            return refuse(image, "%s", sizes[i].what);
        }
    }
    return refuse(image, "no 2HD image: %s than 1261568 bytes; " ALLOWED,
                  image->count < PC98_DISK_BYTES ? "less" : "more");
}

bool disk_image_read(const uint8_t *bytes, size_t count, struct pc98_disk *disk, char *reason,
                     size_t reason_size) {
    const struct image image = {bytes, count, reason, reason_size};
    bool is_read = true;
    if (is_d88(&image)) {
        is_read = read_d88(&image, disk);
    } else if (count == PC98_DISK_BYTES) {
        memcpy(disk->bytes, bytes, PC98_DISK_BYTES);
    } else if (is_anex86(&image)) {
        is_read = read_fdi(&image, disk);
    } else {
        is_read = name_it(&image);
    }
    if (is_read && disk->status[0] != DISK_DONE) {
        return refuse(&image, "no disk to boot from: its first sector is missing or damaged");
    }
    return is_read;
}
