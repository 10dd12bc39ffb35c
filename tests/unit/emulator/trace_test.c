/* SPDX-License-Identifier: MIT */
/* Recording and reading traces: round trips, the size, the documented bytes. */
#include "trace_fixture.h"

#include <libdeflate.h>

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
    struct libdeflate_compressor *compressor = libdeflate_alloc_compressor(6);
    assert_non_null(compressor);
    size_t packed_most = libdeflate_zlib_compress_bound(compressor, bytes.size);
    uint8_t *packed = malloc(packed_most);
    assert_non_null(packed);
    size_t packed_size =
        libdeflate_zlib_compress(compressor, bytes.data, bytes.size, packed, packed_most);
    assert_in_range(packed_size, 1, 1000000);
    libdeflate_free_compressor(compressor);
    free(packed);
    free(bytes.data);
    fclose(file);
    free(accesses);
}

/* ---- The documented bytes ------------------------------------------------------------------- */

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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_was_recorded_is_read_back_in_either_form),
        cmocka_unit_test(a_trace_without_accesses_is_a_trace),
        cmocka_unit_test(a_trace_that_nothing_can_predict_is_read_back_too),
        cmocka_unit_test(the_recorder_passes_every_access_on_and_records_the_answers),
        cmocka_unit_test(a_frame_of_noise_takes_the_documented_size_and_packs_to_under_1_mb),
        cmocka_unit_test(the_example_of_the_documentation_is_written_byte_for_byte),
        cmocka_unit_test(the_example_of_the_documentation_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
