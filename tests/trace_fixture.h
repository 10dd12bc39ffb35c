/* SPDX-License-Identifier: MIT */
/* Traces in memory for the suites that read them. */
#ifndef SUPERFRAME_TESTS_TRACE_FIXTURE_H
#define SUPERFRAME_TESTS_TRACE_FIXTURE_H

#include "board_fixture.h"

#include <stdlib.h>
#include <xxhash.h>

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

/* ---- The example of docs/trace-format.md */

static inline void put_number(uint8_t *bytes, uint64_t value, unsigned size) {
    for (unsigned i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

/* A trace put together by hand from docs/trace-format.md: one block. Returns its size. */
static inline size_t assemble(uint8_t *file, const uint8_t *payload, uint32_t size,
                              uint32_t accesses, uint64_t total) {
    static const uint8_t header[16] = {0x89, 0x53, 0x46, 0x54, 0x0D, 0x0A, 0x1A, 0x0A,
                                       1,    0,    0,    0,    0xD0, 0,    0,    0};
    memcpy(file, header, sizeof header);
    XXH64_hash_t checksum = XXH3_64bits(file, 16);
    put_number(file + 16, checksum, 8);
    uint8_t *block = file + 24;
    put_number(block, size, 4);
    put_number(block + 4, accesses, 4);
    memcpy(block + 8, payload, size);
    checksum = XXH3_64bits_withSeed(block, 8 + (size_t)size, checksum);
    put_number(block + 8 + size, checksum, 8);
    uint8_t *end = block + 16 + size;
    put_number(end, 0, 8);
    put_number(end + 8, total, 8);
    checksum = XXH3_64bits_withSeed(end, 16, checksum);
    put_number(end + 16, checksum, 8);
    return (size_t)(end + 24 - file);
}

static const struct trace_access example[9] = {
    {0x00D6, 0x0005, 2, false}, {0x00D4, 0x0000, 2, false}, {0x00D8, 0xFF, 1, false},
    {0x00D4, 0x0001, 2, false}, {0x00D8, 0xFF, 1, false},   {0x00D4, 0x0002, 2, false},
    {0x00D8, 0x7F, 1, false},   {0x00EE, 0xC0, 1, false},   {0x00D0, 0x0000, 2, true}};

static const uint8_t example_payload[22] = {0xAA, 0x1A, 0x05, 0x00, 0x12, 0x00, 0x00, 0x20,
                                            0xFF, 0x12, 0x01, 0x00, 0xD0, 0x7F, 0x00, 0xEE,
                                            0x00, 0xC0, 0x02, 0x03, 0x00, 0x00};

#endif
