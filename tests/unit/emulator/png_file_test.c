/* SPDX-License-Identifier: MIT */
/* PNG files: round trips, every kind of colour, damage of every sort. */
#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "png_file.h"

#include <png.h>

static struct png_error error;

static void fill(uint8_t *rgb, size_t count) {
    uint32_t random = 12345;
    for (size_t i = 0; i < count; i++) {
        random = random * 1664525U + 1013904223U;
        rgb[i] = (uint8_t)(random >> 24);
    }
}

/* Writes a small picture into memory and gives its bytes; the caller frees them. */
static uint8_t *make_png(size_t *size) {
    uint8_t rgb[20 * 10 * 3];
    FILE *file = tmpfile();
    assert_non_null(file);
    fill(rgb, sizeof rgb);
    assert_int_equal(write_png(file, rgb, 20, 10, &error), PNG_OK);
    *size = (size_t)ftell(file);
    uint8_t *bytes = malloc(*size);
    assert_non_null(bytes);
    rewind(file);
    assert_int_equal(fread(bytes, 1, *size, file), *size);
    fclose(file);
    return bytes;
}

static enum png_status read_bytes(const uint8_t *bytes, size_t size, struct png_image *image) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    rewind(file);
    enum png_status status = read_png(file, image, &error);
    assert_int_equal(error.status, status);
    assert_true((status == PNG_OK) == (error.message[0] == '\0'));
    assert_true((status == PNG_OK) == (image->rgb != NULL));
    fclose(file);
    return status;
}

static void what_was_written_is_read_back(void **state) {
    static const struct {
        unsigned width, height;
    } sizes[] = {{1, 1}, {640, 400}, {7, 300}, {16384, 1}, {1, 16384}};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        size_t count = (size_t)sizes[i].width * sizes[i].height * 3;
        uint8_t *rgb = malloc(count);
        struct png_image image;
        FILE *file = tmpfile();
        assert_non_null(rgb);
        assert_non_null(file);
        fill(rgb, count);
        assert_int_equal(write_png(file, rgb, sizes[i].width, sizes[i].height, &error), PNG_OK);
        rewind(file);
        assert_int_equal(read_png(file, &image, &error), PNG_OK);
        assert_int_equal(image.width, sizes[i].width);
        assert_int_equal(image.height, sizes[i].height);
        assert_memory_equal(image.rgb, rgb, count);
        free_png(&image);
        free_png(&image);
        fclose(file);
        free(rgb);
    }
}

/* The header of a PNG lies at fixed places: IHDR's width, height, depth and colour type. */
static void the_file_is_8_bit_rgb_and_the_same_each_time(void **state) {
    static const uint8_t expected[26] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A, 0,
                                         0,    0,   13,  'I', 'H',  'D',  'R',  0,    0,
                                         0,    20,  0,   0,   0,    10,   8,    2};
    size_t size, again_size;
    (void)state;
    uint8_t *bytes = make_png(&size);
    uint8_t *again = make_png(&again_size);
    assert_memory_equal(bytes, expected, sizeof expected);
    assert_int_equal(size, again_size);
    assert_memory_equal(bytes, again, size);
    free(bytes);
    free(again);
}

/* Flat areas and slopes are what a rendered picture is made of: a hundredth of their bytes is left.
 */
static void flat_areas_and_slopes_are_made_small(void **state) {
    enum { WIDTH = 640, HEIGHT = 400, SIZE = WIDTH * HEIGHT * 3 };
    static uint8_t rgb[SIZE];
    (void)state;
    for (unsigned slope = 0; slope < 2; slope++) {
        for (size_t i = 0; i < SIZE; i++) {
            rgb[i] = (uint8_t)(slope * (i / 3 % WIDTH + i / 3 / WIDTH) + 40 * (i % 3));
        }
        FILE *file = tmpfile();
        assert_non_null(file);
        assert_int_equal(write_png(file, rgb, WIDTH, HEIGHT, &error), PNG_OK);
        assert_in_range(ftell(file), 1, SIZE / 100);
        fclose(file);
    }
}

