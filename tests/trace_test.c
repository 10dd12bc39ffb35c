/* SPDX-License-Identifier: MIT */
/* Recording and reading traces: round trips, the documented bytes, and everything that can be wrong
 * with a file. */
#include "trace_fixture.h"

#include <xxhash.h>
#include <zlib.h>

static struct trace_reader reader;

/* Reads to the end; the status that ended it. */
static enum trace_status read_all(FILE *file) {
    struct trace_access access;
    enum trace_status status = trace_reader_open(&reader, file);
    while (status == TRACE_OK) {
        status = trace_reader_next(&reader, &access);
    }
    assert_int_equal(reader.error.status, status);
    return status;
}

static enum trace_status read_all_bytes(const void *data, size_t size) {
    FILE *file = file_of_bytes(data, size);
    enum trace_status status = read_all(file);
    fclose(file);
    return status;
}

/* ---- Round trips ---------------------------------------------------------------------------- */

enum { RANDOM_ACCESSES = 200000 };

/* A mixture: pixel runs, any access at the board, any access at all. */
static void make_random(struct trace_access *accesses, size_t count, uint64_t seed) {
    uint16_t x = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t draw = next_random(&seed);
        struct trace_access *access = &accesses[i];
        access->value = (uint16_t)next_random(&seed);
        access->width = (uint8_t)((draw & 1) + 1);
        access->is_read = (draw & 2) != 0;
        access->port = (uint16_t)(0x00D0 + (draw >> 16 & 15));
        if ((i >> 10 & 1) == 0) { /* a stretch of pixels */
            access->is_read = false;
            access->width = i % 4 == 0 ? 2 : 1;
            access->port = (uint16_t)(i % 4 == 0 ? 0x00D4 : 0x00D6 + 2 * (i % 4));
            access->value = i % 4 == 0 ? x++ : access->value & 3;
        } else if ((draw >> 8 & 15) == 0) {
            access->port = (uint16_t)(draw >> 16);
        }
        if (access->is_read) {
            access->value = 0xFFFF; /* what an empty slot gives */
        }
        if (access->width == 1) {
            access->value &= 0xFF;
        }
    }
}

static void what_was_recorded_is_read_back_in_either_form(void **state) {
    struct trace_access *accesses = calloc(RANDOM_ACCESSES, sizeof *accesses);
    (void)state;
    assert_non_null(accesses);
    make_random(accesses, RANDOM_ACCESSES, 4711);
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        FILE *file = record(accesses, RANDOM_ACCESSES, (enum trace_format)format);
        struct trace_access access;
        assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
        assert_int_equal(reader.format, format);
        assert_int_equal(reader.has_header, format == TRACE_BINARY);
        for (size_t i = 0; i < RANDOM_ACCESSES; i++) {
            assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
            assert_true(trace_access_equal(&access, &accesses[i]));
            assert_int_equal(reader.accesses, i + 1);
        }
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
        fclose(file);
    }
    free(accesses);
}

static void a_trace_without_accesses_is_a_trace(void **state) {
    (void)state;
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        FILE *file = record(NULL, 0, (enum trace_format)format);
        assert_int_equal(read_all(file), TRACE_END);
        assert_int_equal(reader.accesses, 0);
        fclose(file);
    }
}

/* Foreign words take the most bytes of all: no block may overflow. */
static void a_trace_that_nothing_can_predict_is_read_back_too(void **state) {
    enum { COUNT = 100000 };
    struct trace_access *accesses = calloc(COUNT, sizeof *accesses);
    struct trace_access access;
    uint64_t random = 5;
    (void)state;
    assert_non_null(accesses);
    for (size_t i = 0; i < COUNT; i++) {
        accesses[i] = (struct trace_access){(uint16_t)(next_random(&random) | 0x8000),
                                            (uint16_t)next_random(&random), 2, false};
    }
    FILE *file = record(accesses, COUNT, TRACE_BINARY);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    for (size_t i = 0; i < COUNT; i++) {
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
        assert_true(trace_access_equal(&access, &accesses[i]));
    }
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
    fclose(file);
    free(accesses);
}

