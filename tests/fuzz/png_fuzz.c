/* SPDX-License-Identifier: MIT */
/* Fuzzes the reading of PNGs: it is refused with a reason, or what was read and written again reads
 * the same. The first byte says whether the rest is a file as it is or chunks, of which lengths and
 * checksums are then right and the picture is compressed: nobody could guess those. */
#include <libdeflate.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "png_file.h"

enum { BYTES_MOST = 8192, FILE_MOST = 32 * BYTES_MOST, PIXELS_COMPARED_MOST = 4096 };

static struct {
    uint8_t bytes[FILE_MOST];
    size_t count;
} file;

static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};

static void put(const void *bytes, size_t count) {
    assert(file.count + count <= sizeof file.bytes);
    memcpy(file.bytes + file.count, bytes, count);
    file.count += count;
}

static void put_32(uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        const uint8_t byte = (uint8_t)(value >> shift);
        put(&byte, 1);
    }
}

static void put_chunk(const char type[4], const uint8_t *data, size_t count) {
    put_32((uint32_t)count);
    size_t first = file.count;
    put(type, 4);
    put(data, count);
    put_32(libdeflate_crc32(0, file.bytes + first, file.count - first));
}

static void put_compressed(const uint8_t *data, size_t count) {
    static uint8_t compressed[2 * BYTES_MOST];
    struct libdeflate_compressor *compressor = libdeflate_alloc_compressor(1);
    assert(compressor != NULL);
    size_t size = libdeflate_zlib_compress(compressor, data, count, compressed, sizeof compressed);
    libdeflate_free_compressor(compressor);
    put_chunk("IDAT", compressed, size);
}

/* Makes a PNG of its header's fields, then of chunks: a byte for the type, two for the length. */
static void put_framed(struct input *input) {
    static const char types[][5] = {"IDAT", "PLTE", "tRNS", "gAMA", "sRGB", "cHRM", "bKGD", "pHYs",
                                    "tEXt", "zTXt", "iTXt", "iCCP", "sBIT", "hIST", "IEND", "IHDR"};
    enum { TYPES = sizeof types / sizeof types[0], HEADER = 13 };
    uint8_t header[HEADER] = {0};
    put(signature, sizeof signature);
    header[2] = take_byte(input) & 0x40; /* seldom large */
    header[3] = (uint8_t)take_byte(input);
    header[6] = take_byte(input) & 0x40;
    header[7] = (uint8_t)take_byte(input);
    for (int i = 8; i < HEADER; i++) {
        header[i] = (uint8_t)take_byte(input);
    }
    put_chunk("IHDR", header, sizeof header);
    while (input->count > 0) {
        const uint8_t *data;
        unsigned type = take_byte(input);
        size_t count = take_bytes(input, take_number(input), &data);
        if (type >= 0x80) {
            put_compressed(data, count);
        } else {
            put_chunk(types[type % TYPES], data, count);
        }
    }
    put_chunk("IEND", signature, 0);
}

static enum png_status read_bytes(void *bytes, size_t count, struct png_image *image) {
    struct png_error error;
    FILE *opened = fmemopen(bytes, count, "rb");
    assert(opened != NULL);
    enum png_status status = read_png(opened, image, &error);
    fclose(opened);
    assert(error.status == status && (status == PNG_OK) == (error.message[0] == '\0'));
    assert((status == PNG_OK) == (image->rgb != NULL));
    assert(status != PNG_IO_ERROR);
    return status;
}

static void check_written(const struct png_image *image) {
    struct png_image again;
    struct png_error error;
    char *bytes = NULL;
    size_t count = 0, size = (size_t)image->width * image->height * 3;
    FILE *to = open_memstream(&bytes, &count);
    assert(to != NULL);
    assert(write_png(to, image->rgb, image->width, image->height, &error) == PNG_OK);
    fclose(to);
    assert(read_bytes(bytes, count, &again) == PNG_OK);
    assert(again.width == image->width && again.height == image->height);
    assert(memcmp(again.rgb, image->rgb, size) == 0);
    free_png(&again);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    struct input input = {bytes, count < BYTES_MOST ? count : BYTES_MOST};
    struct png_image image;
    file.count = 0;
    if (take_byte(&input) % 2 == 1) {
        put_framed(&input);
    } else {
        put(input.bytes, input.count);
    }
    if (read_bytes(file.bytes, file.count, &image) == PNG_OK) {
        assert(image.width > 0 && image.height > 0);
        if ((uint64_t)image.width * image.height <= PIXELS_COMPARED_MOST) {
            check_written(&image);
        }
        free_png(&image);
    }
    return 0;
}
