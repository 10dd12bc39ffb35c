/* SPDX-License-Identifier: MIT */
/* The virtual adapter, with the patience that people get, among clients who do not behave: silent,
 * slow, in crowds, not allowed; and what it says of them. */
#include <fcntl.h>
#include <sys/stat.h>

#include "adapter_process.h"
#include "usb_fixture.h"
#include "usbip_client.h"

enum { CROWD = 16, LISTS = 5000, TIMES = 400 };

static struct adapter_process server;

static int start_server(void **state) {
    const char *const words[] = {"-o", server.picture, NULL};
    (void)state;
    adapter_start(&server, words);
    return 0;
}

static int stop_server(void **state) {
    (void)state;
    adapter_stop(&server);
    return 0;
}

/* Asks for the list. Returns the milliseconds that it took. */
static int64_t time_of_list(void) {
    int64_t began = stopwatch_ms();
    int asking = connect_to(server.port);
    assert_true(client_list(asking));
    (void)close(asking);
    return stopwatch_ms() - began;
}

static void end_within_a_second(void) {
    assert_true(adapter_end(&server) < 1000);
}

/* ---- Crowds ---------------------------------------------------------------------------------- */

static void silent_connections_keep_nobody_out_and_end(void **state) {
    int silent[CROWD];
    (void)state;
    for (unsigned i = 0; i < CROWD; i++) {
        silent[i] = connect_to(server.port);
    }
    assert_true(time_of_list() < 1000);
    for (unsigned i = 0; i < CROWD; i++) {
        assert_true(is_closed_within(silent[i], 6000));
        (void)close(silent[i]);
    }
    assert_non_null(strstr(adapter_said(&server), "left: it took too long to ask for something"));
}

/* Only who has the device takes buffers for transfers. */
static void visitors_take_little_memory(void **state) {
    int silent[2 * CROWD];
    (void)state;
    (void)time_of_list();
    long before = adapter_memory_kb(&server);
    for (unsigned i = 0; i < 2 * CROWD; i++) {
        silent[i] = connect_to(server.port);
    }
    (void)time_of_list(); /* all have been let in */
    assert_true(adapter_memory_kb(&server) - before < 1024);
    for (unsigned i = 0; i < 2 * CROWD; i++) {
        (void)close(silent[i]);
    }
}

/* Each process of the crowd asks, is answered, and asks again. */
static void thousands_of_lists_for_a_crowd_at_once(void **state) {
    pid_t processes[CROWD];
    (void)state;
    for (unsigned i = 0; i < CROWD; i++) {
        processes[i] = fork();
        assert_true(processes[i] >= 0);
        if (processes[i] == 0) {
            for (unsigned j = i; j < LISTS; j += CROWD) {
                int asking = connect_to(server.port);
                if (!client_list(asking)) {
                    _exit(1);
                }
                (void)close(asking);
            }
            _exit(0);
        }
    }
    for (unsigned i = 0; i < CROWD; i++) {
        int status = -1;
        assert_int_equal(waitpid(processes[i], &status, 0), processes[i]);
        assert_int_equal(status, 0);
    }
}

static void who_reads_a_byte_a_second_stops_nobody(void **state) {
    static struct usbip_client client;
    uint8_t byte;
    (void)state;
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    client_stuff(&client);
    for (unsigned i = 0; i < 3; i++) {
        assert_int_equal(recv(client.socket, &byte, 1, 0), 1);
        assert_true(time_of_list() < 1000);
        pause_ms(1000);
    }
    end_within_a_second();
    (void)close(client.socket);
}

/* ---- The device changes hands ---------------------------------------------------------------- */

/* Has the device many times. A transfer lies before the end of every second client: the server has
 * to read that first. */
static void attach_again_and_again(void (*leave)(int)) {
    static const uint8_t data[16384];
    static struct usbip_client client;
    for (unsigned i = 0; i < TIMES; i++) {
        client_init(&client, connect_to(server.port), false);
        assert_int_equal(client_import(client.socket), 0);
        if (i % 2 != 0) {
            assert_true(client_submit(&client, 1, false, NULL, data, sizeof data) != 0);
        }
        leave(client.socket);
    }
}

static void close_with_end(int descriptor) {
    (void)close(descriptor);
}

static void the_device_is_free_once_its_client_has_closed(void **state) {
    (void)state;
    attach_again_and_again(close_with_end);
    end_within_a_second();
    assert_null(strstr(adapter_said(&server), "another client has the device"));
}

static void the_device_is_free_once_its_client_has_reset(void **state) {
    (void)state;
    attach_again_and_again(close_with_reset);
    end_within_a_second();
    assert_null(strstr(adapter_said(&server), "another client has the device"));
}

