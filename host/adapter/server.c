/* SPDX-License-Identifier: MIT */
/* The connections of a USB/IP server: who is listened to, who is sent away, and when. */
#include "adapter/server.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "adapter/usbip.h"
#include "base/complain.h"
#include "base/stopwatch.h"

enum {
    VISITORS_MOST = 32,
    PLACES = 1 + VISITORS_MOST,
    POLL_MS = 100,   /* deadlines, and a signal that comes just before poll(), are seen that late */
    SHORT_MS = 1000, /* without accept(), where the system is short of something */
    KEEPALIVES = 4,
    NAME_SIZE = 80,
    READ_MOST = 16384
};

static const int64_t never = INT64_MAX;

/* A connection. A queue of answers is bounded by struct usbip_client, and all of them by PLACES. */
struct connection {
    int socket;       /* -1: a free place */
    uint64_t number;  /* in the order of coming */
    int64_t deadline; /* by the server's clock: then the client is sent away */
    char name[NAME_SIZE];
    struct usbip_client client;
};

/* One run of a server. */
struct run {
    const struct usbip_server *server;
    struct connection places[PLACES]; /* the first: of the client that has the device */
    int64_t now;                      /* by stopwatch_ms() */
    int64_t accept_at, keep_at;       /* not before */
    uint64_t came;                    /* how many have come */
    bool is_to_keep;
    bool is_over;
    int spare; /* a descriptor that keep() finds free; -1: none was left */
};

struct usbip_limits usbip_default_limits(void) {
    const struct usbip_limits limits = {5000, 500, 30, 1000};
    return limits;
}

/* Tells of a client. A reader that has stopped reading, or has gone, must not stop the server. */
static void tell(const struct run *run, const char *name, const char *what, const char *why) {
    struct pollfd watched = {STDERR_FILENO, POLLOUT, 0};
    if (!run->server->is_quiet && poll(&watched, 1, 0) == 1 && watched.revents == POLLOUT) {
        complain("%s: %s%s", name, what, why);
    }
}

/* ---- Coming and going ------------------------------------------------------------------------ */

static void part(struct run *run, struct connection *connection) {
    tell(run, connection->name, "left: ", connection->client.reason);
    if (connection->client.is_attached) {
        usbip_client_leave(&connection->client);
        run->is_to_keep = true;
        run->is_over = run->server->is_once;
    }
    (void)close(connection->socket);
    connection->socket = -1;
}

/* Sends away the visitor who came first. Returns the place, or NULL where there is no visitor. */
static struct connection *send_away_first(struct run *run) {
    struct connection *first = NULL;
    for (unsigned i = 1; i < PLACES; i++) {
        struct connection *visitor = &run->places[i];
        if (visitor->socket >= 0 && (first == NULL || visitor->number < first->number)) {
            first = visitor;
        }
    }
    if (first != NULL) {
        usbip_client_end(&first->client, "it had to make room for another client");
        part(run, first);
    }
    return first;
}

static struct connection *find_place(struct run *run) {
    for (unsigned i = 1; i < PLACES; i++) {
        if (run->places[i].socket < 0) {
            return &run->places[i];
        }
    }
    return send_away_first(run);
}

static bool is_allowed(const struct usbip_server *server, const struct sockaddr_storage *from) {
    struct address address;
    bool is_known = address_of(from, &address), is_found = server->allowed_count == 0;
    for (size_t i = 0; i < server->allowed_count && is_known && !is_found; i++) {
        is_found = address_range_holds(&server->allowed[i], &address);
    }
    return is_found;
}

static void set_option(int socket, int level, int option, unsigned value) {
    int number = (int)value;
    (void)setsockopt(socket, level, option, &number, sizeof number);
}

/* Lets the system end a connection whose other end does not answer. Keepalives ask while nothing is
 * under way; the time-out counts while something is, also where the other end reads nothing. */
