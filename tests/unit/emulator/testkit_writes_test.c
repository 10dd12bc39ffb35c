/* SPDX-License-Identifier: MIT */
/* The test kit: expected writes against those that were made. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "match.h"

static struct superframe_kit *kit;

static int enter(void **state) {
    kit = superframe_kit_new(BOARD_1987);
    *state = kit;
    return kit != NULL ? 0 : -1;
}

static int leave(void **state) {
    (void)state;
    superframe_kit_free(kit);
    return 0;
}

static void write_five(void) {
    outpw(0x00D4, 0x0123);
    outp(0x00D8, 0xFF);
    (void)inp(0x00D8);
    outp(0x00DA, 0x80);
    outpw(0x00D4, 0x0124);
    outp(0x00D8, 0xFE);
}

/* Each line against the five writes; report: a fragment of what is said, NULL: they match. */
static const struct {
    const char *expected, *report;
} orders[] = {
    {"out16 00D4 0123\nout8 00D8 FF\nout8 00DA 80\nout16 00D4 0124\nout8 00D8 FE\n", NULL},
    {"OUT16 d4 123 # X\n\n out8 D8 ff\nout8 DA 80\nout16 D4 124\nout8 D8 FE", NULL},
    {"...", NULL},
    {"...\n...", NULL},
    {"...\nout8 00D8 FE", NULL},
    {"out16 00D4 0123\n...", NULL},
    {"...\nout16 00D4 ????\nout8 00D8 F?\n...\nout16 ??D4 0124\n...", NULL},
    {"...\nout8 00D? ??\nout16 00D4 0124\n...", NULL}, /* the first that fits is not the one */
    {"out16 00D4 0123\nout8 00D8 FF\n...\nout8 00DA 80\n...\nout8 00D8 FE", NULL},
    {"",
     "first at write 1 (of 5):\nexpected          (no more writes)\nfound          1  out16 00D4"},
    {"out16 00D4 0123\nout8 00D8 FE",
     "first at write 2 (of 5):\n               1  out16 00D4 0123\nexpected line  2  out8 00D8 FE\n"
     "found          2  out8 00D8 FF"},
    {"out8 00D4 23\n...", "expected line  1  out8 00D4 23"},
    {"out16 00D4 0123\n\n...\nout8 00D8 FD\n...", "expected line  4  out8 00D8 FD"},
    {"...\nout8 00DC ??", "expected line  2  out8 00DC ??"},
    {"...\nout8 00D8 FF", "the writes differ"},
    {"...\nout8 00D8 FE\nout8 00D8 FE", "found             (no more writes)"},
    {"out8 00D8 F?\n", "expected line  1  out8 00D8 F?"},
    {"...\nin8 00D8 FF\n", "line 2 of what is expected: a read; allowed are out8, out16 and ..."},
    {"out9 00D8 FF\n", "line 1 of what is expected: unknown operation"},
    {"\nout8 00D8\n", "line 2 of what is expected: bad value"},
    {"out8 00D8 FF FF\n", "line 1 of what is expected: more than"},
    {"... # whatever\n...# it is\n ...\t\nout8 00D8 FE", NULL},
    {"... out8 00D8 FD\n", "line 1 of what is expected: more than ...; allowed is a # comment"},
    {"out16    00D4    ????  \nout8    00D8    ??\nout16    00DA    0123",
     "expected line  3  out16    00DA    0123\n"},
};

static void writes_in_order(void **state) {
    char report[MATCH_REPORT_SIZE];
    (void)state;
    write_five();
    assert_int_equal(kit->count, 6);
    for (size_t i = 0; i < sizeof orders / sizeof orders[0]; i++) {
        bool does_match = match_writes(kit, orders[i].expected, report);
        if (does_match != (orders[i].report == NULL)) {
            fail_msg("\"%s\": %s", orders[i].expected, does_match ? "matched" : report);
        }
        if (!does_match && strstr(report, orders[i].report) == NULL) {
            fail_msg("\"%s\": \"%s\" is not in: %s", orders[i].expected, orders[i].report, report);
        }
    }
}

static void writes_in_any_order(void **state) {
    char report[MATCH_REPORT_SIZE];
    (void)state;
    write_five();
    assert_true(match_writes_any_order(kit,
                                       "out8 00D8 FE\nout8 00D8 FF\nout16 00D4 0124\n"
                                       "out8 00DA 80\nout16 00D4 0123\n",
                                       report));
    assert_false(match_writes_any_order(kit,
                                        "out8 00D8 FF\nout8 00D8 FF\nout16 00D4 0124\n"
                                        "out8 00DA 80\nout16 00D4 0123\n",
                                        report));
    assert_string_equal(report, "found, not expected: out8 00D8 FE\n"
                                "expected, not found: out8 00D8 FF\n");
    assert_false(match_writes_any_order(kit, "out8 00D8 F?\n", report));
    assert_non_null(strstr(report, "line 1 of what is expected: no ? and no ..."));
    assert_false(match_writes_any_order(kit, "...\n", report));
    assert_false(match_writes_any_order(kit, "out8\n", report));
    for (unsigned i = 0; i < 20; i++) {
        outp(0x00DC, (uint8_t)i);
    }
    assert_false(match_writes_any_order(kit, "", report));
    assert_non_null(strstr(report, "and 17 more\n"));
}

static void only_what_follows_the_mark_counts(void **state) {
    char report[MATCH_REPORT_SIZE];
    (void)state;
    write_five();
    superframe_kit_mark(kit);
    assert_true(match_writes(kit, "", report));
    outp(0x00D8, 1);
    assert_true(match_writes(kit, "out8 00D8 01", report));
    assert_true(match_writes_any_order(kit, "out8 00D8 01", report));
}

static void many_writes_are_all_remembered(void **state) {
    char report[MATCH_REPORT_SIZE];
    (void)state;
    for (unsigned i = 0; i < 100000; i++) {
        outp(0x00D8, (uint8_t)(i >> 8));
    }
    outp(0x00DA, 7);
    assert_int_equal(kit->count, 100001);
    assert_true(match_writes(kit, "...\nout8 00D8 86\nout8 00DA 07", report));
    assert_false(match_writes(kit, "...\nout8 00D8 85\nout8 00DA 07", report));
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, enter, leave)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(writes_in_order),
        TEST(writes_in_any_order),
        TEST(only_what_follows_the_mark_counts),
        TEST(many_writes_are_all_remembered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
