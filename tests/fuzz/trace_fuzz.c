/* SPDX-License-Identifier: MIT */
/* Fuzzes traces into the board. The first byte says whether the rest is a file as it is or the
 * payloads of blocks, whose checksums nobody could guess; how the file ends; and the form in which
 * what was read is recorded and read again. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <xxhash.h>

#include "fuzz.h"
#include "trace_recorder.h"
#include "trace_replay.h"
#include "unreadable_file.h"

enum {
    FRAMED = 1,     /* bits of the first byte */
    UNREADABLE = 2, /* the file has no end: reading it fails */
    AS_TEXT = 4,
    BYTES_MOST = 8192,
    ACCESSES_MOST = 4 * BYTES_MOST + 1
};

/* What reading a file gave. */
struct told {
    struct trace_access accesses[ACCESSES_MOST];
    size_t count;
    enum trace_status status;
};

static struct trace_reader reader;
static struct trace_recorder recorder;
static struct board board;
static struct told told, other;
static struct {
    uint8_t bytes[8 * BYTES_MOST];
    size_t count;
} file;

/* ---- The file ------------------------------------------------------------------------------- */

static void put(const void *bytes, size_t count) {
    assert(file.count + count <= sizeof file.bytes);
    memcpy(file.bytes + file.count, bytes, count);
    file.count += count;
}

/* Adds the checksum of what was put since `first`, and returns it. */
static uint64_t seal(size_t first, uint64_t seed) {
    uint8_t bytes[TRACE_CHECKSUM_SIZE];
    uint64_t checksum =
        XXH3_64bits_withSeed(file.bytes + first, file.count - first, (XXH64_hash_t)seed);
    trace_put(bytes, checksum, sizeof bytes);
    put(bytes, sizeof bytes);
    return checksum;
}

/* Makes a trace of profile, base, and blocks of which each says its length and its accesses. */
static void put_framed(struct input *input) {
    uint8_t header[TRACE_HEADER_SIZE - TRACE_CHECKSUM_SIZE] = {0}, end[TRACE_END_SIZE] = {0};
    uint64_t total = 0;
    memcpy(header, trace_magic, TRACE_MAGIC_SIZE);
    header[8] = TRACE_VERSION;
    header[10] = take_byte(input) & 1;
    trace_put(header + 12, take_number(input), 2);
    put(header, sizeof header);
    uint64_t checksum = seal(0, 0);
    while (input->count > 0) {
        uint8_t block[TRACE_BLOCK_HEADER_SIZE];
        const uint8_t *payload;
        unsigned wanted = take_number(input), accesses = take_number(input);
        size_t length = take_bytes(input, wanted, &payload), first = file.count;
        trace_put(block, length, 4);
        trace_put(block + 4, accesses, 4);
        put(block, sizeof block);
        put(payload, length);
        checksum = seal(first, checksum);
        total += accesses;
    }
    trace_put(end + 8, total, 8);
    put(end, sizeof end);
    seal(file.count - sizeof end, checksum);
}

/* Reads a file to its end, which stays open. */
static void read_all(FILE *opened, struct told *to) {
    to->count = 0;
    to->status = trace_reader_open(&reader, opened);
    while (to->status == TRACE_OK) {
        struct trace_access access;
        to->status = trace_reader_next(&reader, &access);
        if (to->status == TRACE_OK) {
            assert(access.width == BUS_BYTE || access.width == BUS_WORD);
            assert(access.width == BUS_WORD || access.value <= 0xFF);
            assert(to->count < ACCESSES_MOST);
            to->accesses[to->count++] = access;
        }
    }
    assert(reader.error.status == to->status && reader.accesses == to->count);
    assert(to->status == TRACE_END || reader.error.message[0] != '\0');
}

static void read_bytes(void *bytes, size_t count, struct told *to) {
    FILE *opened = fmemopen(bytes, count, "rb");
    assert(opened != NULL);
    read_all(opened, to);
    fclose(opened);
}

static void read_unreadable(struct told *to) {
    struct unreadable_file unreadable;
    bool is_open = unreadable_file_open(&unreadable, file.bytes, file.count);
    FILE *opened = fdopen(unreadable.reader, "rb");
    assert(is_open && opened != NULL);
    read_all(opened, to);
    fclose(opened);
    close(unreadable.writer);
}

/* ---- What must hold ------------------------------------------------------------------------- */

static void check_equal(size_t count) {
    for (size_t i = 0; i < count; i++) {
        assert(trace_access_equal(&told.accesses[i], &other.accesses[i]));
    }
}

/* Checks that an unreadable end is told as that, after whatever was there before it. */
static void check_unreadable(void) {
    read_unreadable(&other);
    assert(other.status != TRACE_END && other.status != TRACE_TRUNCATED);
    assert(told.status != TRACE_END || other.status == TRACE_IO_ERROR);
    assert(other.count == told.count || other.count + 1 == told.count);
    check_equal(other.count);
}

/* Plays the file into the board through a recorder; told gets what the board answered. */
static void replay(FILE *to, enum trace_format format) {
    const struct board_desc desc = board_default_desc(reader.header.profile);
    const struct trace_header header = {desc.profile, desc.base};
    struct board_bus board_bus;
    struct trace_replay played = {0};
    uint64_t reads = 0;
    FILE *opened = fmemopen(file.bytes, file.count, "rb");
    assert(opened != NULL && board_init(&board, &desc));
    board_bus_init(&board_bus, &board);
    trace_recorder_init(&recorder, &board_bus.bus, to, format, &header);
    (void)trace_reader_open(&reader, opened);
    assert(trace_replay(&reader, &recorder.bus, 0, &played) == told.status);
    fclose(opened);
    assert(trace_recorder_finish(&recorder) == BUS_OK);
    assert(played.accesses == told.count && board.accesses == told.count);
    for (size_t i = 0; i < told.count; i++) {
        reads += told.accesses[i].is_read;
    }
    assert(played.reads == reads && played.different_reads <= reads);
}

/* Checks that what was read is read again from what a recorder makes of it; of reads it has what
 * the board answers. */
static void check_recorded(enum trace_format format) {
    char *bytes = NULL;
    size_t count = 0;
    FILE *to = open_memstream(&bytes, &count);
    assert(to != NULL);
    replay(to, format);
    fclose(to);
    read_bytes(bytes, count, &other);
    free(bytes);
    assert(other.status == TRACE_END && other.count == told.count);
    for (size_t i = 0; i < told.count; i++) {
        if (told.accesses[i].is_read) {
            told.accesses[i].value = other.accesses[i].value;
        }
    }
    check_equal(told.count);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    struct input input = {bytes, count < BYTES_MOST ? count : BYTES_MOST};
    unsigned flags = take_byte(&input);
    file.count = 0;
    if ((flags & FRAMED) != 0) {
        put_framed(&input);
    } else {
        put(input.bytes, input.count);
    }
    read_bytes(file.bytes, file.count, &told);
    if ((flags & UNREADABLE) != 0) {
        check_unreadable();
    } else if (told.count > 0) {
        check_recorded((flags & AS_TEXT) != 0 ? TRACE_TEXT : TRACE_BINARY);
    }
    return 0;
}
