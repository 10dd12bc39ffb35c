/* SPDX-License-Identifier: MIT */
/* The virtual adapter among strangers at random: whole and broken requests, transfers, silence,
 * ends and resets in any order, over TCP. Meanwhile every list, and every answer to who asks for
 * the device, has to come within a second, and the server must not grow. STRANGERS_SECONDS says for
 * how long (6), STRANGERS_SEED where the random numbers begin (0). */
#include <errno.h>
#include <fcntl.h>

#include "adapter_process.h"
#include "usb_fixture.h"
#include "usbip_client.h"

enum { STRANGERS = 24, PROBE_MS = 50, ANSWER_MS = 1000, GROWN_MOST_KB = 1024, PIECE_MOST = 20000 };

static struct adapter_process server;
static uint64_t state_of_random;

/* What a stranger has been up to. */
struct stranger {
    int socket; /* -1: not there */
    bool is_attached;
    uint32_t pace; /* the stranger does something in one of so many turns */
};

static struct {
    unsigned long connections, requests, attached, busy, ended; /* of strangers */
    unsigned long lists, given, refused;                        /* of who behaves */
    int64_t slowest_ms;
} counts;

static uint32_t draw_number(uint32_t below) {
    return next_random(&state_of_random) % below;
}

/* Starts a server that frees at once: what the sanitizer would keep is not the server's. */
static int start_server(void **state) {
    const char *const words[] = {"-o", server.picture, "--quiet", NULL};
    const char *before = getenv("ASAN_OPTIONS");
    char options[512];
    (void)state;
    (void)snprintf(options, sizeof options,
                   "%s:quarantine_size_mb=1:thread_local_quarantine_size_kb=64",
                   before != NULL ? before : "");
    assert_int_equal(setenv("ASAN_OPTIONS", options, 1), 0);
    adapter_start(&server, words);
    return 0;
}

static int stop_server(void **state) {
    (void)state;
    adapter_stop(&server);
    return 0;
}

/* ---- What strangers say ---------------------------------------------------------------------- */

static size_t make_noise(uint8_t *bytes) {
    size_t count = 1 + draw_number(draw_number(8) == 0 ? PIECE_MOST : 100);
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (uint8_t)draw_number(256);
    }
    return count;
}

static size_t make_request(uint8_t bytes[40]) {
    bool is_list = draw_number(2) == 0;
    memset(bytes, 0, 40);
    client_put32(bytes, is_list ? 0x01118005 : 0x01118003);
    memcpy(bytes + 8, "1-1", 3);
    return is_list ? 8 : 40;
}

/* Makes a command that is allowed, or nearly. */
static size_t make_command(uint8_t *bytes) {
    static const uint16_t lengths[] = {0, 1, 8, 18, 63, 64, 255, 512, 4096, 16384};
    static const uint8_t requests[] = {0, 1, 3, 6, 8, 9, 10, 11};
    bool is_in = draw_number(2) == 0;
    uint32_t length = lengths[draw_number(10)];
    memset(bytes, 0, CLIENT_HEADER);
    client_put32(bytes, draw_number(6) == 0 ? 2 : 1);
    client_put32(bytes + 4, draw_number(1000));
    client_put32(bytes + 12, is_in);
    client_put32(bytes + 16, draw_number(4));
    client_put32(bytes + 20, draw_number(1000));
    client_put32(bytes + 24, length);
    bytes[40] = (uint8_t)((is_in ? 0x80 : 0) | draw_number(3));
    bytes[41] = requests[draw_number(8)];
    bytes[42] = (uint8_t)draw_number(3);
    bytes[43] = (uint8_t)draw_number(4);
    bytes[46] = (uint8_t)length;
    bytes[47] = (uint8_t)(length >> 8);
    if (client_get32(bytes) == 2 || is_in) {
        return CLIENT_HEADER;
    }
    for (uint32_t i = 0; i < length; i++) {
        bytes[CLIENT_HEADER + i] = (uint8_t)draw_number(256);
    }
    return CLIENT_HEADER + length;
}