static void the_recorder_passes_every_access_on_and_records_the_answers(void **state) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_LATER, 0x00D0};
    struct trace_access access;
    (void)state;
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        FILE *file = tmpfile();
        assert_non_null(file);
        power_on(BOARD_LATER);
        trace_recorder_init(&recorder, &board_bus.bus, file, (enum trace_format)format, &header);
        bus_bind(&recorder.bus);
        put_pixel(3, 4, 0x112233);
        assert_int_equal(inp(0x00DA), 0x22);
        assert_int_equal(bus_flush(&recorder.bus), BUS_OK); /* in the middle: another block */
        assert_int_equal(inpw(0x00D0), 0x0000);
        assert_int_equal(trace_recorder_finish(&recorder), BUS_OK);
        bus_bind(NULL);
        assert_int_equal(board.accesses, 7);
        rewind(file);
        assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
        for (unsigned i = 0; i < 6; i++) {
            assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
        }
        assert_true(trace_access_equal(&access, &(struct trace_access){0x00DA, 0x22, 1, true}));
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
        assert_true(trace_access_equal(&access, &(struct trace_access){0x00D0, 0, 2, true}));
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
        fclose(file);
    }
}

/* The worst picture there is: noise, in which no value can be predicted. */
static void a_frame_of_noise_takes_the_documented_size_and_packs_to_under_1_mb(void **state) {
    enum { COUNT = 400 + 640 * 400 * 4 };
    struct trace_access *accesses = calloc(COUNT, sizeof *accesses);
    struct trace_access *next = accesses;
    uint64_t random = 1;
    (void)state;
    assert_non_null(accesses);
    for (unsigned y = 0; y < 400; y++) {
        *next++ = (struct trace_access){0x00D6, (uint16_t)y, 2, false};
        for (unsigned x = 0; x < 640; x++) {
            uint32_t noise = next_random(&random);
            *next++ = (struct trace_access){0x00D4, (uint16_t)x, 2, false};
            *next++ = (struct trace_access){0x00D8, (uint16_t)(noise & 0xFF), 1, false};
            *next++ = (struct trace_access){0x00DA, (uint16_t)(noise >> 8 & 0xFF), 1, false};
            *next++ = (struct trace_access){0x00DC, (uint16_t)(noise >> 16 & 0xFF), 1, false};
        }
    }
    FILE *file = record(accesses, COUNT, TRACE_BINARY);
    struct bytes bytes = bytes_of_file(file);
    assert_in_range(bytes.size, 900000, 1030000);
    uLongf packed_size = compressBound(bytes.size);
    uint8_t *packed = malloc(packed_size);
    assert_non_null(packed);
    assert_int_equal(compress2(packed, &packed_size, bytes.data, bytes.size, 6), Z_OK);
    assert_in_range(packed_size, 1, 1000000);
    free(packed);
    free(bytes.data);
    fclose(file);
    free(accesses);
}

/* ---- The documented bytes ------------------------------------------------------------------- */

