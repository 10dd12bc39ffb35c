/* SPDX-License-Identifier: MIT */
/* The machine's own ports with a fake in Linux's place: the order of arguments, who owns them, what
 * is opened, what is given up. */
#include "board_fixture.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ports_linux.h"

/* What the fake was asked for, in the order of the calls. */
static struct {
    char calls[256];
    unsigned long first, count;
    unsigned value, port;
    int allow_error, drop_error;
} fake;

static void note(const char *call) {
    strcat(fake.calls, call);
    strcat(fake.calls, " ");
}

static int fake_allow(unsigned long first, unsigned long count, int is_allowed) {
    note(is_allowed ? "allow" : "forbid");
    fake.first = first;
    fake.count = count;
    errno = fake.allow_error;
    return fake.allow_error != 0 ? -1 : 0;
}

static int fake_drop(void) {
    note("drop");
    errno = fake.drop_error;
    return fake.drop_error != 0 ? -1 : 0;
}

/* Linux's order: the value first. */
static void fake_outb(unsigned char value, unsigned short port) {
    note("outb");
    fake.value = value;
    fake.port = port;
}

static void fake_outw(unsigned short value, unsigned short port) {
    note("outw");
    fake.value = value;
    fake.port = port;
}

static unsigned char fake_inb(unsigned short port) {
    note("inb");
    fake.port = port;
    return 0x5A;
}

static unsigned short fake_inw(unsigned short port) {
    note("inw");
    fake.port = port;
    return 0xA55A;
}

static char owners[] = "/tmp/superframe-ioports-XXXXXX";
static const struct ports_linux_system system_of_test = {fake_allow, fake_outb, fake_outw, fake_inb,
                                                         fake_inw,   fake_drop, owners};

static struct ports_linux ports;
static char message[PORTS_LINUX_MESSAGE_SIZE];

/* Opens the ports at 02D0h with this list of owners. */
static enum ports_linux_result open_with(const char *list) {
    FILE *file = fopen(owners, "w");
    assert_non_null(file);
    fputs(list, file);
    fclose(file);
    message[0] = '\0';
    return ports_linux_open(&ports, 0x02D0, &system_of_test, message);
}

static int make_list(void **state) {
    (void)state;
    int descriptor = mkstemp(owners);
    return descriptor < 0 ? -1 : close(descriptor);
}

static int remove_list(void **state) {
    (void)state;
    return remove(owners);
}

static int forget(void **state) {
    (void)state;
    memset(&fake, 0, sizeof fake);
    bus_bind(NULL);
    return 0;
}

#define BRIDGE "0000-0cf7 : PCI Bus 0000:00\n"

static void outp_and_outb_have_the_other_order(void **state) {
    (void)state;
    assert_int_equal(open_with(BRIDGE), PORTS_LINUX_OPEN);
    bus_bind(&ports.bus);
    outp(0x02D8, 0x12);
    assert_int_equal(fake.value, 0x12);
    assert_int_equal(fake.port, 0x02D8);
    outpw(0x02D4, 0x0123);
    assert_int_equal(fake.value, 0x0123);
    assert_int_equal(fake.port, 0x02D4);
    assert_int_equal(inp(0x02D9), 0x5A);
    assert_int_equal(fake.port, 0x02D9);
    assert_int_equal(inpw(0x02DE), 0xA55A);
    assert_int_equal(fake.port, 0x02DE);
    assert_string_equal(fake.calls, "allow drop outb outw inb inw ");
    assert_int_equal(bus_flush(&ports.bus), BUS_OK);
}

static void sixteen_ports_are_opened_and_then_the_rights_given_up(void **state) {
    (void)state;
    assert_int_equal(open_with(""), PORTS_LINUX_OPEN);
    assert_int_equal(fake.first, 0x02D0);
    assert_int_equal(fake.count, 16);
    assert_string_equal(fake.calls, "allow drop ");
    assert_string_equal(message, "");
}

