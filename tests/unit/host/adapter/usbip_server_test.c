/* SPDX-License-Identifier: MIT */
/* The USB/IP server among clients who are silent, slow or gone, with limits of fractions of a
 * second. Clients who vanish do so in a network namespace whose only interface goes down; where no
 * namespace can be had, that test is skipped. LOST_SECONDS=30 is the patience there that people
 * get. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>

#include "adapter_process.h"
#include "board_fixture.h"
#include "usbip_client.h"

#include "adapter/server.h"

enum { VISIT_MS = 800, BUSY_MS = 400, KEEP_MS = 500, SLACK_MS = 600 };

static volatile sig_atomic_t stop;
static struct usb_device device;
static struct adapter_process server;
static int kept; /* the read end of what keep() writes */

static void note_signal(int number) {
    stop = number;
}

/* Writes when it was called. */
static void keep(void *context) {
    const int64_t now = stopwatch_ms();
    assert_int_equal(write(*(const int *)context, &now, sizeof now), sizeof now);
}

/* Serves in a process of its own. */
static void start(bool is_once, unsigned lost_s) {
    struct sockaddr_in place = {.sin_family = AF_INET};
    socklen_t size = sizeof place;
    int ends[2], listener = socket(AF_INET, SOCK_STREAM, 0);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    assert_true(listener >= 0);
    assert_int_equal(bind(listener, (struct sockaddr *)&place, sizeof place), 0);
    assert_int_equal(listen(listener, 64), 0);
    assert_int_equal(getsockname(listener, (struct sockaddr *)&place, &size), 0);
    server.port = ntohs(place.sin_port);
    adapter_name_files(&server);
    assert_int_equal(pipe(ends), 0);
    server.pid = fork();
    assert_true(server.pid >= 0);
    if (server.pid == 0) {
        const struct usbip_limits limits = {VISIT_MS, BUSY_MS, lost_s, KEEP_MS};
        const struct usbip_server options = {.listener = listener,
                                             .device = &device,
                                             .limits = limits,
                                             .is_once = is_once,
                                             .keep = keep,
                                             .context = &ends[1]};
        (void)close(ends[0]);
        if (freopen(server.log, "w", stderr) == NULL) {
            _exit(126);
        }
        (void)setvbuf(stderr, NULL, _IONBF, 0); /* freopen() may give it a buffer */
        (void)signal(SIGTERM, note_signal);
        power_on(BOARD_1987);
        usb_device_init(&device, &board_bus.bus, 0x00D0, "SERVER", true);
        _exit(usbip_serve(&options, &stop) ? 0 : 1);
    }
    (void)close(listener);
    (void)close(ends[1]);
    kept = ends[0];
}

static int start_quickly(void **state) {
    (void)state;
    start(false, 1);
    return 0;
}

static int end(void **state) {
    (void)state;
    adapter_stop(&server);
    (void)close(kept);
    return 0;
}

/* ---- Before the device ----------------------------------------------------------------------- */

/* Also who says a byte now and then has no more time than the others. */
static void who_asks_for_nothing_is_sent_away_in_time(void **state) {
    static const uint8_t half[40] = {0x01, 0x11, 0x80, 0x03};
    (void)state;
    int silent = connect_to(server.port), slow = connect_to(server.port);
    assert_false(is_closed_within(silent, VISIT_MS / 2));
    for (unsigned i = 0; i < 8; i++) {
        (void)client_write(slow, half + i, 1);
        pause_ms(VISIT_MS / 4);
    }
    assert_true(is_closed_within(silent, 0));
    assert_true(is_closed_within(slow, 0));
    (void)close(silent);
    (void)close(slow);
}

/* More than there are places, so that the first have to make room. */
static void silent_connections_hold_no_place(void **state) {
    int silent[100];
    (void)state;
    for (unsigned i = 0; i < 100; i++) {
        silent[i] = connect_to(server.port);
    }
    int64_t began = stopwatch_ms();
    int asking = connect_to(server.port);
    assert_true(client_list(asking));
    assert_true(stopwatch_ms() - began < VISIT_MS);
    assert_true(is_closed_within(silent[0], 0));
    assert_false(is_closed_within(silent[99], 0));
    (void)close(asking);
    for (unsigned i = 0; i < 100; i++) {
        (void)close(silent[i]);
    }
}

/* A visitor's time does not run on for who has the device. */
static void the_device_may_be_kept_in_silence(void **state) {
    static struct usbip_client client;
    (void)state;
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    assert_false(is_closed_within(client.socket, 2 * VISIT_MS));
    (void)close(client.socket);
}

