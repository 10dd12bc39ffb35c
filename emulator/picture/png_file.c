/* SPDX-License-Identifier: MIT */
/* PNG files by libpng; what is written into them is compressed by libdeflate. */
#include "png_file.h"

#include <errno.h>
#include <libdeflate.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { MAXIMUM_SIDE = 16384, MAXIMUM_PIXELS = 64 * 1024 * 1024 };

static enum png_status fail(struct png_error *error, enum png_status status, const char *message) {
    error->status = status;
    snprintf(error->message, sizeof error->message, "%s", message);
    return status;
}

/* Records libpng's error and jumps out. An earlier error stays, because an input or output error
 * has said why already. */
static void on_error(png_structp png, png_const_charp message) {
    struct png_error *error = png_get_error_ptr(png);
    if (error->status == PNG_OK) {
        fail(error, PNG_DAMAGED, message);
    }
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message) {
    (void)png;
    (void)message;
}

static void fail_with_errno(png_structp png) {
    fail(png_get_error_ptr(png), PNG_IO_ERROR, strerror(errno));
    png_error(png, "input or output error");
}

static void write_bytes(png_structp png, png_bytep bytes, size_t count) {
    if (fwrite(bytes, 1, count, png_get_io_ptr(png)) != count) {
        fail_with_errno(png);
    }
}

static void flush_bytes(png_structp png) {
    if (fflush(png_get_io_ptr(png)) != 0) {
        fail_with_errno(png);
    }
}

static void read_bytes(png_structp png, png_bytep bytes, size_t count) {
    FILE *file = png_get_io_ptr(png);
    if (fread(bytes, 1, count, file) != count) {
        if (ferror(file)) {
            fail_with_errno(png);
        }
        png_error(png, "the file ends too early");
    }
}

static bool size_is_allowed(unsigned width, unsigned height) {
    return width >= 1 && height >= 1 && width <= MAXIMUM_SIDE && height <= MAXIMUM_SIDE &&
           (uint64_t)width * height <= MAXIMUM_PIXELS;
}

/* ---- Writing -------------------------------------------------------------------------------- */

/* What is written between a PNG's header and its end, in memory of its own. */
struct image_data {
    uint8_t *bytes;
    size_t size;
};

/* Writes bytes minus left. The inner loop has a constant number of bytes, so the compiler can use
 * vectors. */
static void subtract(const uint8_t *bytes, const uint8_t *left, size_t count,
                     uint8_t *restrict to) {
    enum { TOGETHER = 64 };
    size_t i = 0;
    for (; i + TOGETHER <= count; i += TOGETHER) {
        for (size_t j = i; j < i + TOGETHER; j++) {
            to[j] = (uint8_t)(bytes[j] - left[j]);
        }
    }
    for (; i < count; i++) {
        to[i] = (uint8_t)(bytes[i] - left[i]);
    }
}

/* Writes each row behind the number of its filter. The filter is the difference to the left,
 * because a rendered picture is flat areas and slopes. */
static void filter_rows(const uint8_t *rgb, size_t line, unsigned height, uint8_t *to) {
    enum { FILTER_SUB = 1, PIXEL = 3 };
    for (unsigned y = 0; y < height; y++) {
        *to++ = FILTER_SUB;
        memcpy(to, rgb, PIXEL);
        subtract(rgb + PIXEL, rgb, line - PIXEL, to + PIXEL);
        to += line;
        rgb += line;
    }
}

/* Compresses the filtered rows into data. Returns false if out of memory. */
static bool compress(const uint8_t *filtered, size_t size, struct image_data *data) {
    enum { LEVEL = 1 };
    struct libdeflate_compressor *compressor = libdeflate_alloc_compressor(LEVEL);
    if (compressor == NULL) {
        return false;
    }
    size_t most = libdeflate_zlib_compress_bound(compressor, size);
    data->bytes = malloc(most);
    if (data->bytes != NULL) {
        data->size = libdeflate_zlib_compress(compressor, filtered, size, data->bytes, most);
    }
    libdeflate_free_compressor(compressor);
    return data->bytes != NULL;
}

static bool make_data(const uint8_t *rgb, unsigned width, unsigned height,
                      struct image_data *data) {
    size_t line = (size_t)width * 3, size = (line + 1) * height;
    uint8_t *filtered = malloc(size);
    bool is_made = false;
    if (filtered != NULL) {
        filter_rows(rgb, line, height, filtered);
        is_made = compress(filtered, size, data);
    }
    free(filtered);
    return is_made;
}

