/* SPDX-License-Identifier: MIT */
/* Everything that can be wrong with a trace, and with the disk that it goes to. */
#include <errno.h>
#include <fcntl.h>
#include <unistd.h>

#include "trace_fixture.h"
#include "unreadable_file.h"

#include <errno.h>

static struct trace_reader reader;

/* Reads to the end; the status that ended it. */
static enum trace_status read_all(FILE *file) {
    struct trace_access access;
    uint64_t given = 0;
    enum trace_status status = trace_reader_open(&reader, file);
    while (status == TRACE_OK) {
        status = trace_reader_next(&reader, &access);
        given += status == TRACE_OK;
    }
    assert_int_equal(reader.accesses, given);
    assert_int_equal(reader.error.status, status);
    return status;
}

static enum trace_status read_all_bytes(const void *data, size_t size) {
    FILE *file = file_of_bytes(data, size);
    enum trace_status status = read_all(file);
    fclose(file);
    return status;
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

/* Reads so many bytes of a trace, behind which the file fails. */
static void check_failing_read(const void *data, size_t readable, uint64_t accesses) {
    struct unreadable_file unreadable;
    assert_true(unreadable_file_open(&unreadable, data, readable));
    FILE *file = fdopen(unreadable.reader, "rb");
    assert_non_null(file);
    assert_int_equal(read_all(file), TRACE_IO_ERROR);
    assert_int_equal(reader.error.offset, readable);
    assert_int_equal(reader.error.line, 0);
    assert_string_equal(reader.error.message, strerror(EAGAIN));
    assert_int_equal(reader.accesses, accesses);
    fclose(file);
    close(unreadable.writer);
}

static void a_read_that_fails_anywhere_is_told_as_that(void **state) {
    static const char text[] = "# x\nout8 00D8 FF\n\nin16 00D0 1234 # y\r\nout8 D8 7\n";
    uint8_t binary[200];
    (void)state;
    for (size_t readable = 0; readable < sizeof text; readable++) {
        uint64_t accesses = 0;
        for (size_t i = 0; i < readable; i++) {
            accesses += text[i] == '\n' && i > sizeof "# x" && text[i - 1] != '\n';
        }
        check_failing_read(text, readable, accesses);
    }
    size_t size = assemble(binary, example_payload, sizeof example_payload, 9, 9);
    const size_t block_end = size - 24;
    for (size_t readable = 0; readable <= size; readable++) {
        check_failing_read(binary, readable, readable < block_end ? 0 : 9);
    }
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

/* Lets a file go on in another one; the caller keeps both. */
static void redirect(FILE *file, int to) {
    assert_true(dup2(to, fileno(file)) >= 0);
}

/* Records on a disk that is full for one write and has room again. With a buffer, that write is the
 * flush. */
static void assert_remembers_one_failure(enum trace_format format, bool has_buffer,
                                         bool spoils_head) {
    static struct trace_recorder recorder;
    const struct trace_header header = {BOARD_1987, 0x00D0};
    struct bus empty;
    FILE *file = tmpfile(), *before = tmpfile(), *after = tmpfile();
    int full = open("/dev/full", O_WRONLY);
    assert_true(file != NULL && before != NULL && after != NULL && full >= 0);
    redirect(file, spoils_head ? full : fileno(before));
    assert_int_equal(setvbuf(file, NULL, has_buffer ? _IOFBF : _IONBF, BUFSIZ), 0);
    null_bus_init(&empty);
    trace_recorder_init(&recorder, &empty, file, format, &header);
    redirect(file, full);
    bus_write(&recorder.bus, 0x00D8, 1, 1);
    assert_int_equal(bus_flush(&recorder.bus), BUS_IO_ERROR);
    redirect(file, fileno(after));
    bus_write(&recorder.bus, 0x00D8, 2, 1);
    assert_int_equal(bus_flush(&recorder.bus), BUS_IO_ERROR);
    assert_int_equal(trace_recorder_finish(&recorder), BUS_IO_ERROR);
    assert_int_equal(recorder.error_number, ENOSPC);
    assert_true(has_buffer || lseek(fileno(after), 0, SEEK_END) == 0);
    assert_int_equal(close(full), 0);
    fclose(file);
    fclose(before);
    fclose(after);
}

static void one_write_that_fails_is_remembered_and_nothing_follows_it(void **state) {
    (void)state;
    if (access("/dev/full", W_OK) != 0) {
        skip();
    }
    for (int format = TRACE_BINARY; format <= TRACE_TEXT; format++) {
        assert_remembers_one_failure((enum trace_format)format, false, false);
        assert_remembers_one_failure((enum trace_format)format, false, true);
        assert_remembers_one_failure((enum trace_format)format, true, false);
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
        cmocka_unit_test(a_read_that_fails_anywhere_is_told_as_that),
        cmocka_unit_test(a_full_disk_fails_the_bus_and_the_recording),
        cmocka_unit_test(one_write_that_fails_is_remembered_and_nothing_follows_it),
        cmocka_unit_test(a_device_that_fails_fails_the_recorder_but_not_the_trace),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
