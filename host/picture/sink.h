/* SPDX-License-Identifier: MIT */
/* Where pictures go: a PNG file is the first place; windows and displays are others. */
#ifndef SUPERFRAME_PICTURE_SINK_H
#define SUPERFRAME_PICTURE_SINK_H

#include <stdbool.h>
#include <stdint.h>

/* A picture that is shown: rows from above, three bytes R, G, B a pixel, without gaps. */
struct shown_picture {
    const uint8_t *rgb;
    unsigned width, height;
};

struct picture_sink;

/* What a kind of sink does. Where an operation returns false, the reason has been printed. */
struct picture_sink_operations {
    /* Takes the picture. A sink that is a file takes one only. */
    bool (*show)(struct picture_sink *sink, const struct shown_picture *picture);

    /* Puts what was shown into its place, where it stays. */
    bool (*commit)(struct picture_sink *sink);

    /* Frees the sink. What was not committed is given up. */
    void (*close)(struct picture_sink *sink);
};

/* The first member of each kind of sink. */
struct picture_sink {
    const struct picture_sink_operations *operations;
};

/* Opens a sink that is a PNG file; "-": standard output. The path must outlive the sink. The file
 * appears at the commit, whole. Returns NULL, with the reason printed, if the file can't be written
 * or memory is out. */
struct picture_sink *png_sink_open(const char *path);

/* Shows a picture, and commits the sink. Returns false, with the reason printed, on failure. */
bool picture_sink_finish(struct picture_sink *sink, const struct shown_picture *picture);

/* Frees the sink; harmless on NULL. */
void picture_sink_close(struct picture_sink *sink);

/* Writes a picture to a PNG file of that path; as png_sink_open() and picture_sink_finish(). */
bool write_png_picture(const char *path, const uint8_t *rgb, unsigned width, unsigned height);

#endif
