/* SPDX-License-Identifier: MIT */
/* superframe adapter: a virtual USB adapter with the emulated board behind it, served by USB/IP. */
#include <errno.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "adapter/usbip.h"
#include "base/interrupt.h"
#include "base/numbers.h"
#include "board/session.h"
#include "command/command.h"

enum { CLIENTS_MOST = 4, SEND_SECONDS = 10, NAME_SIZE = 256, POLL_MS = 200, PORT_MOST = 65535 };

/* Holds the options that `adapter` alone takes. */
struct server_options {
    struct options common;
    const char *listen; /* ADDRESS or ADDRESS:PORT */
    const char *serial;
    bool once; /* ends when its first client leaves */
};

/* A connection. */
struct client {
    int socket; /* -1: none */
    struct usbip_client usbip;
};

/* One run of the command. */
struct server {
    const struct server_options *options;
    int listener;
    struct session session;
    struct usb_device device;
    struct client clients[CLIENTS_MOST];
    bool is_over; /* with --once: the client that had the device has left */
    int status;
};

/* Splits "ADDRESS", "ADDRESS:PORT" or "[ADDRESS]:PORT". */
static bool split(const char *listen, char *address, char *port) {
    const char *begin = listen[0] == '[' ? listen + 1 : listen;
    const char *stop = listen[0] == '[' ? strchr(begin, ']') : strchr(begin, ':');
    if (listen[0] != '[' && stop != NULL && strchr(stop + 1, ':') != NULL) {
        stop = NULL; /* an IPv6 address without a port */
    }
    const char *colon = stop != NULL && *stop == ']' ? stop + 1 : stop;
    size_t length = stop != NULL ? (size_t)(stop - begin) : strlen(begin);
    if (length >= NAME_SIZE || (listen[0] == '[' && stop == NULL)) {
        return false;
    }
    memcpy(address, begin, length);
    address[length] = '\0';
    if (colon != NULL && *colon == ':') {
        return snprintf(port, NAME_SIZE, "%s", colon + 1) < NAME_SIZE;
    }
    return snprintf(port, NAME_SIZE, "%d", (int)USBIP_PORT) < NAME_SIZE;
}

/* Says on standard output where the server listens: for port 0 the system has chosen a port. */
static void announce(const struct server *server) {
    struct sockaddr_storage place;
    socklen_t size = sizeof place;
    char address[NAME_SIZE] = "?", port[NAME_SIZE] = "?";
    if (getsockname(server->listener, (struct sockaddr *)&place, &size) == 0) {
        (void)getnameinfo((struct sockaddr *)&place, size, address, sizeof address, port,
                          sizeof port, NI_NUMERICHOST | NI_NUMERICSERV);
    }
    (void)printf("listening on %s port %s; usbip --tcp-port %s attach -r %s -b " USBIP_BUS_ID "\n",
                 address, port, port, address);
    (void)fflush(stdout);
}