/* Writes one row of a kind of PNG by libpng itself and reads it as RGB. */
static void read_one_row(int colour_type, int depth, int interlace, const uint8_t *row,
                         unsigned width, const uint8_t *expected) {
    FILE *file = tmpfile();
    struct png_image image;
    png_color palette[4] = {{0, 0, 0}, {255, 0, 0}, {0, 255, 0}, {1, 2, 3}};
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, width, 1, depth, colour_type, interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (colour_type == PNG_COLOR_TYPE_PALETTE) {
        png_set_PLTE(png, info, palette, 4);
    }
    png_write_info(png, info);
    int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; pass++) {
        png_write_row(png, row);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    rewind(file);
    assert_int_equal(read_png(file, &image, &error), PNG_OK);
    assert_int_equal(image.width, width);
    assert_memory_equal(image.rgb, expected, width * 3);
    free_png(&image);
    fclose(file);
}

static void every_kind_of_png_is_read_as_8_bit_rgb(void **state) {
    static const uint8_t grey[] = {0, 128, 255};
    static const uint8_t grey_bits[] = {0x60}; /* 0, 1, 1 */
    static const uint8_t grey_alpha[] = {10, 0, 20, 255};
    static const uint8_t rgba[] = {1, 2, 3, 0, 4, 5, 6, 255};
    static const uint8_t indices[] = {0x1B}; /* 0, 1, 2, 3 */
    static const uint8_t deep[] = {0xFF, 0xFF, 0x00, 0x00, 0x80, 0x80};
    (void)state;
    read_one_row(PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, grey, 3,
                 (const uint8_t[]){0, 0, 0, 128, 128, 128, 255, 255, 255});
    read_one_row(PNG_COLOR_TYPE_GRAY, 1, PNG_INTERLACE_NONE, grey_bits, 3,
                 (const uint8_t[]){0, 0, 0, 255, 255, 255, 255, 255, 255});
    read_one_row(PNG_COLOR_TYPE_GRAY_ALPHA, 8, PNG_INTERLACE_NONE, grey_alpha, 2,
                 (const uint8_t[]){10, 10, 10, 20, 20, 20});
    read_one_row(PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_ADAM7, rgba, 2,
                 (const uint8_t[]){1, 2, 3, 4, 5, 6});
    read_one_row(PNG_COLOR_TYPE_PALETTE, 2, PNG_INTERLACE_NONE, indices, 4,
                 (const uint8_t[]){0, 0, 0, 255, 0, 0, 0, 255, 0, 1, 2, 3});
    read_one_row(PNG_COLOR_TYPE_RGB, 16, PNG_INTERLACE_ADAM7, deep, 1,
                 (const uint8_t[]){255, 0, 128});
}

static void a_png_that_is_cut_anywhere_is_refused(void **state) {
    size_t size;
    struct png_image image;
    (void)state;
    uint8_t *bytes = make_png(&size);
    for (size_t length = 0; length < size; length++) {
        enum png_status status = read_bytes(bytes, length, &image);
        assert_int_equal(status, length < 8 ? PNG_NOT_PNG : PNG_DAMAGED);
        assert_string_equal(error.message, length < 8 ? "the file is too short for a PNG"
                                                      : "the file ends too early");
    }
    free(bytes);
}

/* Every chunk but the signature is under a CRC; a flipped bit of a length or of a chunk's name may
 * also be read as another chunk, but never as a whole picture. */
static void a_png_with_a_flipped_byte_is_refused(void **state) {
    size_t size;
    struct png_image image;
    (void)state;
    uint8_t *bytes = make_png(&size);
    for (size_t i = 0; i < size; i++) {
        bytes[i] ^= 0xFF;
        assert_int_not_equal(read_bytes(bytes, size, &image), PNG_OK);
        bytes[i] ^= 0xFF;
    }
    free(bytes);
}

static void a_file_that_is_no_png_is_called_so(void **state) {
    struct png_image image;
    (void)state;
    assert_int_equal(read_bytes((const uint8_t *)"", 0, &image), PNG_NOT_PNG);
    assert_int_equal(read_bytes((const uint8_t *)"GIF89a, and more", 16, &image), PNG_NOT_PNG);
    FILE *folder = fopen("/", "r");
    assert_non_null(folder);
    assert_int_equal(read_png(folder, &image, &error), PNG_IO_ERROR);
    assert_non_null(strstr(error.message, "directory"));
    fclose(folder);
}