static void prepare(int socket, unsigned lost_s) {
    unsigned between = lost_s / (KEEPALIVES + 2);
    between = between > 0 ? between : 1;
    set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
    set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, 2 * between);
    set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, between);
    set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, KEEPALIVES);
    set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, lost_s * 1000);
}

static void name_peer(const struct sockaddr_storage *from, socklen_t size, char name[NAME_SIZE]) {
    char address[64] = "?", port[8] = "?"; /* an interface may stand behind the address */
    (void)getnameinfo((const struct sockaddr *)from, size, address, sizeof address, port,
                      sizeof port, NI_NUMERICHOST | NI_NUMERICSERV);
    (void)snprintf(name, NAME_SIZE, "%s port %s", address, port);
}

/* Takes in one client that has connected: all others get their turn before the next. Where
 * descriptors are short, a visitor makes room, or accept() rests for a while. */
static void welcome(struct run *run) {
    struct sockaddr_storage from;
    socklen_t size = sizeof from;
    char name[NAME_SIZE];
    int socket = accept(run->server->listener, (struct sockaddr *)&from, &size);
    if (socket < 0) {
        bool is_of_one_client = errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
        if (!is_of_one_client && send_away_first(run) == NULL) {
            run->accept_at = run->now + SHORT_MS;
        }
        return;
    }
    name_peer(&from, size, name);
    if (!is_allowed(run->server, &from)) {
        tell(run, name, "refused: ", "--allow does not name its address");
        (void)close(socket);
        return;
    }
    prepare(socket, run->server->limits.lost_s);
    struct connection *connection = find_place(run);
    connection->socket = socket;
    connection->number = ++run->came;
    connection->deadline = run->now + run->server->limits.visit_ms;
    (void)snprintf(connection->name, sizeof connection->name, "%s", name);
    usbip_client_init(&connection->client, run->server->device);
    tell(run, name, "came", "");
}

/* ---- One connection -------------------------------------------------------------------------- */

/* Ends a visit whose answers can't be sent any more. */
static void break_off(struct connection *connection, const char *reason) {
    usbip_client_end(&connection->client, reason);
    connection->client.answer_count = 0;
}

/* Returns the error that the system has noted. */
static int error_of(int socket) {
    int error = 0;
    socklen_t size = sizeof error;
    (void)getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
    return error;
}

static const char *reason_of(int error) {
    return error == ETIMEDOUT ? "it does not answer, or read what it is sent"
                              : "the connection broke";
}

static void receive(const struct run *run, struct connection *connection) {
    uint8_t bytes[READ_MOST];
    struct usbip_client *client = &connection->client;
    size_t room = usbip_client_room(client);
    ssize_t count =
        recv(connection->socket, bytes, room < sizeof bytes ? room : sizeof bytes, MSG_DONTWAIT);
    if (count > 0) {
        (void)usbip_client_take(client, bytes, (size_t)count);
        int64_t until = run->now + run->server->limits.busy_ms;
        if (client->wants_device && connection->deadline > until) {
            connection->deadline = until;
        }
    } else if (count == 0) {
        break_off(connection, "it closed the connection");
    } else if (errno != EAGAIN && errno != EINTR) {
        break_off(connection, reason_of(errno));
    }
}

/* Gives a client the device if the client wants it and it is free. Returns the client's place. */
static struct connection *attach(struct run *run, struct connection *connection) {
    struct connection *first = &run->places[0];
    if (!connection->client.wants_device || first->socket >= 0) {
        return connection;
    }
    *first = *connection;
    connection->socket = -1;
    first->deadline = never;
    usbip_client_give(&first->client, true);
    tell(run, first->name, "has the device", "");
    return first;
}

/* Sends what the system takes at once. */
static void send_answers(struct connection *connection) {
    struct usbip_client *client = &connection->client;
    ssize_t sent = 1;
    while (client->answer_count > 0 && sent > 0) {
        sent = send(connection->socket, client->answers, client->answer_count,
                    MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) {
            usbip_client_sent(client, (size_t)sent);
        } else if (errno != EAGAIN && errno != EINTR) {
            break_off(connection, reason_of(errno));
        }
    }
}

