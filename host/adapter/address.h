/* SPDX-License-Identifier: MIT */
/* IP addresses of clients, and ranges of such addresses. An IPv4 address is held as IPv6 maps it,
 * ::ffff:A.B.C.D. So there is one form, also where an IPv6 socket serves IPv4 clients. */
#ifndef SUPERFRAME_ADDRESS_H
#define SUPERFRAME_ADDRESS_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/socket.h>

enum { ADDRESS_BYTES = 16 };

/* An address. */
struct address {
    uint8_t bytes[ADDRESS_BYTES];
};

/* The addresses that begin with the same bits. */
struct address_range {
    struct address first;
    unsigned bits; /* 0..128 */
};

/* Takes the address out of what accept() and getsockname() give. False: it is no IP address. */
bool address_of(const struct sockaddr_storage *place, struct address *address);

/* Tells whether an address is the machine's own: 127.0.0.0/8 or ::1. */
bool address_is_loopback(const struct address *address);

/* Reads "ADDRESS" or "ADDRESS/BITS", an address of IPv4 (0..32 bits) or IPv6 (0..128) in numbers.
 * Any other text gives false and leaves *range untouched. */
bool address_range_read(const char *text, struct address_range *range);

/* Tells whether an address lies in a range. */
bool address_range_holds(const struct address_range *range, const struct address *address);

#endif