/* Gives a file of which so many bytes can be read, and behind them nothing but errors. */
static FILE *file_that_fails_behind(const uint8_t *bytes, size_t good, char *buffer) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, good, file), good);
    rewind(file);
    assert_int_equal(setvbuf(file, buffer, _IOFBF, good), 0);
    assert_int_equal(ungetc(fgetc(file), file), bytes[0]); /* all of them are in the buffer now */
    int folder = open("/", O_RDONLY);
    assert_true(folder >= 0 && dup2(folder, fileno(file)) >= 0 && close(folder) == 0);
    return file;
}

static void a_read_that_fails_behind_the_signature_is_no_damage(void **state) {
    size_t size;
    struct png_image image;
    (void)state;
    uint8_t *bytes = make_png(&size);
    char *buffer = malloc(size);
    assert_non_null(buffer);
    for (size_t good = 8; good < size; good++) {
        FILE *file = file_that_fails_behind(bytes, good, buffer);
        errno = 0;
        assert_int_equal(read_png(file, &image, &error), PNG_IO_ERROR);
        assert_int_equal(error.status, PNG_IO_ERROR);
        assert_string_equal(error.message, strerror(EISDIR));
        assert_null(image.rgb);
        fclose(file);
    }
    free(buffer);
    free(bytes);
}

static void a_png_that_claims_to_be_huge_is_refused_before_memory_is_taken(void **state) {
    struct png_image image;
    static const unsigned sides[][2] = {{16385, 1}, {1, 16385}, {16384, 16384}};
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        size_t size;
        uint8_t *bytes = make_png(&size);
        png_save_uint_32(bytes + 16, sides[i][0]);
        png_save_uint_32(bytes + 20, sides[i][1]);
        uint32_t crc = 0xFFFFFFFFU; /* of the chunk's name and data */
        for (size_t j = 12; j < 29; j++) {
            crc ^= bytes[j];
            for (unsigned bit = 0; bit < 8; bit++) {
                crc = crc >> 1 ^ (0xEDB88320U & (0U - (crc & 1)));
            }
        }
        png_save_uint_32(bytes + 29, ~crc);
        assert_int_equal(read_bytes(bytes, size, &image), PNG_TOO_LARGE);
        assert_non_null(strstr(error.message, "16384"));
        free(bytes);
    }
}

static void an_impossible_size_is_not_written(void **state) {
    static const unsigned sides[][2] = {{0, 1}, {1, 0}, {16385, 1}, {1, 16385}, {16384, 16384}};
    FILE *file = tmpfile();
    (void)state;
    assert_non_null(file);
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        assert_int_equal(write_png(file, NULL, sides[i][0], sides[i][1], &error), PNG_TOO_LARGE);
        assert_int_equal(ftell(file), 0);
    }
    fclose(file);
}

static void a_full_disk_is_reported_with_its_reason(void **state) {
    static uint8_t rgb[640 * 400 * 3];
    (void)state;
    FILE *full = fopen("/dev/full", "w");
    if (full == NULL) {
        skip();
    }
    fill(rgb, sizeof rgb);
    assert_int_equal(write_png(full, rgb, 640, 400, &error), PNG_IO_ERROR);
    assert_non_null(strstr(error.message, "space"));
    fclose(full);
    full = fopen("/dev/full", "w"); /* so small that only the last flush meets the disk */
    assert_non_null(full);
    assert_int_equal(write_png(full, rgb, 1, 1, &error), PNG_IO_ERROR);
    assert_non_null(strstr(error.message, "space"));
    fclose(full);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_written_is_read_back),
        cmocka_unit_test(the_file_is_8_bit_rgb_and_the_same_each_time),
        cmocka_unit_test(flat_areas_and_slopes_are_made_small),
        cmocka_unit_test(every_kind_of_png_is_read_as_8_bit_rgb),
        cmocka_unit_test(a_png_that_is_cut_anywhere_is_refused),
        cmocka_unit_test(a_png_with_a_flipped_byte_is_refused),
        cmocka_unit_test(a_file_that_is_no_png_is_called_so),
        cmocka_unit_test(a_read_that_fails_behind_the_signature_is_no_damage),
        cmocka_unit_test(a_png_that_claims_to_be_huge_is_refused_before_memory_is_taken),
        cmocka_unit_test(an_impossible_size_is_not_written),
        cmocka_unit_test(a_full_disk_is_reported_with_its_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
