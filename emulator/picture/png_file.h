/* SPDX-License-Identifier: MIT */
/* Pictures as PNG files: 8-bit RGB, written and read by libpng, never ending the program.
 *
 * Not called png.h: that name is libpng's, and -Iemulator would hide libpng's file. */
#ifndef SUPERFRAME_EMULATOR_PNG_FILE_H
#define SUPERFRAME_EMULATOR_PNG_FILE_H

#include <stdint.h>
#include <stdio.h>

enum png_status {
    PNG_OK = 0,
    PNG_IO_ERROR,  /* the file could not be read or written; the message has errno's text */
    PNG_NOT_PNG,   /* the file doesn't begin as a PNG does */
    PNG_DAMAGED,   /* truncated, a wrong checksum, or against the format */
    PNG_TOO_LARGE, /* more than 16,384 pixels wide or high, or 64 Mi pixels in all */
    PNG_OUT_OF_MEMORY
};

enum { PNG_MESSAGE_SIZE = 128 };

/* What went wrong, in English, without a file name; "" after success. */
struct png_error {
    enum png_status status;
    char message[PNG_MESSAGE_SIZE];
};

/* A picture in memory. */
struct png_image {
    unsigned width, height; /* pixels, at least 1 */
    uint8_t *rgb;           /* width * height * 3 bytes, R, G, B from the top left */
};

/* Writes width x height pixels of R, G, B bytes to file, which stays open and is flushed. The
 * sizes are 1..16384. The same pixels always give the same bytes. */
enum png_status write_png(FILE *file, const uint8_t *rgb, unsigned width, unsigned height,
                          struct png_error *error);

/* Reads any PNG as 8-bit RGB. Grey and palette are widened, 16 bits are rounded to 8, alpha is
 * dropped, gamma is left alone. On success image->rgb is the caller's to give to free_png(); on
 * failure it is NULL. */
enum png_status read_png(FILE *file, struct png_image *image, struct png_error *error);

/* Frees what read_png() allocated; harmless on an image that is already freed. */
void free_png(struct png_image *image);

#endif
