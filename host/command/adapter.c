/* SPDX-License-Identifier: MIT */
/* superframe adapter: a virtual USB adapter with the emulated board behind it, served by USB/IP. */
#include <errno.h>
#include <netdb.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "adapter/server.h"
#include "adapter/usbip.h"
#include "base/interrupt.h"
#include "base/numbers.h"
#include "board/session.h"
#include "command/command.h"

enum { ALLOWED_MOST = 16, NAME_SIZE = 256, PORT_MOST = 65535 };

/* Holds the options that `adapter` alone takes. */
struct server_options {
    struct options common;
    const char *listen; /* ADDRESS or ADDRESS:PORT */
    const char *serial;
    struct address_range allowed[ALLOWED_MOST];
    size_t allowed_count;
    bool once; /* ends when its first client leaves */
};

/* One run of the command. */
struct work {
    const struct server_options *options;
    int listener; /* -1: none */
    struct session session;
    struct usb_device device;
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

/* Says on standard output where the server listens: for port 0 the system has chosen a port. Warns
 * of an address that other machines can reach. */
static void announce(const struct work *work) {
    struct sockaddr_storage place;
    struct address own;
    socklen_t size = sizeof place;
    char address[NAME_SIZE] = "?", port[NAME_SIZE] = "?";
    if (getsockname(work->listener, (struct sockaddr *)&place, &size) != 0) {
        return;
    }
    (void)getnameinfo((struct sockaddr *)&place, size, address, sizeof address, port, sizeof port,
                      NI_NUMERICHOST | NI_NUMERICSERV);
    (void)printf("listening on %s port %s; usbip --tcp-port %s attach -r %s -b " USBIP_BUS_ID "\n",
                 address, port, port, address);
    (void)fflush(stdout);
    if (!address_of(&place, &own) || !address_is_loopback(&own)) {
        complain("warning: other machines can reach %s, and USB/IP has no passwords and no "
                 "encryption; safer is 127.0.0.1 with ssh -N -L %s:127.0.0.1:%s HOST on the "
                 "client's machine%s",
                 address, port, port,
                 work->options->allowed_count == 0 ? "; --allow ADDRESS bounds who may come" : "");
    }
}

static int start_listening(struct work *work) {
    const char *listen_at = work->options->listen;
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
    work->listener = socket(found->ai_family, SOCK_STREAM, 0);
    bool is_listening =
        work->listener >= 0 &&
        setsockopt(work->listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
        bind(work->listener, found->ai_addr, found->ai_addrlen) == 0 &&
        listen(work->listener, SOMAXCONN) == 0;
    error = errno;
    freeaddrinfo(found);
    if (!is_listening) {
        return failure("%s port %s: can't listen: %s", address, port, strerror(error));
    }
    announce(work);
    return STATUS_DONE;
}

/* Writes the picture, if one is asked for, before any client can come, so that a bad name is known
 * at once. The picture is written again when clients have left the device, and at the end. */
static void write_screen(void *context) {
    struct work *work = context;
    const char *path = work->options->common.output;
    if (path == NULL) {
        return;
    }
    const struct shown_picture picture = session_picture(&work->session);
    if (!write_png_picture(path, picture.rgb, picture.width, picture.height)) {
        work->status = STATUS_FAILED;
    }
}

static int serve(struct work *work) {
    const struct server_options *options = work->options;
    const struct usbip_server server = {.listener = work->listener,
                                        .device = &work->device,
                                        .allowed = options->allowed,
                                        .allowed_count = options->allowed_count,
                                        .limits = usbip_default_limits(),
                                        .is_quiet = options->common.quiet,
                                        .is_once = options->once,
                                        .keep = write_screen,
                                        .context = work};
    if (!usbip_serve(&server, interrupt_noted())) {
        return failure("out of memory");
    }
    write_screen(work);
    return work->status;
}

static int run_adapter(const struct options *options) {
    struct work work = {.options = (const struct server_options *)options, .listener = -1};
    work.status = session_begin(&work.session, &options->board, NULL);
    if (work.status == STATUS_DONE) {
        usb_device_init(&work.device, session_bus(&work.session), options->board.base,
                        work.options->serial, true);
        interrupt_catch();
        write_screen(&work);
    }
    if (work.status == STATUS_DONE) {
        work.status = start_listening(&work);
    }
    if (work.status == STATUS_DONE) {
        work.status = serve(&work);
    }
    if (work.listener >= 0) {
        (void)close(work.listener);
    }
    session_free(&work.session);
    return work.status;
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

static enum value_verdict set_allow(struct options *options, const char *value) {
    struct server_options *own = (struct server_options *)options;
    return option_verdict(own->allowed_count < ALLOWED_MOST &&
                          address_range_read(value, &own->allowed[own->allowed_count++]));
}

static const struct option_group group_own = {
    "Adapter",
    OPTION_ENTRIES({.name = "listen",
                    .value = "ADDRESS[:PORT]",
                    TEXT_IN(struct server_options, listen),
                    .allowed = "an address in numbers, a port",
                    .preset = "127.0.0.1:3240",
                    .help = "where clients connect; USB/IP has no passwords, no encryption: "
                            "from afar, ssh -N -L 3240:127.0.0.1:3240 HOST first"},
                   {.name = "allow",
                    .value = "ADDRESS[/BITS]",
                    .type = OPTION_OWN,
                    .set = set_allow,
                    .allowed = "up to 16 times, as in 192.0.2.7, 10.1.0.0/16 or "
                               "2001:db8::/32",
                    .help = "who may come (anybody who reaches the address)"},
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
                    .help = "end when the first client leaves"},
                   {.name = "quiet",
                    FLAG_IN(struct server_options, common.quiet),
                    .help = "do not tell who comes and leaves"})};

const struct command command_adapter = {
    .name = "adapter",
    .operands = "",
    .summary = "Be a virtual USB adapter with the emulated board behind it.",
    .size = sizeof(struct server_options),
    .groups = OPTION_GROUPS(&group_picture, &group_own, &group_board),
    .examples = COMMAND_EXAMPLES("adapter -o screen.png", "adapter --listen 127.0.0.1:0 --once",
                                 "adapter --listen 0.0.0.0 --allow 192.0.2.0/24"),
    .printed = printed,
    .run = run_adapter};
