/* SPDX-License-Identifier: MIT */
/* JSON as it is written: commas, brackets, escapes, and what is no number. */
#include "base/json.h"

#include <math.h>

#include "folder_fixture.h"
#include "json_check.h"

static char text[65536];

/* Opens a value that is written to memory. */
static struct json start(void) {
    struct json json = {.out = fmemopen(text, sizeof text, "w")};
    assert_non_null(json.out);
    return json;
}

static void assert_written(struct json *json, const char *expected) {
    assert_int_equal(fclose(json->out), 0);
    assert_string_equal(text, expected);
    assert_true(is_json(text));
}

static void objects_and_lists_nest(void **state) {
    (void)state;
    struct json json = start();
    json_begin_object(&json, NULL);
    json_count(&json, "count", UINT64_MAX);
    json_begin_list(&json, "list");
    json_real(&json, NULL, 0.1);
    json_begin_object(&json, NULL);
    json_flag(&json, "yes", true);
    json_end_object(&json);
    json_end_list(&json);
    json_begin_list(&json, "empty");
    json_end_list(&json);
    json_text(&json, "none", NULL);
    json_end_object(&json);
    assert_written(&json, "{\n"
                          "  \"count\": 18446744073709551615,\n"
                          "  \"list\": [\n"
                          "    0.10000000000000001,\n"
                          "    {\n"
                          "      \"yes\": true\n"
                          "    }\n"
                          "  ],\n"
                          "  \"empty\": [],\n"
                          "  \"none\": null\n"
                          "}\n");
}

static void numbers_are_rounded_and_hashes_keep_their_zeros(void **state) {
    (void)state;
    struct json json = start();
    json_begin_list(&json, NULL);
    json_rounded(&json, NULL, 1.0 / 3, 6);
    json_rounded(&json, NULL, 2e-5 / 3, 9);
    json_rounded(&json, NULL, (double)NAN, 9);
    json_decimal(&json, NULL, 2, 6);
    json_decimal(&json, NULL, -0.75, 1);
    json_hexadecimal(&json, NULL, 0xBEEF, 8);
    json_hexadecimal(&json, NULL, UINT64_MAX, 16);
    json_end_list(&json);
    assert_written(&json, "[\n"
                          "  0.333333,\n"
                          "  6.66666667e-06,\n"
                          "  null,\n"
                          "  2.000000,\n"
                          "  -0.8,\n"
                          "  \"0000beef\",\n"
                          "  \"ffffffffffffffff\"\n"
                          "]\n");
}

static void what_is_no_number_is_null(void **state) {
    (void)state;
    struct json json = start();
    json_begin_list(&json, NULL);
    json_real(&json, NULL, (double)NAN);
    json_real(&json, NULL, HUGE_VAL);
    json_real(&json, NULL, -HUGE_VAL);
    json_end_list(&json);
    assert_written(&json, "[\n  null,\n  null,\n  null\n]\n");
}

/* Whatever bytes a name has, what is written is JSON. */
static void any_bytes_become_a_string(void **state) {
    (void)state;
    uint32_t seed = 1;
    for (int i = 0; i < 2000; i++) {
        char bytes[24];
        for (size_t j = 0; j + 1 < sizeof bytes; j++) {
            seed = seed * 1664525u + 1013904223u;
            bytes[j] = (char)(seed >> 24);
        }
        bytes[sizeof bytes - 1] = '\0';
        struct json json = start();
        json_begin_object(&json, NULL);
        json_text(&json, bytes, bytes);
        json_end_object(&json);
        assert_int_equal(fclose(json.out), 0);
        if (!is_json(text)) {
            fail_msg("no JSON: %s", text);
        }
    }
}

/* Random values of random depth: commas and brackets stay in order. */
static void any_nesting_is_well_formed(void **state) {
    (void)state;
    uint32_t seed = 7;
    for (int i = 0; i < 500; i++) {
        bool is_list[20];
        int depth = 1;
        struct json json = start();
        json_begin_list(&json, NULL);
        is_list[0] = true;
        for (int step = 0; step < 60 && depth > 0; step++) {
            seed = seed * 1664525u + 1013904223u;
            const char *key = is_list[depth - 1] ? NULL : "key";
            switch (seed >> 29) {
            case 0:
            case 1:
                if (depth < 20) {
                    is_list[depth] = (seed >> 20 & 1) != 0;
                    (is_list[depth] ? json_begin_list : json_begin_object)(&json, key);
                    depth++;
                }
                break;
            case 2:
                if (depth > 1) {
                    depth--;
                    (is_list[depth] ? json_end_list : json_end_object)(&json);
                }
                break;
            default:
                json_count(&json, key, seed);
            }
        }
        for (; depth > 0; depth--) {
            (is_list[depth - 1] ? json_end_list : json_end_object)(&json);
        }
        assert_int_equal(fclose(json.out), 0);
        if (!is_json(text)) {
            fail_msg("no JSON: %s", text);
        }
    }
}

static void the_check_itself_refuses_what_is_no_json(void **state) {
    (void)state;
    static const char *const wrong[] = {"",      "{",    "{]",  "[1,]", "[1 2]",    "{\"a\"}",
                                        "01",    "nan",  "+1",  "[1]]", "\"\n\"",   "\"\\x\"",
                                        "{1:2}", "[,1]", "tru", "0x10", "{\"a\":}", "[1],"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        if (is_json(wrong[i])) {
            fail_msg("taken for JSON: %s", wrong[i]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(objects_and_lists_nest),
        cmocka_unit_test(numbers_are_rounded_and_hashes_keep_their_zeros),
        cmocka_unit_test(what_is_no_number_is_null),
        cmocka_unit_test(any_bytes_become_a_string),
        cmocka_unit_test(any_nesting_is_well_formed),
        cmocka_unit_test(the_check_itself_refuses_what_is_no_json),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
