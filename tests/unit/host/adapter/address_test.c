/* SPDX-License-Identifier: MIT */
/* Addresses of clients: which texts name a range, and which addresses lie in it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <arpa/inet.h>
#include <netinet/in.h>

#include <cmocka.h>

#include "adapter/address.h"

/* Makes an address as accept() gives it. */
static struct sockaddr_storage from(const char *text) {
    struct sockaddr_storage place;
    memset(&place, 0, sizeof place);
    place.ss_family = strchr(text, ':') != NULL ? AF_INET6 : AF_INET;
    void *bytes = place.ss_family == AF_INET6 ? (void *)&((struct sockaddr_in6 *)&place)->sin6_addr
                                              : (void *)&((struct sockaddr_in *)&place)->sin_addr;
    assert_int_equal(inet_pton(place.ss_family, text, bytes), 1);
    return place;
}

static struct address address(const char *text) {
    const struct sockaddr_storage place = from(text);
    struct address found;
    assert_true(address_of(&place, &found));
    return found;
}

static void a_range_holds_what_begins_with_its_bits(void **state) {
    static const struct {
        const char *range, *address;
        bool is_held;
    } cases[] = {{"192.0.2.7", "192.0.2.7", true},
                 {"192.0.2.7", "192.0.2.6", false},
                 {"192.0.2.7/32", "192.0.2.6", false},
                 {"192.0.2.7/31", "192.0.2.6", true},
                 {"192.0.2.7/31", "192.0.2.5", false},
                 {"10.1.0.0/16", "10.1.255.255", true},
                 {"10.1.0.0/16", "10.2.0.0", false},
                 {"10.0.0.0/9", "10.127.0.1", true},
                 {"10.0.0.0/9", "10.128.0.1", false},
                 {"0.0.0.0/0", "203.0.113.9", true},
                 {"0.0.0.0/0", "2001:db8::1", false},
                 {"0.0.0.0/0", "::1", false},
                 {"::/0", "203.0.113.9", true},
                 {"::/0", "2001:db8::1", true},
                 {"2001:db8::/32", "2001:db8:ffff::1", true},
                 {"2001:db8::/32", "2001:db9::1", false},
                 {"2001:db8::/31", "2001:db9::1", true},
                 {"2001:db8::1", "2001:db8::1", true},
                 {"2001:db8::1", "2001:db8::2", false},
                 {"192.0.2.7", "::ffff:192.0.2.7", true}, /* an IPv6 socket says it so */
                 {"::ffff:192.0.2.0/120", "192.0.2.200", true},
                 {"::ffff:192.0.2.0/120", "192.0.3.200", false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct address_range range;
        const struct address asked = address(cases[i].address);
        assert_true(address_range_read(cases[i].range, &range));
        if (address_range_holds(&range, &asked) != cases[i].is_held) {
            fail_msg("%s in %s", cases[i].address, cases[i].range);
        }
    }
}

static void other_texts_name_no_range(void **state) {
    static const char *const texts[] = {
        "",
        "/",
        "/8",
        "192.0.2",
        "192.0.2.256",
        "192.0.2.7/",
        "10.0.0.0/33",
        "10.0.0.0/-1",
        "10.0.0.0/8x",
        "10.0.0.0/8/8",
        "example.org",
        "2001:db8::/129",
        "2001:::1",
        "127.0.0.1 ",
        "[2001:db8::1]",
        "127.0.0.1:3240",
        "1111:2222:3333:4444:5555:6666:7777:8888:9999:aaaa:bbbb:cccc"};
    struct address_range range, before;
    (void)state;
    memset(&range, 0x5A, sizeof range);
    before = range;
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        if (address_range_read(texts[i], &range)) {
            fail_msg("\"%s\" is taken", texts[i]);
        }
        assert_memory_equal(&range, &before, sizeof range);
    }
}

static void the_machine_knows_its_own_addresses(void **state) {
    static const struct {
        const char *address;
        bool is_own;
    } cases[] = {{"127.0.0.1", true},  {"127.255.0.9", true},
                 {"128.0.0.1", false}, {"126.0.0.1", false},
                 {"::1", true},        {"::2", false},
                 {"::", false},        {"::ffff:127.0.0.1", true},
                 {"0.0.0.0", false},   {"::127.0.0.1", false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct address asked = address(cases[i].address);
        if (address_is_loopback(&asked) != cases[i].is_own) {
            fail_msg("%s", cases[i].address);
        }
    }
}

static void what_is_no_ip_address_is_none(void **state) {
    struct sockaddr_storage place;
    struct address found;
    (void)state;
    memset(&place, 0, sizeof place);
    place.ss_family = AF_UNIX;
    assert_false(address_of(&place, &found));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_range_holds_what_begins_with_its_bits),
        cmocka_unit_test(other_texts_name_no_range),
        cmocka_unit_test(the_machine_knows_its_own_addresses),
        cmocka_unit_test(what_is_no_ip_address_is_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