/* Sends a piece, now and then broken or cut; what the socket does not take is lost. */
static void say(const struct stranger *stranger) {
    static uint8_t bytes[PIECE_MOST + CLIENT_HEADER];
    size_t count = draw_number(12) == 0    ? make_noise(bytes)
                   : stranger->is_attached ? make_command(bytes)
                                           : make_request(bytes);
    if (draw_number(12) == 0) {
        bytes[draw_number((uint32_t)count)] ^= (uint8_t)(1 << draw_number(8));
    }
    count = draw_number(12) == 0 ? 1 + draw_number((uint32_t)count) : count;
    (void)send(stranger->socket, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    counts.requests++;
}

/* ---- What strangers do ----------------------------------------------------------------------- */

static void come(struct stranger *stranger) {
    static const uint32_t paces[] = {1, 1, 30, 1000};
    stranger->socket = connect_to(server.port);
    stranger->is_attached = false;
    stranger->pace = draw_number(40) == 0 ? 100000 : paces[draw_number(4)];
    assert_int_equal(fcntl(stranger->socket, F_SETFL, O_NONBLOCK), 0);
    counts.connections++;
}

static void go(struct stranger *stranger) {
    if (draw_number(2) == 0) {
        close_with_reset(stranger->socket);
    } else {
        (void)close(stranger->socket);
    }
    stranger->socket = -1;
}

static void listen_to_server(struct stranger *stranger) {
    static uint8_t bytes[65536];
    ssize_t count = recv(stranger->socket, bytes, 1 + draw_number(sizeof bytes - 1), 0);
    if (count == 0 || (count < 0 && errno != EAGAIN)) {
        counts.ended++;
        (void)close(stranger->socket);
        stranger->socket = -1;
    } else if (count >= 8 && client_get32(bytes) == 0x01110003) {
        stranger->is_attached = client_get32(bytes + 4) == 0;
        counts.attached += stranger->is_attached;
        counts.busy += client_get32(bytes + 4) == 2;
    }
}

static void act(struct stranger *stranger) {
    if (stranger->socket < 0) {
        if (draw_number(4) == 0) {
            come(stranger);
        }
        return;
    }
    uint32_t what = draw_number(100 * stranger->pace);
    if (what < 40) {
        say(stranger);
    } else if (what < 55) {
        listen_to_server(stranger);
    } else if (what < 57) {
        (void)shutdown(stranger->socket, SHUT_WR);
    } else if (what < 60) {
        go(stranger);
    }
}

/* ---- Who behaves ----------------------------------------------------------------------------- */

/* Asks for the list, and sometimes for the device, which another client may have. */
static void ask(void) {
    int64_t began = stopwatch_ms();
    int asking = connect_to(server.port);
    if (draw_number(20) == 0) {
        int status = client_import(asking);
        assert_true(status == 0 || status == 2);
        counts.given += status == 0;
        counts.refused += status == 2;
    } else {
        assert_true(client_list(asking));
        counts.lists++;
    }
    int64_t took = stopwatch_ms() - began;
    (void)close(asking);
    counts.slowest_ms = took > counts.slowest_ms ? took : counts.slowest_ms;
    assert_true(took < ANSWER_MS);
}

static void the_server_lives_among_strangers(void **state) {
    static struct stranger strangers[STRANGERS];
    const int64_t ms = 1000 * (int64_t)asked_number("STRANGERS_SECONDS", 6);
    long before = 0;
    (void)state;
    state_of_random = 0x9E3779B97F4A7C15U * (asked_number("STRANGERS_SEED", 0) + 1);
    for (unsigned i = 0; i < STRANGERS; i++) {
        strangers[i].socket = -1;
    }
    int64_t began = stopwatch_ms(), asked = began;
    while (stopwatch_ms() - began < ms) {
        for (unsigned i = 0; i < 50; i++) {
            act(&strangers[draw_number(STRANGERS)]);
        }
        if (stopwatch_ms() - asked >= PROBE_MS) {
            ask();
            asked = stopwatch_ms();
        }
        if (before == 0 && stopwatch_ms() - began > ms / 5) {
            before = adapter_memory_kb(&server); /* the first pictures have been written by then */
        }
    }
    long grown = adapter_memory_kb(&server) - before;
    int64_t ended = adapter_end(&server);
    for (unsigned i = 0; i < STRANGERS; i++) {
        (void)close(strangers[i].socket);
    }
    print_message(
        "strangers: %lu connections, %lu attached, %lu busy, %lu ended by the server, %lu "
        "pieces sent\n",
        counts.connections, counts.attached, counts.busy, counts.ended, counts.requests);
    print_message("others: %lu lists, %lu attached, %lu busy, the slowest in %ld ms\n",
                  counts.lists, counts.given, counts.refused, (long)counts.slowest_ms);
    print_message("grown by %ld KB; ended in %ld ms\n", grown, (long)ended);
    assert_true(counts.attached > 0 && counts.ended > 0 && counts.given + counts.refused > 0);
    assert_true(grown <= GROWN_MOST_KB);
    assert_true(ended < ANSWER_MS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_server_lives_among_strangers, start_server,
                                        stop_server),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