/* Writes everything that libpng may jump out of. The function has no locals that change after
 * setjmp(), so none can be lost. Returns false if libpng jumped. */
static bool write_all(png_structp png, png_infop info, const struct image_data *data,
                      unsigned width, unsigned height) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_chunk(png, (png_const_bytep) "IDAT", data->bytes, data->size);
    png_write_chunk(png, (png_const_bytep) "IEND", NULL, 0);
    flush_bytes(png);
    return true;
}

enum png_status write_png(FILE *file, const uint8_t *rgb, unsigned width, unsigned height,
                          struct png_error *error) {
    struct image_data data = {NULL, 0};
    error->status = PNG_OK;
    error->message[0] = '\0';
    if (!size_is_allowed(width, height)) {
        return fail(error, PNG_TOO_LARGE, "a PNG is 1..16384 pixels wide and high here");
    }
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, error, on_error, on_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    if (info == NULL || !make_data(rgb, width, height, &data)) {
        fail(error, PNG_OUT_OF_MEMORY, "out of memory");
    } else {
        png_set_write_fn(png, file, write_bytes, flush_bytes);
        write_all(png, info, &data, width, height);
    }
    png_destroy_write_struct(&png, &info);
    free(data.bytes);
    return error->status;
}

/* ---- Reading -------------------------------------------------------------------------------- */

/* Reads the header and asks for 8-bit RGB. Keeps write_all()'s rule for locals. */
static bool read_header(png_structp png, png_infop info, struct png_image *image) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_info(png, info);
    image->width = png_get_image_width(png, info);
    image->height = png_get_image_height(png, info);
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

/* Reads the rows and the end of the file. Keeps write_all()'s rule for locals. */
static bool read_rows(png_structp png, png_infop info, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_read_image(png, rows);
    png_read_end(png, info);
    return true;
}

/* Reads the pixels by the open libpng structs. Errors are left in error. */
static void read_all(png_structp png, png_infop info, struct png_image *image,
                     struct png_error *error) {
    if (!read_header(png, info, image)) {
        return;
    }
    if (!size_is_allowed(image->width, image->height)) {
        snprintf(error->message, sizeof error->message,
                 "it is %u x %u; allowed are 16384 a side and 64 Mi pixels", image->width,
                 image->height);
        error->status = PNG_TOO_LARGE;
        return;
    }
    size_t line = (size_t)image->width * 3;
    png_bytepp rows = malloc(image->height * sizeof *rows);
    image->rgb = malloc(image->height * line);
    if (rows == NULL || image->rgb == NULL) {
        fail(error, PNG_OUT_OF_MEMORY, "out of memory");
    } else {
        for (size_t y = 0; y < image->height; y++) {
            rows[y] = image->rgb + y * line;
        }
        read_rows(png, info, rows);
    }
    free(rows);
}

enum png_status read_png(FILE *file, struct png_image *image, struct png_error *error) {
    enum { SIGNATURE_SIZE = 8 };
    png_byte signature[SIGNATURE_SIZE];
    error->status = PNG_OK;
    error->message[0] = '\0';
    memset(image, 0, sizeof *image);
    if (fread(signature, 1, SIGNATURE_SIZE, file) != SIGNATURE_SIZE) {
        return ferror(file) ? fail(error, PNG_IO_ERROR, strerror(errno))
                            : fail(error, PNG_NOT_PNG, "the file is too short for a PNG");
    }
    if (png_sig_cmp(signature, 0, SIGNATURE_SIZE) != 0) {
        return fail(error, PNG_NOT_PNG, "the file doesn't begin as a PNG does");
    }
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, error, on_error, on_warning);
    png_infop info = png == NULL ? NULL : png_create_info_struct(png);
    if (info == NULL) {
        png_destroy_read_struct(&png, NULL, NULL);
        return fail(error, PNG_OUT_OF_MEMORY, "out of memory");
    }
    png_set_user_limits(png, 0x7FFFFFFF, 0x7FFFFFFF); /* ours come later and say what is allowed */
    png_set_read_fn(png, file, read_bytes);
    png_set_sig_bytes(png, SIGNATURE_SIZE);
    read_all(png, info, image, error);
    png_destroy_read_struct(&png, &info, NULL);
    if (error->status != PNG_OK) {
        free_png(image);
    }
    return error->status;
}

void free_png(struct png_image *image) {
    free(image->rgb);
    memset(image, 0, sizeof *image);
}