static void the_device_is_given_to_one_and_the_next_waits_for_a_while(void **state) {
    (void)state;
    int first = connect_to(server.port), second = connect_to(server.port);
    assert_int_equal(client_import(first), 0);
    int64_t began = stopwatch_ms();
    assert_int_equal(client_import(second), 2);
    assert_in_range(stopwatch_ms() - began, BUSY_MS - 1, VISIT_MS - 1);
    assert_true(is_closed_within(second, SLACK_MS));
    (void)close(first);
    (void)close(second);
}

/* The first client's end lies behind what it has sent; the server has to read that first. */
static void who_waits_gets_the_device_once_it_is_free(void **state) {
    uint8_t reply[8];
    (void)state;
    int first = connect_to(server.port), second = connect_to(server.port);
    assert_int_equal(client_import(first), 0);
    assert_true(client_ask(second));
    pause_ms(BUSY_MS / 3);
    (void)close(first);
    assert_true(client_read(second, reply, sizeof reply));
    assert_int_equal(client_get32(reply + 4), 0);
    (void)close(second);
}

/* The system tells the server again and again of a reset that the server does not take in. */
static void who_resets_while_it_waits_does_not_keep_the_server_busy(void **state) {
    (void)state;
    double used = seconds_of_children();
    int first = connect_to(server.port);
    assert_int_equal(client_import(first), 0);
    for (unsigned i = 0; i < 2; i++) {
        int second = connect_to(server.port);
        assert_true(client_ask(second));
        pause_ms(50);
        close_with_reset(second);
        pause_ms(BUSY_MS);
    }
    (void)adapter_end(&server);
    assert_true(seconds_of_children() - used < 0.3);
    (void)close(first);
}

/* ---- With the device ------------------------------------------------------------------------- */

static void who_reads_nothing_loses_the_device(void **state) {
    static struct usbip_client client;
    (void)state;
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    int64_t before = stopwatch_ms();
    client_stuff(&client);
    int64_t began = stopwatch_ms();
    int next;
    do {
        next = connect_to(server.port);
        int status = client_import(next);
        if (status == 0) {
            break;
        }
        assert_int_equal(status, 2);
        (void)close(next);
    } while (stopwatch_ms() - began < 5000);
    assert_true(stopwatch_ms() - before >= 1000 &&
                stopwatch_ms() - began <= 1000 + SLACK_MS + BUSY_MS);
    assert_non_null(
        strstr(adapter_said(&server), "left: it does not answer, or read what it is sent"));
    (void)close(next);
    (void)close(client.socket);
}

/* A byte now and then is enough to stay, and to be no one's burden. */
static void who_reads_slowly_stops_nobody(void **state) {
    static struct usbip_client client;
    uint8_t byte;
    (void)state;
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    client_stuff(&client);
    for (unsigned i = 0; i < 4; i++) {
        assert_int_equal(recv(client.socket, &byte, 1, 0), 1);
        int64_t began = stopwatch_ms();
        int asking = connect_to(server.port);
        assert_true(client_list(asking));
        assert_true(stopwatch_ms() - began < SLACK_MS);
        (void)close(asking);
        pause_ms(50);
    }
    assert_true(adapter_end(&server) < SLACK_MS);
    (void)close(client.socket);
}

/* ---- What is kept ---------------------------------------------------------------------------- */

static void what_clients_drew_is_kept_no_more_often_than_the_limit(void **state) {
    int64_t began = stopwatch_ms(), last = began - KEEP_MS, at;
    unsigned count = 0;
    (void)state;
    while (stopwatch_ms() - began < 3 * KEEP_MS) {
        int visitor = connect_to(server.port);
        assert_int_equal(client_import(visitor), 0);
        (void)close(visitor);
        pause_ms(5);
    }
    pause_ms(KEEP_MS + 300); /* the last of them is kept too, without another event */
    assert_int_equal(fcntl(kept, F_SETFL, O_NONBLOCK), 0);
    int64_t until = stopwatch_ms();
    while (read(kept, &at, sizeof at) == sizeof at) {
        assert_true(at - last >= KEEP_MS - 1);
        last = at;
        count++;
    }
    assert_in_range(count, 3, 4);
    assert_true(last > began + 2 * KEEP_MS && last <= until);
}

