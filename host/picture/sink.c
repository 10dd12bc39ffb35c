/* SPDX-License-Identifier: MIT */
/* Where pictures go: the PNG file. */
#include "picture/sink.h"

#include <stdlib.h>

#include "base/complain.h"
#include "base/output.h"
#include "png_file.h"

struct png_sink {
    struct picture_sink sink; /* the first member */
    struct output output;
};

static bool show_png(struct picture_sink *sink, const struct shown_picture *picture) {
    struct png_sink *png = (struct png_sink *)sink;
    struct png_error error;
    if (write_png(png->output.file, picture->rgb, picture->width, picture->height, &error) !=
        PNG_OK) {
        output_complain(&png->output, error.message);
        return false;
    }
    return true;
}

static bool commit_png(struct picture_sink *sink) {
    return output_commit(&((struct png_sink *)sink)->output);
}

static void close_png(struct picture_sink *sink) {
    output_discard(&((struct png_sink *)sink)->output);
    free(sink);
}

struct picture_sink *png_sink_open(const char *path) {
    static const struct picture_sink_operations png_operations = {
        .show = show_png, .commit = commit_png, .close = close_png};
    struct png_sink *png = calloc(1, sizeof *png);
    if (png == NULL) {
        complain("out of memory");
        return NULL;
    }
    if (!output_open(&png->output, path)) {
        free(png);
        return NULL;
    }
    png->sink.operations = &png_operations;
    return &png->sink;
}

bool picture_sink_finish(struct picture_sink *sink, const struct shown_picture *picture) {
    return sink->operations->show(sink, picture) && sink->operations->commit(sink);
}

void picture_sink_close(struct picture_sink *sink) {
    if (sink != NULL) {
        sink->operations->close(sink);
    }
}

bool write_png_picture(const char *path, const uint8_t *rgb, unsigned width, unsigned height) {
    const struct shown_picture picture = {rgb, width, height};
    struct picture_sink *sink = png_sink_open(path);
    bool is_written = sink != NULL && picture_sink_finish(sink, &picture);
    picture_sink_close(sink);
    return is_written;
}
