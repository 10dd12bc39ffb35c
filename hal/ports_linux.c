/* SPDX-License-Identifier: MIT */
/* The machine's own I/O ports on Linux: the one file that knows outb() and its order of arguments.
 */

/* ioperm(), setgroups() and syscall() are not in POSIX. */
#undef _DEFAULT_SOURCE
#define _DEFAULT_SOURCE 1 // NOLINT(bugprone-reserved-identifier): glibc's own switch

#include "ports_linux.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { OWNER_LINE = 256 };

/* ---- The bus -------------------------------------------------------------------------------- */

/* Checks that the ports of an access are open, and fails the bus if not. A port that was not opened
 * would end the program with SIGSEGV. */
static bool is_open(struct ports_linux *ports, uint16_t port, unsigned width) {
    unsigned offset = (uint16_t)(port - ports->base);
    if (offset + width > BOARD_PORTS) {
        bus_fail(&ports->bus, BUS_REFUSED);
        return false;
    }
    return true;
}

static void ports_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct ports_linux *ports = (struct ports_linux *)bus;
    if (!is_open(ports, port, width)) {
        return;
    }
    if (width == BUS_BYTE) {
        ports->system->write_byte((unsigned char)value, port); /* the swap: value, port */
    } else {
        ports->system->write_word(value, port);
    }
}

static uint16_t ports_read(struct bus *bus, uint16_t port, unsigned width) {
    struct ports_linux *ports = (struct ports_linux *)bus;
    if (!is_open(ports, port, width)) {
        return 0xFFFF;
    }
    return width == BUS_BYTE ? ports->system->read_byte(port) : ports->system->read_word(port);
}

static const struct bus_operations ports_operations = {ports_write, ports_read, NULL};

/* ---- Who owns the ports --------------------------------------------------------------------- */

/* Tells whether a line, such as "  00c0-00df : dma2", names an owner of the ports. A bridge is
 * none: its window holds the ports of whatever is behind the bridge. */
static bool names_an_owner(const char *line, uint16_t base, bool *is_hidden, const char **owner) {
    unsigned long first, last;
    char *end;
    first = strtoul(line, &end, 16);
    if (end == line || *end != '-') {
        return false;
    }
    last = strtoul(end + 1, &end, 16);
    *owner = strstr(end, " : ");
    if (*owner == NULL) {
        return false;
    }
    *owner += sizeof " : " - 1;
    /* To those who may not know the addresses, all are shown as 0. */
    *is_hidden = *is_hidden || (first == 0 && last == 0);
    return last >= base && first < (unsigned long)base + BOARD_PORTS &&
           strncmp(*owner, "PCI Bus", sizeof "PCI Bus" - 1) != 0;
}

static void cant_find_out(const char *owners, int reason, char *message) {
    (void)snprintf(message, PORTS_LINUX_MESSAGE_SIZE,
                   "who owns the ports can't be found out: %s: %s", owners, strerror(reason));
}

/* Tells whether the ports are known to be nobody's. If not, message says why. */
static bool is_free(const char *owners, uint16_t base, char *message) {
    char line[OWNER_LINE];
    const char *owner = NULL;
    bool is_owned = false, is_hidden = false;
    FILE *file = fopen(owners, "r");
    if (file == NULL) {
        cant_find_out(owners, errno, message);
        return false;
    }
    while (!is_owned && fgets(line, sizeof line, file) != NULL) {
        is_owned = names_an_owner(line, base, &is_hidden, &owner);
    }
    bool is_read = !ferror(file);
    int reason = errno;
    (void)fclose(file);
    if (!is_read) {
        cant_find_out(owners, reason, message);
    } else if (is_owned) {
        (void)snprintf(message, PORTS_LINUX_MESSAGE_SIZE,
                       "ports %04X-%04X belong to %.*s (%s); --base names another address of the "
                       "jumper's",
                       base, base + BOARD_PORTS - 1, (int)strcspn(owner, "\n"), owner, owners);
    } else if (is_hidden) {
        (void)snprintf(message, PORTS_LINUX_MESSAGE_SIZE,
                       "who owns the ports can't be found out: %s shows no addresses to this user",
                       owners);
    }
    return is_read && !is_owned && !is_hidden;
}

/* ---- Opening -------------------------------------------------------------------------------- */