/* The picture is replaced, so that each writing gives the name to another file. */
static void the_picture_is_written_once_a_second_and_at_the_end(void **state) {
    struct stat seen, now;
    unsigned written = 0;
    (void)state;
    assert_int_equal(stat(server.picture, &seen), 0);
    int64_t began = stopwatch_ms();
    while (stopwatch_ms() - began < 2500) {
        int visitor = connect_to(server.port);
        assert_int_equal(client_import(visitor), 0);
        (void)close(visitor);
        assert_int_equal(stat(server.picture, &now), 0);
        written += now.st_ino != seen.st_ino || now.st_mtim.tv_nsec != seen.st_mtim.tv_nsec;
        seen = now;
    }
    assert_in_range(written, 1, 2);
    end_within_a_second();
    assert_int_equal(stat(server.picture, &now), 0);
    assert_true(now.st_ino != seen.st_ino || now.st_mtim.tv_nsec != seen.st_mtim.tv_nsec);
}

/* ---- Few descriptors ------------------------------------------------------------------------- */

/* Runs with so few descriptors that one client with the device and some visitors take all. Who is
 * silent then makes room; the server sleeps meanwhile, and finds a descriptor for the picture. */
static void run_with_few_descriptors(rlim_t most, bool is_list_answered) {
    static struct usbip_client client;
    const char *const words[] = {"-o", server.picture, NULL};
    struct stat first, last;
    int silent[20];
    server.descriptors = most;
    adapter_start(&server, words);
    assert_int_equal(stat(server.picture, &first), 0);
    double used = seconds_of_children();
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    for (unsigned i = 0; i < 20; i++) {
        silent[i] = connect_to(server.port);
    }
    if (is_list_answered) {
        assert_true(time_of_list() < 1000);
    }
    pause_ms(2000);
    (void)close(client.socket);
    pause_ms(1200);
    assert_int_equal(stat(server.picture, &last), 0);
    assert_true(first.st_ino != last.st_ino || first.st_mtim.tv_nsec != last.st_mtim.tv_nsec);
    assert_true(time_of_list() < 1000);
    end_within_a_second();
    used = seconds_of_children() - used;
    assert_true(used < 0.9); /* of 3.2 seconds and more: the start takes some of it */
    for (unsigned i = 0; i < 20; i++) {
        (void)close(silent[i]);
    }
}

static void visitors_make_room_where_descriptors_are_short(void **state) {
    (void)state;
    run_with_few_descriptors(8, true);
}

static void nobody_is_let_in_where_no_visitor_can_make_room(void **state) {
    (void)state;
    run_with_few_descriptors(6, false);
}

/* ---- Who may come, and what is said ---------------------------------------------------------- */

static void only_allowed_addresses_are_served(void **state) {
    const char *const words[] = {"--allow", "127.0.0.2", "--allow", "127.1.0.0/16", NULL};
    static const struct {
        const char *from;
        bool is_served;
    } cases[] = {{"127.0.0.1", false},
                 {"127.0.0.2", true},
                 {"127.0.0.3", false},
                 {"127.1.77.8", true},
                 {"127.2.0.1", false}};
    (void)state;
    adapter_start(&server, words);
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        int asking = connect_between(cases[i].from, "127.0.0.1", server.port);
        assert_true(asking >= 0);
        if (cases[i].is_served) {
            assert_true(client_list(asking));
        } else {
            assert_true(is_closed_within(asking, 1000));
        }
        (void)close(asking);
    }
    assert_non_null(strstr(adapter_said(&server), "refused: --allow does not name its address"));
}

static unsigned port_of(int descriptor) {
    struct sockaddr_in place;
    socklen_t size = sizeof place;
    assert_int_equal(getsockname(descriptor, (struct sockaddr *)&place, &size), 0);
    return ntohs(place.sin_port);
}

/* Lets in three visitors: one looks, one has the device and leaves, one has it to the end. */
static void let_three_come(unsigned ports[3]) {
    int first = connect_to(server.port);
    assert_true(client_list(first));
    int second = connect_to(server.port);
    assert_int_equal(client_import(second), 0);
    ports[0] = port_of(first);
    ports[1] = port_of(second);
    (void)close(first);
    (void)close(second);
    int third = connect_to(server.port);
    assert_int_equal(client_import(third), 0);
    ports[2] = port_of(third);
    end_within_a_second();
    (void)close(third);
}