static void put_number(uint8_t *bytes, uint64_t value, unsigned size) {
    for (unsigned i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

/* A trace put together by hand from docs/trace-format.md: one block. Returns its size. */
static size_t assemble(uint8_t *file, const uint8_t *payload, uint32_t size, uint32_t accesses,
                       uint64_t total) {
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

static void the_example_of_the_documentation_is_written_byte_for_byte(void **state) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    uint8_t expected[200];
    (void)state;
    power_on(BOARD_1987); /* it answers the read with 0000 */
    FILE *file = tmpfile();
    assert_non_null(file);
    trace_recorder_init(&recorder, &board_bus.bus, file, TRACE_BINARY, &header);
    for (unsigned i = 0; i < 8; i++) {
        bus_write(&recorder.bus, example[i].port, example[i].value, example[i].width);
    }
    bus_read(&recorder.bus, 0x00D0, 2);
    assert_int_equal(trace_recorder_finish(&recorder), BUS_OK);
    struct bytes bytes = bytes_of_file(file);
    size_t size = assemble(expected, example_payload, sizeof example_payload, 9, 9);
    assert_int_equal(bytes.size, size);
    assert_memory_equal(bytes.data, expected, size);
    free(bytes.data);
    fclose(file);
}

static void the_example_of_the_documentation_is_read(void **state) {
    uint8_t data[200];
    struct trace_access access;
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    FILE *file = file_of_bytes(data, size);
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(reader.header.profile, BOARD_1987);
    assert_int_equal(reader.header.base, 0x00D0);
    for (unsigned i = 0; i < 9; i++) {
        assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
        assert_true(trace_access_equal(&access, &example[i]));
    }
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
    fclose(file);
}

/* ---- What can be wrong ---------------------------------------------------------------------- */

static void a_trace_cut_anywhere_is_called_truncated_at_its_end(void **state) {
    uint8_t data[200];
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    for (size_t length = 1; length < size; length++) {
        assert_int_equal(read_all_bytes(data, length), TRACE_TRUNCATED);
        assert_int_equal(reader.error.offset, length);
        assert_non_null(strstr(reader.error.message, "truncated"));
    }
    assert_int_equal(read_all_bytes(data, size), TRACE_END);
}

/* A flipped length may also make the block reach past the end of the file. */
static void a_flipped_bit_anywhere_is_found(void **state) {
    uint8_t data[200];
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    for (size_t bit = 0; bit < size * 8; bit++) {
        data[bit / 8] ^= (uint8_t)(1U << bit % 8);
        enum trace_status status = read_all_bytes(data, size);
        if (bit < 8) { /* no longer 89h: then it is taken for text */
            assert_int_equal(status, TRACE_BAD_LINE);
        } else if (bit < 64) {
            assert_int_equal(status, TRACE_NOT_TRACE);
        } else if (bit < 24 * 8) {
            assert_int_equal(status, TRACE_CORRUPT);
            assert_int_equal(reader.error.offset, 0);
        } else if (bit < 28 * 8) {
            assert_true(status == TRACE_CORRUPT || status == TRACE_TRUNCATED);
        } else {
            assert_int_equal(status, TRACE_CORRUPT);
            assert_in_range(reader.error.offset, 24, 24 + 16 + 22);
        }
        data[bit / 8] ^= (uint8_t)(1U << bit % 8);
    }
}

static void bytes_after_the_end_are_found(void **state) {
    uint8_t data[200];
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    data[size] = 0;
    assert_int_equal(read_all_bytes(data, size + 1), TRACE_CORRUPT);
    assert_int_equal(reader.error.offset, size);
}

static void a_count_that_does_not_fit_is_found(void **state) {
    uint8_t data[200];
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 10);
    assert_int_equal(read_all_bytes(data, size), TRACE_CORRUPT);
    assert_int_equal(reader.error.offset, 24 + 16 + 22 + 8);
}

/* Payloads with right checksums that no recorder writes. */
static void a_malformed_payload_is_found(void **state) {
    static const struct {
        uint8_t payload[12];
        uint32_t size, accesses;
    } cases[] = {
        {{0x02}, 1, 1},                         /* no kind */
        {{0x02, 0x40, 0x00}, 3, 1},             /* kind 64 */
        {{0x02, 0x12, 0x00}, 3, 1},             /* half a value */
        {{0x01}, 1, 1},                         /* no value */
        {{0x03, 0x00}, 2, 1},                   /* no port */
        {{0x03, 0x04, 0xEE, 0x00, 0x00}, 5, 1}, /* unknown flag */
        {{0x03, 0x02, 0xEE, 0x00, 0x00}, 5, 1}, /* half a value */
        {{0x00, 0x00}, 2, 1},                   /* more than the accesses take */
        {{0x55, 0x00, 0x00, 0x00, 0x00}, 5, 5}, /* no second control byte */
        {{0x00}, 1, 5},                         /* more accesses than can be */
        {{0x00}, 1, 0},                         /* none */
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint8_t data[200];
        size_t size =
            assemble(data, cases[i].payload, cases[i].size, cases[i].accesses, cases[i].accesses);
        assert_int_equal(read_all_bytes(data, size), TRACE_CORRUPT);
        assert_in_range(reader.error.offset, 24, 24 + 8 + cases[i].size);
    }
}

/* Changes a byte of the header and mends its checksum. */
static enum trace_status read_with_header_byte(unsigned offset, uint8_t value) {
    uint8_t data[200];
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    data[offset] = value;
    put_number(data + 16, XXH3_64bits(data, 16), 8);
    return read_all_bytes(data, size);
}

static void another_version_is_named_before_anything_else_is_believed(void **state) {
    (void)state;
    assert_int_equal(read_with_header_byte(8, 2), TRACE_LATER_VERSION);
    assert_int_equal(reader.error.offset, 8);
    assert_non_null(strstr(reader.error.message, "version 2"));
    assert_int_equal(read_with_header_byte(9, 1), TRACE_LATER_VERSION);
    assert_int_equal(read_with_header_byte(10, 2), TRACE_CORRUPT);
    assert_int_equal(reader.error.offset, 10);
}

static void a_trace_for_another_board_is_refused_on_demand(void **state) {
    uint8_t data[200];
    (void)state;
    size_t size = assemble(data, example_payload, sizeof example_payload, 9, 9);
    FILE *file = file_of_bytes(data, size);
    const struct trace_header same = {BOARD_1987, 0x00D0};
    const struct trace_header profile = {BOARD_LATER, 0x00D0};
    const struct trace_header base = {BOARD_1987, 0x02D0};
    struct trace_access access;
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_reader_require(&reader, &same), TRACE_OK);
    assert_int_equal(trace_reader_require(&reader, &profile), TRACE_WRONG_PROFILE);
    assert_non_null(strstr(reader.error.message, "1987, not later"));
    assert_int_equal(reader.error.offset, 10);
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_WRONG_PROFILE);
    assert_int_equal(trace_reader_require(&reader, &base), TRACE_WRONG_BASE);
    assert_non_null(strstr(reader.error.message, "00D0, not 02D0"));
    fclose(file);
    file = file_of_text("out8 00D8 FF\n");
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_reader_require(&reader, &profile), TRACE_OK);
    fclose(file);
}

