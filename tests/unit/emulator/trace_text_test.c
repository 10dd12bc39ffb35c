/* SPDX-License-Identifier: MIT */
/* The plain-text form of a trace: what a line may hold, and what is said of a bad one. */
#include "board_fixture.h"

#include "trace.h"

static char message[TRACE_MESSAGE_SIZE];

static void a_line_is_an_operation_a_port_and_a_value_in_hex(void **state) {
    static const struct {
        const char *line;
        struct trace_access access;
    } cases[] = {{"out8 00D8 FF", {0x00D8, 0xFF, 1, false}},
                 {"out16 00D4 0123", {0x00D4, 0x0123, 2, false}},
                 {"in8 00D8 AA", {0x00D8, 0xAA, 1, true}},
                 {"in16 00D0 FFFF", {0x00D0, 0xFFFF, 2, true}},
                 {"  OUT8\td8\t 7 \r", {0x00D8, 0x07, 1, false}},
                 {"In16 0d0 abC#nothing", {0x00D0, 0x0ABC, 2, true}},
                 {"out8 ffff 0 # to nowhere", {0xFFFF, 0x00, 1, false}}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct trace_access access;
        assert_int_equal(trace_text_parse(cases[i].line, &access, message), TRACE_LINE_ACCESS);
        assert_true(trace_access_equal(&access, &cases[i].access));
    }
}

static void empty_lines_and_comments_hold_nothing(void **state) {
    static const char *const lines[] = {"", "   ", "\t\r", "#", "# out8 00D8 FF", "  # x"};
    struct trace_access access;
    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_int_equal(trace_text_parse(lines[i], &access, message), TRACE_LINE_EMPTY);
    }
}

static void a_bad_line_is_refused_with_what_is_allowed(void **state) {
    static const struct {
        const char *line, *allowed;
    } cases[] = {
        {"out 00D8 FF", "out8, out16, in8, in16"}, {"out32 00D8 FF", "out8, out16, in8, in16"},
        {"ou", "out8, out16, in8, in16"},          {"out8x 00D8 FF", "out8, out16, in8, in16"},
        {"8 00D8 FF", "out8, out16, in8, in16"},   {"out8", "1 to 4 hex digits"},
        {"out8 #", "1 to 4 hex digits"},           {"out8 000D8 FF", "1 to 4 hex digits"},
        {"out8 0xD8 FF", "1 to 4 hex digits"},     {"out8 -1 FF", "1 to 4 hex digits"},
        {"out8 00G8 FF", "1 to 4 hex digits"},     {"out8 00D8", "1 or 2 hex digits"},
        {"out8 00D8 100", "1 or 2 hex digits"},    {"in8 00D8 F?", "1 or 2 hex digits"},
        {"out16 00D8 12345", "1 to 4 hex digits"}, {"in16 00D8 h", "1 to 4 hex digits"},
        {"out8 00D8 FF FF", "a # comment"},        {"out8 00D8 FF;", "1 or 2 hex digits"},
        {"out8,00D8,FF", "out8, out16, in8, in16"}};
    struct trace_access access;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(trace_text_parse(cases[i].line, &access, message), TRACE_LINE_BAD);
        assert_non_null(strstr(message, cases[i].allowed));
    }
}

static void what_is_written_is_read_as_the_same_access(void **state) {
    uint64_t random = 99;
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        uint32_t draw = next_random(&random);
        struct trace_access access = {(uint16_t)(draw >> 16), (uint16_t)next_random(&random),
                                      (uint8_t)((draw & 1) + 1), (draw & 2) != 0};
        struct trace_access again;
        char text[TRACE_TEXT_SIZE];
        if (access.width == 1) {
            access.value &= 0xFF;
        }
        unsigned length = trace_text_format(text, &access);
        assert_int_equal(length, strlen(text));
        assert_int_equal(trace_text_parse(text, &again, message), TRACE_LINE_ACCESS);
        assert_true(trace_access_equal(&access, &again));
    }
}

static void the_written_form_has_capital_digits_at_full_width(void **state) {
    char text[TRACE_TEXT_SIZE];
    (void)state;
    trace_text_format(text, &(struct trace_access){0x00D8, 0x0A, 1, false});
    assert_string_equal(text, "out8 00D8 0A");
    trace_text_format(text, &(struct trace_access){0x0cd4, 0x0abc, 2, false});
    assert_string_equal(text, "out16 0CD4 0ABC");
    trace_text_format(text, &(struct trace_access){0, 0, 1, true});
    assert_string_equal(text, "in8 0000 00");
    trace_text_format(text, &(struct trace_access){0xFFFF, 0xFFFF, 2, true});
    assert_string_equal(text, "in16 FFFF FFFF");
}

static void accesses_are_equal_only_in_every_field(void **state) {
    const struct trace_access a = {0x00D8, 1, 1, false};
    const struct trace_access others[] = {
        {0x00DA, 1, 1, false}, {0x00D8, 2, 1, false}, {0x00D8, 1, 2, false}, {0x00D8, 1, 1, true}};
    (void)state;
    assert_true(trace_access_equal(&a, &a));
    for (unsigned i = 0; i < 4; i++) {
        assert_false(trace_access_equal(&a, &others[i]));
    }
}

static void an_error_names_the_line_or_the_byte(void **state) {
    char text[80];
    (void)state;
    trace_error_format(text, sizeof text, "a.txt",
                       &(struct trace_error){TRACE_BAD_LINE, 12, 99, "bad port"});
    assert_string_equal(text, "a.txt:12: bad port");
    trace_error_format(text, sizeof text, "a.sft",
                       &(struct trace_error){TRACE_CORRUPT, 0, 24, "corrupt"});
    assert_string_equal(text, "a.sft: byte 24: corrupt");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_is_an_operation_a_port_and_a_value_in_hex),
        cmocka_unit_test(empty_lines_and_comments_hold_nothing),
        cmocka_unit_test(a_bad_line_is_refused_with_what_is_allowed),
        cmocka_unit_test(what_is_written_is_read_as_the_same_access),
        cmocka_unit_test(the_written_form_has_capital_digits_at_full_width),
        cmocka_unit_test(accesses_are_equal_only_in_every_field),
        cmocka_unit_test(an_error_names_the_line_or_the_byte),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