/* Asserts that these are the lines of one client, in their order. */
static void assert_told(unsigned port, const char *const told[3]) {
    char name[64], lines[1024] = "";
    (void)snprintf(name, sizeof name, "superframe: 127.0.0.1 port %u: ", port);
    for (const char *at = strstr(adapter_said(&server), name); at != NULL; at = strstr(at, name)) {
        at += strlen(name);
        (void)snprintf(lines + strlen(lines), sizeof lines - strlen(lines), "%.*s\n",
                       (int)strcspn(at, "\n"), at);
    }
    char expected[1024] = "";
    for (unsigned i = 0; i < 3 && told[i] != NULL; i++) {
        (void)snprintf(expected + strlen(expected), sizeof expected - strlen(expected), "%s\n",
                       told[i]);
    }
    assert_string_equal(lines, expected);
}

static void who_comes_and_leaves_is_told(void **state) {
    static const char *const first[3] = {"came", "left: it has seen the list"};
    static const char *const second[3] = {"came", "has the device",
                                          "left: it closed the connection"};
    static const char *const third[3] = {"came", "has the device", "left: the server ends"};
    unsigned ports[3];
    (void)state;
    let_three_come(ports);
    assert_told(ports[0], first);
    assert_told(ports[1], second);
    assert_told(ports[2], third);
}

static void quiet_is_quiet(void **state) {
    const char *const words[] = {"--quiet", NULL};
    unsigned ports[3];
    (void)state;
    adapter_start(&server, words);
    let_three_come(ports);
    assert_string_equal(adapter_said(&server), "");
}

/* Starts a server whose log is a pipe. Returns the pipe's other end. */
static int start_with_pipe(void) {
    const char *const words[] = {NULL};
    adapter_name_files(&server);
    assert_int_equal(mkfifo(server.log, 0600), 0);
    int reader = open(server.log, O_RDONLY | O_NONBLOCK);
    assert_true(reader >= 0);
    adapter_start(&server, words);
    return reader;
}

static void a_log_that_nobody_reads_stops_nobody(void **state) {
    (void)state;
    int reader = start_with_pipe();
    for (unsigned i = 0; i < 1500; i++) { /* 150,000 bytes; a pipe holds 65,536 */
        assert_true(time_of_list() < 1000);
    }
    end_within_a_second();
    (void)close(reader);
}

static void a_log_whose_reader_has_gone_ends_nothing(void **state) {
    (void)state;
    (void)close(start_with_pipe());
    assert_true(time_of_list() < 1000);
    assert_true(time_of_list() < 1000);
    end_within_a_second();
}

static void addresses_that_others_can_reach_are_warned_of(void **state) {
    static const struct {
        const char *listen, *allow;
        bool is_warned, is_allow_told;
    } cases[] = {{"127.0.0.1:0", NULL, false, false},
                 {"127.8.0.9:0", NULL, false, false},
                 {"0.0.0.0:0", NULL, true, true},
                 {"0.0.0.0:0", "127.0.0.1", true, false}};
    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *const words[] = {"--listen", cases[i].listen,
                                     cases[i].allow == NULL ? NULL : "--allow", cases[i].allow,
                                     NULL};
        adapter_start(&server, words);
        end_within_a_second();
        const char *text = adapter_said(&server);
        assert_int_equal(strstr(text, "warning: other machines can reach 0.0.0.0") != NULL,
                         cases[i].is_warned);
        assert_int_equal(strstr(text, "ssh -N -L ") != NULL, cases[i].is_warned);
        assert_int_equal(strstr(text, "--allow ADDRESS") != NULL, cases[i].is_allow_told);
        adapter_stop(&server);
    }
}

int main(void) {
#define SERVED(test)  cmocka_unit_test_setup_teardown(test, start_server, stop_server)
#define STARTED(test) cmocka_unit_test_teardown(test, stop_server)
    const struct CMUnitTest tests[] = {
        SERVED(silent_connections_keep_nobody_out_and_end),
        SERVED(visitors_take_little_memory),
        SERVED(thousands_of_lists_for_a_crowd_at_once),
        SERVED(who_reads_a_byte_a_second_stops_nobody),
        SERVED(the_device_is_free_once_its_client_has_closed),
        SERVED(the_device_is_free_once_its_client_has_reset),
        SERVED(the_picture_is_written_once_a_second_and_at_the_end),
        STARTED(visitors_make_room_where_descriptors_are_short),
        STARTED(nobody_is_let_in_where_no_visitor_can_make_room),
        STARTED(only_allowed_addresses_are_served),
        SERVED(who_comes_and_leaves_is_told),
        STARTED(quiet_is_quiet),
        STARTED(a_log_that_nobody_reads_stops_nobody),
        STARTED(a_log_whose_reader_has_gone_ends_nothing),
        STARTED(addresses_that_others_can_reach_are_warned_of),
    };
    (void)alarm(150); /* a client that waits for ever is a failure */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