/* Does for a connection all that can be done now. */
static void attend(struct run *run, struct connection *connection, short seen) {
    if ((seen & POLLIN) != 0) {
        receive(run, connection);
    } else if ((seen & (POLLERR | POLLHUP)) != 0) {
        break_off(connection, reason_of(error_of(connection->socket)));
    }
    connection = attach(run, connection);
    struct usbip_client *client = &connection->client;
    bool is_late = run->now >= connection->deadline;
    if (is_late && client->wants_device) {
        usbip_client_give(client, false);
    } else if (is_late) {
        usbip_client_end(client, "it took too long to ask for something");
    }
    send_answers(connection);
    if (client->is_over && (client->answer_count == 0 || is_late)) {
        part(run, connection);
    }
}

/* ---- All of them ----------------------------------------------------------------------------- */

/* Waits until something can be done, or the time has to be looked at. Fills what is watched: first
 * the connections, whose places are filled too, then the listener. Returns how many connections
 * there are: poll() is given no more descriptors than are open, as it asks. */
static unsigned watch(const struct run *run, struct pollfd watched[PLACES + 1],
                      unsigned places[PLACES]) {
    unsigned count = 0;
    for (unsigned i = 0; i < PLACES; i++) {
        const struct connection *connection = &run->places[i];
        if (connection->socket >= 0) {
            bool is_read = usbip_client_room(&connection->client) > 0;
            bool is_written = connection->client.answer_count > 0;
            short events = (short)((is_read ? POLLIN : 0) | (is_written ? POLLOUT : 0));
            watched[count] = (struct pollfd){.fd = connection->socket, .events = events};
            places[count++] = i;
        }
    }
    watched[count] = (struct pollfd){.fd = run->server->listener,
                                     .events = run->now >= run->accept_at ? POLLIN : 0};
    (void)poll(watched, count + 1, POLL_MS); /* where it fails, nothing was seen */
    return count;
}

static void keep_what_was_drawn(struct run *run) {
    if (run->is_to_keep && run->now >= run->keep_at) {
        (void)close(run->spare);
        run->server->keep(run->server->context);
        run->spare = dup(run->server->listener);
        run->is_to_keep = false;
        run->keep_at = run->now + run->server->limits.keep_ms;
    }
}

static void serve(struct run *run, const volatile sig_atomic_t *stop) {
    struct pollfd watched[PLACES + 1];
    unsigned places[PLACES];
    run->now = stopwatch_ms();
    run->keep_at = run->now + run->server->limits.keep_ms;
    while (!run->is_over && *stop == 0) {
        keep_what_was_drawn(run);
        unsigned count = watch(run, watched, places);
        run->now = stopwatch_ms();
        for (unsigned i = 0; i < count; i++) {
            attend(run, &run->places[places[i]], watched[i].revents);
        }
        if ((watched[count].revents & POLLIN) != 0) {
            welcome(run);
        }
    }
}

bool usbip_serve(const struct usbip_server *server, const volatile sig_atomic_t *stop) {
    struct run *run = calloc(1, sizeof *run);
    if (run == NULL) {
        return false;
    }
    run->server = server;
    run->spare = dup(server->listener);
    for (unsigned i = 0; i < PLACES; i++) {
        run->places[i].socket = -1;
    }
    (void)fcntl(server->listener, F_SETFL, O_NONBLOCK);
    serve(run, stop);
    for (unsigned i = 0; i < PLACES; i++) {
        if (run->places[i].socket >= 0) {
            usbip_client_end(&run->places[i].client, "the server ends");
            part(run, &run->places[i]);
        }
    }
    (void)close(run->spare);
    free(run);
    return true;
}
