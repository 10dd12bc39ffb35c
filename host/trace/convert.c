/* SPDX-License-Identifier: MIT */
/* The conversion of a trace into its other form: accesses are read one by one, and recorded
 * again. */
#include "trace/convert.h"

#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/output.h"
#include "trace/file.h"
#include "trace_recorder.h"

/* A bus behind the recorder that answers each read with the value that the trace has for it. */
struct answering_bus {
    struct bus bus; /* the first member */
    uint16_t answer;
};

static void ignore_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    (void)bus;
    (void)port;
    (void)value;
    (void)width;
}

static uint16_t give_answer(struct bus *bus, uint16_t port, unsigned width) {
    (void)port;
    (void)width;
    return ((struct answering_bus *)bus)->answer;
}

static const struct bus_operations answering_operations = {ignore_write, give_answer, NULL};

struct conversion {
    const struct trace_conversion *asked;
    FILE *file;
    struct trace_reader reader;
    struct answering_bus answering;
    struct trace_recorder recorder;
    struct output output;
};

static int convert_accesses(struct conversion *conversion) {
    struct bus *recorder = &conversion->recorder.bus;
    uint64_t stop = conversion->asked->stop;
    struct trace_access access;
    while (recorder->status == BUS_OK && (stop == 0 || conversion->reader.accesses < stop)) {
        enum trace_status status = trace_reader_next(&conversion->reader, &access);
        if (status == TRACE_END) {
            break;
        }
        if (status != TRACE_OK) {
            return trace_file_complain(conversion->asked->path, &conversion->reader.error);
        }
        if (access.is_read) {
            conversion->answering.answer = access.value;
            (void)bus_read(recorder, access.port, access.width);
        } else {
            bus_write(recorder, access.port, access.value, access.width);
        }
    }
    if (trace_recorder_finish(&conversion->recorder) != BUS_OK) {
        output_complain(&conversion->output, strerror(conversion->recorder.error_number));
        return STATUS_FAILED;
    }
    return output_commit(&conversion->output) ? STATUS_DONE : STATUS_FAILED;
}

static int convert(struct conversion *conversion) {
    const struct trace_conversion *asked = conversion->asked;
    struct board_desc desc;
    int status = trace_file_open(conversion->asked->path, &conversion->file, &conversion->reader);
    if (status == STATUS_DONE) {
        status = trace_file_fit(conversion->asked->path, &conversion->reader, asked->board, &desc);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    if (!output_open(&conversion->output, asked->output)) {
        return STATUS_FAILED;
    }
    const struct trace_header header = {desc.profile, desc.base};
    conversion->answering.bus.operations = &answering_operations;
    trace_recorder_init(&conversion->recorder, &conversion->answering.bus, conversion->output.file,
                        asked->to, &header);
    return convert_accesses(conversion);
}

int trace_convert(const struct trace_conversion *asked) {
    struct conversion *conversion = calloc(1, sizeof *conversion); /* 130 KB */
    if (conversion == NULL) {
        return failure("out of memory");
    }
    conversion->asked = asked;
    int status = convert(conversion);
    output_discard(&conversion->output);
    trace_file_close(conversion->file);
    free(conversion);
    return status;
}
