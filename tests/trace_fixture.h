/* SPDX-License-Identifier: MIT */
/* Traces in memory for the suites that read them. */
#ifndef SUPERFRAME_TESTS_TRACE_FIXTURE_H
#define SUPERFRAME_TESTS_TRACE_FIXTURE_H

#include "board_fixture.h"

#include <stdlib.h>

#include "null_bus.h"
#include "trace_reader.h"
#include "trace_recorder.h"

/* The bytes of a file. */
struct bytes {
    uint8_t *data;
    size_t size;
};

static inline struct bytes bytes_of_file(FILE *file) {
    struct bytes bytes;
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    bytes.size = (size_t)ftell(file);
    bytes.data = malloc(bytes.size + 1);
    assert_non_null(bytes.data);
    rewind(file);
    assert_int_equal(fread(bytes.data, 1, bytes.size, file), bytes.size);
    return bytes;
}

static inline FILE *file_of_bytes(const void *data, size_t size) {
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    rewind(file);
    return file;
}

static inline FILE *file_of_text(const char *text) {
    return file_of_bytes(text, strlen(text));
}

/* Records accesses (of reads the value is what an empty slot gives) and rewinds the file. */
static inline FILE *record(const struct trace_access *accesses, size_t count,
                           enum trace_format format) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    struct bus empty;
    FILE *file = tmpfile();
    assert_non_null(file);
    null_bus_init(&empty);
    trace_recorder_init(&recorder, &empty, file, format, &header);
    for (size_t i = 0; i < count; i++) {
        if (accesses[i].is_read) {
            bus_read(&recorder.bus, accesses[i].port, accesses[i].width);
        } else {
            bus_write(&recorder.bus, accesses[i].port, accesses[i].value, accesses[i].width);
        }
    }
    assert_int_equal(trace_recorder_finish(&recorder), BUS_OK);
    rewind(file);
    return file;
}

#endif
