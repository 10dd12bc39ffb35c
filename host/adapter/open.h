/* SPDX-License-Identifier: MIT */
/* The adapter that --bus usb or --bus hid asks for: found, waited for, verified, and explained. */
#ifndef SUPERFRAME_ADAPTER_BUS_H
#define SUPERFRAME_ADAPTER_BUS_H

#include "adapter/bus.h"
#include "adapter/options.h"
#include "base/json.h"

/* All zero: not open. */
struct adapter_bus {
    const char *name; /* "usb" or "hid" */
    struct usb_link *link;
    struct usb_bus *usb; /* usb->bus is the bus */
    bool is_verified;
    struct usb_verification verification; /* what adapter_bus_verify() found */
};

/* Opens an adapter by a transport of usb_backend_names, after waiting for one if --wait says so.
 * base: the port base of the board behind the adapter. Returns STATUS_DONE; else the reason is
 * printed. */
int adapter_bus_open(struct adapter_bus *adapter, const char *name, uint16_t base,
                     const struct adapter_options *options);

/* Reads back so many per cent of the lines that were drawn, chosen by the seed. Repairs the lines,
 * and prints what that came to. Returns STATUS_DONE, or STATUS_FAILED if the bus failed or
 * something can't be repaired. */
int adapter_bus_verify(struct adapter_bus *adapter, unsigned percent, uint64_t seed);

/* Writes what the cable carried as the key adapter of the statistics. The counts of what was
 * verified are null where nothing was. */
void adapter_bus_write_stats(const struct adapter_bus *adapter, struct json *json);

/* Prints why the bus failed and which of the picture's rows first..last-1 are known to be on the
 * board. lines: how many of the board's lines make a row, 1 or 2. */
void adapter_bus_explain(const struct adapter_bus *adapter, unsigned first, unsigned last,
                         unsigned lines);

/* Closes an adapter; harmless if it is not open. */
void adapter_bus_close(struct adapter_bus *adapter);

#endif