static int start_listening(struct server *server) {
    const char *listen_at = server->options->listen;
    char address[NAME_SIZE], port[NAME_SIZE];
    uint64_t number;
    struct addrinfo wanted, *found = NULL;
    if (!split(listen_at, address, port) || !value_whole(port, 0, PORT_MOST, &number)) {
        return bad_input("--listen %.100s: allowed is ADDRESS, ADDRESS:PORT or [ADDRESS]:PORT, "
                         "with a port 0..65535",
                         listen_at);
    }
    memset(&wanted, 0, sizeof wanted);
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE | AI_NUMERICHOST | AI_NUMERICSERV;
    int error = getaddrinfo(address, port, &wanted, &found);
    if (error != 0) {
        return bad_input("--listen %.100s: %s; allowed are an address in numbers and a port",
                         listen_at, gai_strerror(error));
    }
    int yes = 1;
    server->listener = socket(found->ai_family, SOCK_STREAM, 0);
    bool is_listening =
        server->listener >= 0 &&
        setsockopt(server->listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
        bind(server->listener, found->ai_addr, found->ai_addrlen) == 0 &&
        listen(server->listener, CLIENTS_MOST) == 0;
    error = errno;
    freeaddrinfo(found);
    if (!is_listening) {
        return failure("%s port %s: can't listen: %s", address, port, strerror(error));
    }
    announce(server);
    return STATUS_DONE;
}

static void send_to_client(void *context, const uint8_t *bytes, size_t count) {
    struct client *client = context;
    while (count > 0 && client->socket >= 0) {
        ssize_t sent = send(client->socket, bytes, count, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            client->usbip.is_over = true; /* the client is gone, or does not read */
            return;
        }
        bytes += sent;
        count -= (size_t)sent;
    }
}

/* Writes the picture, if one is asked for, before any client can come, so that a bad name is known
 * at once. The picture is written again whenever a client has left the device, and at the end. */
static void write_screen(struct server *server) {
    const char *path = server->options->common.output;
    if (path == NULL) {
        return;
    }
    const struct shown_picture picture = session_picture(&server->session);
    if (!write_png_picture(path, picture.rgb, picture.width, picture.height)) {
        server->status = STATUS_FAILED;
    }
}

static void part(struct server *server, struct client *client) {
    bool had_device = client->usbip.is_attached;
    if (client->usbip.reason[0] != '\0' && had_device) {
        complain("a client was sent away: %s", client->usbip.reason);
    }
    usbip_client_leave(&client->usbip);
    (void)close(client->socket);
    client->socket = -1;
    if (had_device) {
        write_screen(server);
        server->is_over = server->options->once;
    }
}

static bool is_attached(const struct server *server) {
    for (unsigned i = 0; i < CLIENTS_MOST; i++) {
        if (server->clients[i].socket >= 0 && server->clients[i].usbip.is_attached) {
            return true;
        }
    }
    return false;
}

static void welcome(struct server *server) {
    const struct timeval patience = {SEND_SECONDS, 0};
    int yes = 1, socket = accept(server->listener, NULL, NULL);
    if (socket < 0) {
        return;
    }
    (void)setsockopt(socket, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    (void)setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    for (unsigned i = 0; i < CLIENTS_MOST; i++) {
        struct client *client = &server->clients[i];
        if (client->socket < 0) {
            client->socket = socket;
            usbip_client_init(&client->usbip, &server->device, false, send_to_client, client);
            return;
        }
    }
    (void)close(socket);
}

static void listen_to(struct server *server, struct client *client) {
    uint8_t bytes[16384];
    ssize_t count = recv(client->socket, bytes, sizeof bytes, 0);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
        return;
    }
    if (count > 0) {
        client->usbip.is_busy = !client->usbip.is_attached && is_attached(server);
        usbip_client_take(&client->usbip, bytes, (size_t)count);
    }
    if (count <= 0 || client->usbip.is_over) {
        part(server, client);
    }
}

static void serve(struct server *server) {
    while (!server->is_over && *interrupt_noted() == 0) {
        struct pollfd watched[CLIENTS_MOST + 1];
        watched[CLIENTS_MOST].fd = server->listener;
        watched[CLIENTS_MOST].events = POLLIN;
        for (unsigned i = 0; i < CLIENTS_MOST; i++) {
            watched[i].fd = server->clients[i].socket; /* poll() passes over -1 */
            watched[i].events = POLLIN;
            watched[i].revents = 0;
        }
        if (poll(watched, CLIENTS_MOST + 1, POLL_MS) <= 0) {
            continue;
        }
        for (unsigned i = 0; i < CLIENTS_MOST; i++) {
            if (watched[i].revents != 0 && server->clients[i].socket >= 0) {
                listen_to(server, &server->clients[i]);
            }
        }
        if ((watched[CLIENTS_MOST].revents & POLLIN) != 0) {
            welcome(server);
        }
    }
}

static void work(struct server *server) {
    interrupt_catch();
    write_screen(server);
    if (server->status == STATUS_DONE) {
        server->status = start_listening(server);
    }
    if (server->status != STATUS_DONE) {
        return;
    }
    serve(server);
    for (unsigned i = 0; i < CLIENTS_MOST; i++) {
        if (server->clients[i].socket >= 0) {
            part(server, &server->clients[i]);
        }
    }
    if (!server->is_over) {
        write_screen(server);
    }
}

static int run_adapter(const struct options *options) {
    struct server *server = calloc(1, sizeof *server);
    if (server == NULL) {
        return failure("out of memory");
    }
    server->options = (const struct server_options *)options;
    server->listener = -1;
    for (unsigned i = 0; i < CLIENTS_MOST; i++) {
        server->clients[i].socket = -1;
    }
    server->status = session_begin(&server->session, &options->board, NULL);
    if (server->status == STATUS_DONE) {
        usb_device_init(&server->device, session_bus(&server->session), options->board.base,
                        server->options->serial, true);
        work(server);
    }
    if (server->listener >= 0) {
        (void)close(server->listener);
    }
    int status = server->status;
    session_free(&server->session);
    free(server);
    return status;
}

static const char *printed(const struct options *options) {
    (void)options;
    return "where the adapter listens";
}

static enum value_verdict set_serial(struct options *options, const char *value) {
    size_t length =
        strspn(value, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-");
    ((struct server_options *)options)->serial = value;
    return option_verdict(length >= 1 && length <= USB_SERIAL_MOST && value[length] == '\0');
}

static const struct option_group group_own = {
    "Adapter", OPTION_ENTRIES({.name = "listen",
                               .value = "ADDRESS[:PORT]",
                               TEXT_IN(struct server_options, listen),
                               .allowed = "an address in numbers, a port",
                               .preset = "127.0.0.1:3240",
                               .help = "where clients may come from USB/IP"},
                              {.name = "serial",
                               .value = "SERIAL",
                               .type = OPTION_OWN,
                               OPTION_MEMBER_OF(struct server_options, serial),
                               .set = set_serial,
                               .allowed = "1 to 31 letters, digits and dashes",
                               .preset = "VIRTUAL",
                               .help = "the virtual adapter's serial number"},
                              {.name = "once",
                               FLAG_IN(struct server_options, once),
                               .help = "end when the first client leaves"})};

const struct command command_adapter = {
    .name = "adapter",
    .operands = "",
    .summary = "Be a virtual USB adapter with the emulated board behind it.",
    .size = sizeof(struct server_options),
    .groups = OPTION_GROUPS(&group_picture, &group_own, &group_board),
    .examples = COMMAND_EXAMPLES("adapter -o screen.png", "adapter --listen 127.0.0.1:0 --once"),
    .printed = printed,
    .run = run_adapter};