static void who_only_looked_leaves_nothing_to_keep(void **state) {
    int64_t at;
    (void)state;
    int asking = connect_to(server.port);
    assert_true(client_list(asking));
    (void)close(asking);
    pause_ms(KEEP_MS + 300);
    assert_int_equal(fcntl(kept, F_SETFL, O_NONBLOCK), 0);
    assert_true(read(kept, &at, sizeof at) < 0);
}

/* ---- Who vanishes ---------------------------------------------------------------------------- */

/* Puts the namespace's only interface up or down; down, nothing arrives any more, and nobody is
 * told. */
static bool set_loopback(bool is_up) {
    struct ifreq request;
    int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
    memset(&request, 0, sizeof request);
    strcpy(request.ifr_name, "lo");
    request.ifr_flags = is_up ? IFF_UP : 0;
    bool is_set = descriptor >= 0 && ioctl(descriptor, SIOCSIFFLAGS, &request) == 0;
    (void)close(descriptor);
    return is_set;
}

/* Lets a client with the device vanish, in a namespace of its own. is_answer_under_way: an answer
 * to the client is still on its way, or nothing is. Returns how many milliseconds the server took
 * to end with --once; -1: there is no namespace to be had. */
static int64_t vanish(bool is_answer_under_way, unsigned lost_s) {
    static const uint8_t get[8] = {0x80, 6, 0, 1, 0, 0, 18, 0};
    static struct usbip_client client;
    if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
        return -1;
    }
    assert_true(set_loopback(true));
    start(true, lost_s);
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    pause_ms(300); /* the last answer is acknowledged */
    if (is_answer_under_way) {
        assert_int_equal(kill(server.pid, SIGSTOP), 0);
        assert_true(client_submit(&client, 0, true, get, NULL, 18) != 0);
        pause_ms(50);
    }
    assert_true(set_loopback(false));
    int64_t began = stopwatch_ms();
    assert_int_equal(kill(server.pid, SIGCONT), 0);
    assert_int_equal(adapter_wait(&server), 0);
    int64_t took = stopwatch_ms() - began;
    assert_non_null(
        strstr(adapter_said(&server), "left: it does not answer, or read what it is sent"));
    adapter_stop(&server);
    return took;
}

/* Lets a client vanish in a process of its own, whose namespace ends with it. */
static void check_vanishing(bool is_answer_under_way) {
    unsigned lost_s = (unsigned)asked_number("LOST_SECONDS", 3);
    int ends[2];
    int64_t took = -2;
    assert_int_equal(pipe(ends), 0);
    pid_t world = fork();
    assert_true(world >= 0);
    if (world == 0) {
        took = vanish(is_answer_under_way, lost_s);
        _exit(write(ends[1], &took, sizeof took) == sizeof took ? 0 : 1);
    }
    (void)close(ends[1]);
    assert_int_equal(waitpid(world, NULL, 0), world);
    assert_int_equal(read(ends[0], &took, sizeof took), sizeof took);
    (void)close(ends[0]);
    if (took == -1) {
        print_message("skipped: no network namespace is to be had here\n");
        skip();
    }
    print_message("freed after %ld ms\n", (long)took);
    assert_in_range(took, 1000 * (lost_s - 1), 1000 * lost_s + 10000);
}

static void who_vanishes_in_silence_loses_the_device(void **state) {
    (void)state;
    check_vanishing(false);
}

static void who_vanishes_before_an_answer_loses_the_device(void **state) {
    (void)state;
    check_vanishing(true);
}

int main(void) {
#define SERVED(test) cmocka_unit_test_setup_teardown(test, start_quickly, end)
    const struct CMUnitTest tests[] = {
        SERVED(who_asks_for_nothing_is_sent_away_in_time),
        SERVED(silent_connections_hold_no_place),
        SERVED(the_device_may_be_kept_in_silence),
        SERVED(the_device_is_given_to_one_and_the_next_waits_for_a_while),
        SERVED(who_waits_gets_the_device_once_it_is_free),
        SERVED(who_resets_while_it_waits_does_not_keep_the_server_busy),
        SERVED(who_reads_nothing_loses_the_device),
        SERVED(who_reads_slowly_stops_nobody),
        SERVED(what_clients_drew_is_kept_no_more_often_than_the_limit),
        SERVED(who_only_looked_leaves_nothing_to_keep),
        cmocka_unit_test(who_vanishes_in_silence_loses_the_device),
        cmocka_unit_test(who_vanishes_before_an_answer_loses_the_device),
    };
    (void)alarm(150); /* a test that waits for ever is a failure */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
