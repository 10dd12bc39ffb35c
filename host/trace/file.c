/* SPDX-License-Identifier: MIT */
/* A trace as an operand of a sub-command. */
#include "trace/file.h"

#include <errno.h>
#include <string.h>

#include "base/complain.h"

int trace_file_complain(const char *path, const struct trace_error *error) {
    char text[512];
    (void)trace_error_format(text, sizeof text, path, error);
    complain("%s", text);
    /* A file that can't be read from its start is the wrong one; one that stops half-way is a
     * failure. */
    bool has_failed =
        error->status == TRACE_BUS_FAILED || (error->status == TRACE_IO_ERROR && error->offset > 0);
    return has_failed ? STATUS_FAILED : STATUS_BAD_INPUT;
}

int trace_file_open(const char *path, FILE **file, struct trace_reader *reader) {
    *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    if (*file == NULL) {
        return bad_input("%s: cannot be read: %s", path, strerror(errno));
    }
    if (trace_reader_open(reader, *file) != TRACE_OK) {
        return trace_file_complain(path, &reader->error);
    }
    return STATUS_DONE;
}

void trace_file_close(FILE *file) {
    if (file != NULL && file != stdin) {
        (void)fclose(file);
    }
}

int trace_file_fit(const char *path, struct trace_reader *reader, const struct board_options *board,
                   struct board_desc *desc) {
    struct trace_header header = {board->profile, board->base};
    if (reader->has_header && !board->has_profile) {
        header.profile = reader->header.profile;
    }
    if (reader->has_header && !board->has_base) {
        header.base = reader->header.base;
    }
    if (trace_reader_require(reader, &header) != TRACE_OK) {
        return trace_file_complain(path, &reader->error);
    }
    if (!board_base_is_offered(header.base)) {
        return bad_input(
            "%s: byte 12: the trace's base is %04X; the jumper offers " BOARD_BASES_TEXT, path,
            header.base);
    }
    *desc = board_default_desc(header.profile);
    desc->base = header.base;
    return STATUS_DONE;
}