static void what_lies_outside_never_reaches_a_port(void **state) {
    static const struct {
        uint16_t port;
        unsigned width;
        bool is_allowed;
    } cases[] = {{0x02D0, 1, true},  {0x02D0, 2, true},  {0x02DF, 1, true},  {0x02DE, 2, true},
                 {0x02DF, 2, false}, {0x02E0, 1, false}, {0x02CF, 1, false}, {0x02CF, 2, false},
                 {0x00EE, 1, false}, {0xFFFF, 2, false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (int is_read = 0; is_read < 2; is_read++) {
            memset(&fake, 0, sizeof fake);
            assert_int_equal(open_with(""), PORTS_LINUX_OPEN);
            fake.calls[0] = '\0';
            if (is_read) {
                uint16_t value = bus_read(&ports.bus, cases[i].port, cases[i].width);
                assert_true(cases[i].is_allowed || value == (cases[i].width == 1 ? 0xFF : 0xFFFF));
            } else {
                bus_write(&ports.bus, cases[i].port, 0, cases[i].width);
            }
            assert_int_equal(fake.calls[0] != '\0', cases[i].is_allowed);
            assert_int_equal(ports.bus.status, cases[i].is_allowed ? BUS_OK : BUS_REFUSED);
        }
    }
}

static void another_owner_is_respected(void **state) {
    static const struct {
        const char *list, *owner;
    } cases[] = {
        {BRIDGE "  02d0-02df : dma2\n", "dma2"},
        {BRIDGE "  0200-02d0 : gameport\n", "gameport"},
        {BRIDGE "  02df-02ff : serial\n", "serial"},
        {"02d8-02d8 : a\n", " a "},
        {"0000-ffff : everything, no newline", "everything, no newline"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        memset(&fake, 0, sizeof fake);
        assert_int_equal(open_with(cases[i].list), PORTS_LINUX_OWNED);
        assert_non_null(strstr(message, cases[i].owner));
        assert_non_null(strstr(message, "ports 02D0-02DF belong to"));
        assert_string_equal(fake.calls, "");
        assert_int_equal(ports.bus.status, BUS_REFUSED);
    }
}

static void neighbours_and_what_is_no_owner_do_not_matter(void **state) {
    static const char *const lists[] = {BRIDGE "  02c0-02cf : a\n  02e0-02ef : b\n",
                                        "nonsense\n02d0\n02d0-\n02d0 02df : c\n-02df : d\n\n",
                                        "02d0-02df without a name\n"};
    (void)state;
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        assert_int_equal(open_with(lists[i]), PORTS_LINUX_OPEN);
    }
}

static void an_owner_that_can_not_be_found_out_counts_as_one(void **state) {
    struct ports_linux_system elsewhere = system_of_test;
    (void)state;
    assert_int_equal(open_with("0000-0000 : PCI Bus 0000:00\n  0000-0000 : dma2\n"),
                     PORTS_LINUX_OWNED);
    assert_non_null(strstr(message, "shows no addresses to this user"));
    elsewhere.owners = "/nowhere/ioports";
    assert_int_equal(ports_linux_open(&ports, 0x02D0, &elsewhere, message), PORTS_LINUX_OWNED);
    assert_non_null(strstr(message, "/nowhere/ioports: No such file"));
    elsewhere.owners = "/"; /* can be opened, but not read */
    assert_int_equal(ports_linux_open(&ports, 0x02D0, &elsewhere, message), PORTS_LINUX_OWNED);
    assert_non_null(strstr(message, "can't be found out: /: Is a directory"));
    assert_string_equal(fake.calls, "");
}

static void a_refusal_says_what_it_takes(void **state) {
    static const struct {
        int error;
        const char *help;
    } cases[] = {{EPERM, "CAP_SYS_RAWIO"},
                 {EACCES, "CAP_SYS_RAWIO"},
                 {ENOSYS, "no ports to open"},
                 {EINVAL, "Invalid argument"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fake.calls[0] = '\0';
        fake.allow_error = cases[i].error;
        assert_int_equal(open_with(""), PORTS_LINUX_REFUSED);
        assert_non_null(strstr(message, "ports 02D0-02DF can't be opened: "));
        assert_non_null(strstr(message, cases[i].help));
        assert_string_equal(fake.calls, "allow ");
        bus_write(&ports.bus, 0x02D0, 0, 1);
        assert_int_equal(ports.bus.status, BUS_REFUSED);
        assert_string_equal(fake.calls, "allow ");
    }
}

static void ports_are_closed_again_if_the_rights_can_not_be_given_up(void **state) {
    (void)state;
    fake.drop_error = EPERM;
    assert_int_equal(open_with(""), PORTS_LINUX_REFUSED);
    assert_non_null(strstr(message, "the privileges can't be dropped"));
    assert_string_equal(fake.calls, "allow drop forbid ");
    assert_int_equal(ports.bus.status, BUS_REFUSED);
}

/* The real thing, as far as no port is touched. */
static void linux_itself_is_complete(void **state) {
    (void)state;
    assert_true(ports_linux_system.allow != NULL && ports_linux_system.drop != NULL &&
                ports_linux_system.write_byte != NULL && ports_linux_system.write_word != NULL &&
                ports_linux_system.read_byte != NULL && ports_linux_system.read_word != NULL);
    assert_string_equal(ports_linux_system.owners, "/proc/ioports");
}

/* In a process of its own, because there is no way back: after it nobody is root any more. */
static void the_rights_are_really_given_up(void **state) {
    int status = 0;
    (void)state;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        if (ports_linux_system.drop() != 0) {
            /* Where the system has no ports to open it has nothing to give up either. */
            _exit(errno == ENOSYS ? 0 : 1);
        }
        _exit(geteuid() == 0 || getegid() == 0 ? 2 : setuid(0) == 0 ? 3 : 0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(outp_and_outb_have_the_other_order, forget),
        cmocka_unit_test_setup(sixteen_ports_are_opened_and_then_the_rights_given_up, forget),
        cmocka_unit_test_setup(what_lies_outside_never_reaches_a_port, forget),
        cmocka_unit_test_setup(another_owner_is_respected, forget),
        cmocka_unit_test_setup(neighbours_and_what_is_no_owner_do_not_matter, forget),
        cmocka_unit_test_setup(an_owner_that_can_not_be_found_out_counts_as_one, forget),
        cmocka_unit_test_setup(a_refusal_says_what_it_takes, forget),
        cmocka_unit_test_setup(ports_are_closed_again_if_the_rights_can_not_be_given_up, forget),
        cmocka_unit_test_setup(linux_itself_is_complete, forget),
        cmocka_unit_test_setup(the_rights_are_really_given_up, forget),
    };
    return cmocka_run_group_tests(tests, make_list, remove_list);
}