static void a_file_that_is_no_trace_is_called_so(void **state) {
    static const uint8_t png[24] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
    (void)state;
    assert_int_equal(read_all_bytes("", 0), TRACE_NOT_TRACE);
    assert_non_null(strstr(reader.error.message, "empty"));
    assert_int_equal(read_all_bytes(png, sizeof png), TRACE_NOT_TRACE);
    FILE *folder = fopen("/", "r");
    assert_non_null(folder);
    assert_int_equal(read_all(folder), TRACE_IO_ERROR);
    assert_non_null(strstr(reader.error.message, "directory"));
    fclose(folder);
}

static void a_bad_line_is_named_by_its_number(void **state) {
    char text[600];
    (void)state;
    assert_int_equal(read_all_bytes("# x\n\nout8 00D8 FF\r\nout9 0 0\n", 29), TRACE_BAD_LINE);
    assert_int_equal(reader.error.line, 4);
    assert_int_equal(reader.accesses, 1);
    assert_int_equal(read_all_bytes("out8 00D8 FF\nout8 \0 0\n", 23), TRACE_BAD_LINE);
    assert_int_equal(reader.error.line, 2);
    memset(text, ' ', sizeof text);
    text[255] = '\n';
    assert_int_equal(read_all_bytes(text, 256), TRACE_END);
    text[255] = ' ';
    assert_int_equal(read_all_bytes(text, 300), TRACE_BAD_LINE);
    assert_non_null(strstr(reader.error.message, "255"));
}

