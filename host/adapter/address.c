/* SPDX-License-Identifier: MIT */
/* IP addresses in one form, and which of them a range holds. */
#include "adapter/address.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <string.h>

#include "base/numbers.h"

enum { MAPPED_BYTES = 12, MAPPED_BITS = 8 * MAPPED_BYTES, IPV4_BITS = 32, IPV6_BITS = 128 };

static void map_ipv4(const struct in_addr *ipv4, struct address *address) {
    static const uint8_t mapped[MAPPED_BYTES] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};
    memcpy(address->bytes, mapped, sizeof mapped);
    memcpy(address->bytes + sizeof mapped, &ipv4->s_addr, sizeof ipv4->s_addr);
}

bool address_of(const struct sockaddr_storage *place, struct address *address) {
    if (place->ss_family == AF_INET) {
        map_ipv4(&((const struct sockaddr_in *)place)->sin_addr, address);
    } else if (place->ss_family == AF_INET6) {
        memcpy(address->bytes, ((const struct sockaddr_in6 *)place)->sin6_addr.s6_addr,
               sizeof address->bytes);
    } else {
        return false;
    }
    return true;
}

bool address_is_loopback(const struct address *address) {
    static const struct address_range own[] = {
        {{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 127}}, MAPPED_BITS + 8},
        {{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}}, IPV6_BITS}};
    return address_range_holds(&own[0], address) || address_range_holds(&own[1], address);
}

bool address_range_read(const char *text, struct address_range *range) {
    char address[INET6_ADDRSTRLEN];
    struct address_range found;
    struct in_addr ipv4;
    size_t length = strcspn(text, "/");
    if (length >= sizeof address) {
        return false;
    }
    memcpy(address, text, length);
    address[length] = '\0';
    bool is_ipv4 = inet_pton(AF_INET, address, &ipv4) == 1;
    if (is_ipv4) {
        map_ipv4(&ipv4, &found.first);
    } else if (inet_pton(AF_INET6, address, found.first.bytes) != 1) {
        return false;
    }
    uint64_t bits = is_ipv4 ? IPV4_BITS : IPV6_BITS;
    if (text[length] == '/' && !value_whole(text + length + 1, 0, bits, &bits)) {
        return false;
    }
    found.bits = (unsigned)bits + (is_ipv4 ? MAPPED_BITS : 0);
    *range = found;
    return true;
}

bool address_range_holds(const struct address_range *range, const struct address *address) {
    unsigned bytes = range->bits / 8, rest = range->bits % 8;
    if (memcmp(range->first.bytes, address->bytes, bytes) != 0) {
        return false;
    }
    return rest == 0 || (range->first.bytes[bytes] ^ address->bytes[bytes]) >> (8 - rest) == 0;
}