static enum ports_linux_result refuse(char *message, uint16_t base, int reason) {
    const char *help =
        reason == EPERM || reason == EACCES
            ? "; it takes root or CAP_SYS_RAWIO, and a kernel that is not locked down"
        : reason == ENOSYS ? "; this system or processor has no ports to open"
                           : "";
    (void)snprintf(message, PORTS_LINUX_MESSAGE_SIZE, "ports %04X-%04X can't be opened: %s%s", base,
                   base + BOARD_PORTS - 1, strerror(reason), help);
    return PORTS_LINUX_REFUSED;
}

enum ports_linux_result ports_linux_open(struct ports_linux *ports, uint16_t base,
                                         const struct ports_linux_system *system, char *message) {
    ports->bus.operations = &ports_operations;
    ports->bus.status = BUS_REFUSED; /* until the ports are open */
    ports->system = system;
    ports->base = base;
    if (!is_free(system->owners, base, message)) {
        return PORTS_LINUX_OWNED;
    }
    if (system->allow(base, BOARD_PORTS, 1) != 0) {
        return refuse(message, base, errno);
    }
    if (system->drop() != 0) {
        (void)snprintf(message, PORTS_LINUX_MESSAGE_SIZE, "the privileges can't be dropped: %s",
                       strerror(errno));
        (void)system->allow(base, BOARD_PORTS, 0);
        return PORTS_LINUX_REFUSED;
    }
    ports->bus.status = BUS_OK;
    return PORTS_LINUX_OPEN;
}

/* ---- Linux itself --------------------------------------------------------------------------- */

#if defined(__linux__) && (defined(__x86_64__) || defined(__i386__))

#include <grp.h>
#include <linux/capability.h>
#include <sys/io.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { NOBODY = 65534 };

static void real_write_byte(unsigned char value, unsigned short port) {
    outb(value, port);
}

static void real_write_word(unsigned short value, unsigned short port) {
    outw(value, port);
}

static unsigned char real_read_byte(unsigned short port) {
    return inb(port);
}

static unsigned short real_read_word(unsigned short port) {
    return inw(port);
}

/* Returns an identity that sudo left in the environment, else nobody's. */
static unsigned long who(const char *variable) {
    const char *text = getenv(variable);
    unsigned long number = text != NULL ? strtoul(text, NULL, 10) : 0;
    return number != 0 && number < 0xFFFFFFFFul ? number : NOBODY;
}

/* Drops the privileges. Root becomes whoever called sudo, or nobody; a program with set-user-ID
 * becomes its caller. Then the capabilities go that a file may have given. The ports stay open:
 * they belong to the thread. */
static int real_drop(void) {
    struct __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3];
    if (geteuid() == 0) {
        bool is_set_user = getuid() != 0;
        gid_t group = is_set_user ? getgid() : (gid_t)who("SUDO_GID");
        uid_t user = is_set_user ? getuid() : (uid_t)who("SUDO_UID");
        if (setgroups(0, NULL) != 0 || setgid(group) != 0 || setuid(user) != 0) {
            return -1;
        }
        if (setuid(0) == 0) {
            errno = EPERM; /* it should not have worked */
            return -1;
        }
    }
    memset(none, 0, sizeof none);
    return (int)syscall(SYS_capset, &header, none);
}

static int real_allow(unsigned long first, unsigned long count, int is_allowed) {
    return ioperm(first, count, is_allowed);
}

#else

static int real_allow(unsigned long first, unsigned long count, int is_allowed) {
    (void)first;
    (void)count;
    (void)is_allowed;
    errno = ENOSYS;
    return -1;
}

static void real_write_byte(unsigned char value, unsigned short port) {
    (void)value;
    (void)port;
}

static void real_write_word(unsigned short value, unsigned short port) {
    (void)value;
    (void)port;
}

static unsigned char real_read_byte(unsigned short port) {
    (void)port;
    return 0xFF;
}

static unsigned short real_read_word(unsigned short port) {
    (void)port;
    return 0xFFFF;
}

static int real_drop(void) {
    errno = ENOSYS;
    return -1;
}

#endif

const struct ports_linux_system ports_linux_system = {
    real_allow,     real_write_byte, real_write_word, real_read_byte,
    real_read_word, real_drop,       "/proc/ioports"};