static void the_last_line_may_lack_its_end(void **state) {
    struct trace_access access;
    FILE *file = file_of_text("out8 00D8 FF\nin8 00D8 FF");
    (void)state;
    assert_int_equal(trace_reader_open(&reader, file), TRACE_OK);
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_OK);
    assert_true(access.is_read);
    assert_int_equal(trace_reader_next(&reader, &access), TRACE_END);
    fclose(file);
}

/* ---- The recorder's failures ---------------------------------------------------------------- */

static void a_full_disk_fails_the_bus_and_the_recording(void **state) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    (void)state;
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        struct bus empty;
        FILE *full = fopen("/dev/full", "w");
        if (full == NULL) {
            skip();
        }
        null_bus_init(&empty);
        trace_recorder_init(&recorder, &empty, full, (enum trace_format)format, &header);
        for (unsigned i = 0; i < 300000; i++) {
            bus_write(&recorder.bus, 0x00D8, (uint16_t)(i * 77 & 0xFF), 1);
        }
        assert_int_equal(recorder.bus.status, BUS_IO_ERROR);
        assert_int_equal(trace_recorder_finish(&recorder), BUS_IO_ERROR);
        assert_string_equal(strerror(recorder.error_number), "No space left on device");
        fclose(full);
        full = fopen("/dev/full", "w"); /* so short that only the end meets the disk */
        assert_non_null(full);
        trace_recorder_init(&recorder, &empty, full, (enum trace_format)format, &header);
        assert_int_equal(trace_recorder_finish(&recorder), BUS_IO_ERROR);
        fclose(full);
    }
}

static void a_device_that_fails_fails_the_recorder_but_not_the_trace(void **state) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    (void)state;
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        struct bus device;
        FILE *file = tmpfile();
        assert_non_null(file);
        null_bus_init(&device);
        trace_recorder_init(&recorder, &device, file, (enum trace_format)format, &header);
        bus_write(&recorder.bus, 0x00D8, 1, 1);
        bus_fail(&device, BUS_LOST);
        bus_write(&recorder.bus, 0x00D8, 2, 1);
        bus_write(&recorder.bus, 0x00D8, 3, 1);
        assert_int_equal(recorder.bus.status, BUS_LOST);
        assert_int_equal(trace_recorder_finish(&recorder), BUS_OK);
        rewind(file);
        assert_int_equal(read_all(file), TRACE_END);
        assert_int_equal(reader.accesses, 2);
        fclose(file);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_recorded_is_read_back_in_either_form),
        cmocka_unit_test(a_trace_without_accesses_is_a_trace),
        cmocka_unit_test(a_trace_that_nothing_can_predict_is_read_back_too),
        cmocka_unit_test(the_recorder_passes_every_access_on_and_records_the_answers),
        cmocka_unit_test(a_frame_of_noise_takes_the_documented_size_and_packs_to_under_1_mb),
        cmocka_unit_test(the_example_of_the_documentation_is_written_byte_for_byte),
        cmocka_unit_test(the_example_of_the_documentation_is_read),
        cmocka_unit_test(a_trace_cut_anywhere_is_called_truncated_at_its_end),
        cmocka_unit_test(a_flipped_bit_anywhere_is_found),
        cmocka_unit_test(bytes_after_the_end_are_found),
        cmocka_unit_test(a_count_that_does_not_fit_is_found),
        cmocka_unit_test(a_malformed_payload_is_found),
        cmocka_unit_test(another_version_is_named_before_anything_else_is_believed),
        cmocka_unit_test(a_trace_for_another_board_is_refused_on_demand),
        cmocka_unit_test(a_file_that_is_no_trace_is_called_so),
        cmocka_unit_test(a_bad_line_is_named_by_its_number),
        cmocka_unit_test(the_last_line_may_lack_its_end),
        cmocka_unit_test(a_full_disk_fails_the_bus_and_the_recording),
        cmocka_unit_test(a_device_that_fails_fails_the_recorder_but_not_the_trace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
