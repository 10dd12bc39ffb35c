/* SPDX-License-Identifier: MIT */
/* The options about adapters, and what is said where there is none. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "adapter/drivers.h"
#include "options_fixture.h"

static struct options options;
static struct options_error error;

static bool parse_line(const char *line) {
    return parse(line, &options, &error);
}

static void usb_and_hid_take_a_serial_number_or_none(void **state) {
    (void)state;
    assert_true(parse_line("render fig3 --bus usb"));
    assert_int_equal(options.bus.choice, BUS_CHOICE_USB);
    assert_null(options.bus.adapter.serial);
    assert_int_equal(options.bus.adapter.verify_percent, 0);
    assert_true(parse_line("render fig3 --bus hid:A1-b --wait --verify"));
    assert_int_equal(options.bus.choice, BUS_CHOICE_HID);
    assert_string_equal(options.bus.adapter.serial, "A1-b");
    assert_true(options.bus.adapter.waits);
    assert_int_equal(options.bus.adapter.verify_percent, 100);
    assert_true(parse_line("render fig3 --bus usb:X --verify=7"));
    assert_int_equal(options.bus.adapter.verify_percent, 7);
}

static void what_does_not_go_with_them_is_refused(void **state) {
    static const char *const lines[][2] = {
        {"render fig3 --bus usb:", "usb[:SERIAL]"},
        {"render fig3 --bus usbx", "usb[:SERIAL]"},
        {"render fig3 --bus usb --verify=0", "1..100"},
        {"render fig3 --bus usb --verify=101", "1..100"},
        {"render fig3 --bus hid --strict", "--strict goes with --bus emulator only"},
        {"render fig3 --bus trace:x --wait", "--wait goes with --bus usb and --bus hid only"},
    };
    (void)state;
    for (unsigned i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        assert_false(parse_line(lines[i][0]));
        assert_non_null(strstr(error.text, lines[i][1]));
    }
}

static void the_virtual_adapter_has_options_of_its_own(void **state) {
    (void)state;
    assert_true(parse_line("adapter --listen 0.0.0.0:1 --serial AB-1 --once -o s.png"));
    assert_string_equal(text_of_option("listen"), "0.0.0.0:1");
    assert_string_equal(text_of_option("serial"), "AB-1");
    assert_true(flag_of_option("once"));
    assert_string_equal(options.output, "s.png");
    assert_false(parse_line("adapter --serial a_b"));
    assert_false(parse_line("adapter --serial 12345678901234567890123456789012"));
    assert_false(parse_line("devices --wait"));
}

static void the_adapter_that_is_meant_is_found_among_several(void **state) {
    struct usb_found found[2] = {{"A", "here", true, NULL}, {"B", "there", true, NULL}};
    char reason[USB_LINK_REASON_SIZE] = "";
    unsigned index = 9;
    (void)state;
    assert_int_equal(usb_choose(found, 2, "B", &index, reason), USB_OPEN_OK);
    assert_int_equal(index, 1);
    assert_int_equal(usb_choose(found, 1, NULL, &index, reason), USB_OPEN_OK);
    assert_int_equal(index, 0);
    assert_int_equal(usb_choose(found, 2, NULL, &index, reason), USB_OPEN_REFUSED);
    assert_non_null(strstr(reason, "2 adapters"));
    assert_non_null(strstr(reason, " A B"));
    assert_int_equal(usb_choose(found, 2, "C", &index, reason), USB_OPEN_ABSENT);
    assert_non_null(strstr(reason, "no adapter \"C\""));
    assert_int_equal(usb_choose(found, 0, NULL, &index, reason), USB_OPEN_ABSENT);
    assert_non_null(strstr(reason, "1209:9801"));
    found[0].is_accessible = false;
    found[0].serial[0] = '\0';
    assert_int_equal(usb_choose(found, 2, "A", &index, reason), USB_OPEN_DENIED);
    assert_non_null(strstr(reason, "70-superframe.rules"));
}

/* The reason has room for some of the numbers; what lies behind it is another's. */
static void many_adapters_with_long_numbers_fit_into_the_reason(void **state) {
    static struct usb_found found[USB_FOUND_MOST];
    struct {
        char reason[USB_LINK_REASON_SIZE], behind[USB_LINK_REASON_SIZE];
    } texts;
    unsigned index = 0;
    (void)state;
    memset(found, 'x', sizeof found);
    for (unsigned count = 2; count <= USB_FOUND_MOST; count++) {
        memset(&texts, '!', sizeof texts);
        for (unsigned i = 0; i < count; i++) {
            found[i].serial[USB_NAME_SIZE - 1] = '\0';
        }
        assert_int_equal(usb_choose(found, count, NULL, &index, texts.reason), USB_OPEN_REFUSED);
        assert_non_null(memchr(texts.reason, '\0', sizeof texts.reason));
        for (size_t i = 0; i < sizeof texts.behind; i++) {
            assert_int_equal(texts.behind[i], '!');
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(usb_and_hid_take_a_serial_number_or_none),
        cmocka_unit_test(what_does_not_go_with_them_is_refused),
        cmocka_unit_test(the_virtual_adapter_has_options_of_its_own),
        cmocka_unit_test(the_adapter_that_is_meant_is_found_among_several),
        cmocka_unit_test(many_adapters_with_long_numbers_fit_into_the_reason),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
