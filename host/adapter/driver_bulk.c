/* SPDX-License-Identifier: MIT */
/* The transport to an adapter by bulk transfers, with libusb-1.0: several transfers are in flight
 * at once. */
#include <libusb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "adapter/drivers.h"
#include "base/stopwatch.h"
#include "usb_device.h"

enum {
    OUT_TRANSFERS = USB_CREDITS_MOST,
    IN_TRANSFERS = 2,
    IN_BYTES = 4096, /* of a transfer: a multiple of each packet size */
    QUEUE_BYTES = 65536,
    POLL_MS = 20,
    SEND_MS = 2000,  /* for the adapter to take one of the frames in flight */
    CANCEL_MS = 1000 /* for cancelled transfers to come back */
};

struct bulk_link;

/* One transfer, and whether it is in flight. */
struct bulk_transfer {
    struct bulk_link *owner;
    struct libusb_transfer *transfer;
    bool is_busy;
    uint8_t bytes[USB_FRAME_MOST]; /* a transfer in needs less */
};

struct bulk_link {
    struct usb_link link; /* the first member */
    libusb_context *context;
    libusb_device_handle *handle; /* NULL: lost */
    char serial[USB_NAME_SIZE];
    uint8_t out_endpoint, in_endpoint;
    bool is_lost, is_out_stalled, is_in_stalled;
    struct bulk_transfer out[OUT_TRANSFERS], in[IN_TRANSFERS];
    size_t queue_begin, queue_count; /* a ring */
    uint8_t queue[QUEUE_BYTES];
};

/* ---- Looking ------------------------------------------------------------------------------- */

static bool is_adapter(libusb_device *device) {
    struct libusb_device_descriptor descriptor;
    return libusb_get_device_descriptor(device, &descriptor) == 0 &&
           descriptor.idVendor == USB_VENDOR_ID && descriptor.idProduct == USB_PRODUCT_ID;
}

static void read_serial(libusb_device *device, struct usb_found *found) {
    struct libusb_device_descriptor descriptor;
    libusb_device_handle *handle = NULL;
    found->is_accessible = libusb_open(device, &handle) == 0;
    found->serial[0] = '\0';
    if (!found->is_accessible) {
        return;
    }
    int length = -1;
    if (libusb_get_device_descriptor(device, &descriptor) == 0) {
        length = libusb_get_string_descriptor_ascii(
            handle, descriptor.iSerialNumber, (unsigned char *)found->serial, USB_NAME_SIZE - 1);
    }
    found->serial[length > 0 ? length : 0] = '\0';
    libusb_close(handle);
}

/* Adds the adapters to found, each with a reference to its device. Returns how many there are. */
static unsigned enumerate(libusb_context *context, struct usb_found *found, unsigned most) {
    libusb_device **devices = NULL;
    unsigned count = 0;
    ssize_t all = libusb_get_device_list(context, &devices);
    for (ssize_t i = 0; i < all && count < most; i++) {
        if (is_adapter(devices[i])) {
            (void)snprintf(found[count].path, USB_PATH_SIZE, "USB bus %03u device %03u",
                           libusb_get_bus_number(devices[i]),
                           libusb_get_device_address(devices[i]));
            read_serial(devices[i], &found[count]);
            found[count++].device = libusb_ref_device(devices[i]);
        }
    }
    if (all >= 0) {
        libusb_free_device_list(devices, 1);
    }
    return count;
}

static void forget(struct usb_found *found, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        libusb_unref_device(found[i].device);
        found[i].device = NULL;
    }
}

static bool begin(libusb_context **context, char *reason) {
    int error = libusb_init(context);
    reason[0] = '\0';
    if (error != 0) {
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "libusb can't be set up: %s",
                       libusb_strerror(error));
    }
    return error == 0;
}

static unsigned list(struct usb_found *found, unsigned most, char *reason) {
    libusb_context *context;
    if (!begin(&context, reason)) {
        return 0;
    }
    unsigned count = enumerate(context, found, most);
    forget(found, count);
    libusb_exit(context);
    return count;
}

/* ---- Transfers ----------------------------------------------------------------------------- */

static void lose(struct bulk_link *bulk, const char *why) {
    if (!bulk->is_lost) {
        (void)snprintf(bulk->link.reason, sizeof bulk->link.reason, "USB: %s", why);
    }
    bulk->is_lost = true;
}

static void submit(struct bulk_transfer *transfer) {
    int error = libusb_submit_transfer(transfer->transfer);
    transfer->is_busy = error == 0;
    if (error != 0) {
        lose(transfer->owner, libusb_strerror(error));
    }
}

static void LIBUSB_CALL out_is_done(struct libusb_transfer *transfer) {
    struct bulk_transfer *own = transfer->user_data;
    own->is_busy = false;
    own->owner->link.transfers++;
    switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
    case LIBUSB_TRANSFER_CANCELLED:
        break;
    case LIBUSB_TRANSFER_STALL:
        own->owner->is_out_stalled = true;
        break;
    default:
        lose(own->owner, "a transfer to the adapter failed");
        break;
    }
}

static void enqueue(struct bulk_link *bulk, const uint8_t *bytes, size_t count) {
    for (size_t i = 0; i < count && bulk->queue_count < QUEUE_BYTES; i++) {
        bulk->queue[(bulk->queue_begin + bulk->queue_count++) % QUEUE_BYTES] = bytes[i];
    }
}

static void LIBUSB_CALL in_is_done(struct libusb_transfer *transfer) {
    struct bulk_transfer *own = transfer->user_data;
    own->is_busy = false;
    switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
    case LIBUSB_TRANSFER_TIMED_OUT:
        own->owner->link.transfers++;
        enqueue(own->owner, own->bytes, (size_t)transfer->actual_length);
        submit(own);
        break;
    case LIBUSB_TRANSFER_STALL:
        own->owner->is_in_stalled = true;
        break;
    case LIBUSB_TRANSFER_CANCELLED:
        break;
    default:
        lose(own->owner, "a transfer from the adapter failed");
        break;
    }
}

/* Lets libusb work for at most so many milliseconds. */
static void work(struct bulk_link *bulk, long milliseconds) {
    struct timeval patience = {milliseconds / 1000, milliseconds % 1000 * 1000};
    (void)libusb_handle_events_timeout_completed(bulk->context, &patience, NULL);
}

static bool is_any_busy(const struct bulk_link *bulk) {
    bool is_busy = false;
    for (unsigned i = 0; i < OUT_TRANSFERS; i++) {
        is_busy = is_busy || bulk->out[i].is_busy;
    }
    for (unsigned i = 0; i < IN_TRANSFERS; i++) {
        is_busy = is_busy || bulk->in[i].is_busy;
    }
    return is_busy;
}

/* Ends all transfers in flight. Returns false if libusb does not give all of them back. */
static bool cancel(struct bulk_link *bulk) {
    struct timespec began = stopwatch_start();
    for (unsigned i = 0; i < OUT_TRANSFERS; i++) {
        if (bulk->out[i].is_busy) {
            (void)libusb_cancel_transfer(bulk->out[i].transfer);
        }
    }
    for (unsigned i = 0; i < IN_TRANSFERS; i++) {
        if (bulk->in[i].is_busy) {
            (void)libusb_cancel_transfer(bulk->in[i].transfer);
        }
    }
    while (is_any_busy(bulk) && stopwatch_seconds(&began) * 1000 < CANCEL_MS) {
        work(bulk, POLL_MS);
    }
    return !is_any_busy(bulk);
}

static bool make_transfers(struct bulk_link *bulk) {
    for (unsigned i = 0; i < OUT_TRANSFERS + IN_TRANSFERS; i++) {
        struct bulk_transfer *own =
            i < OUT_TRANSFERS ? &bulk->out[i] : &bulk->in[i - OUT_TRANSFERS];
        own->owner = bulk;
        own->transfer = libusb_alloc_transfer(0);
        if (own->transfer == NULL) {
            return false;
        }
    }
    return true;
}

static void free_transfers(struct bulk_link *bulk) {
    for (unsigned i = 0; i < OUT_TRANSFERS; i++) {
        libusb_free_transfer(bulk->out[i].transfer);
    }
    for (unsigned i = 0; i < IN_TRANSFERS; i++) {
        libusb_free_transfer(bulk->in[i].transfer);
    }
}

static void listen_anew(struct bulk_link *bulk) {
    for (unsigned i = 0; i < IN_TRANSFERS; i++) {
        struct bulk_transfer *own = &bulk->in[i];
        if (!own->is_busy && bulk->handle != NULL) {
            libusb_fill_bulk_transfer(own->transfer, bulk->handle, bulk->in_endpoint, own->bytes,
                                      IN_BYTES, in_is_done, own, 0);
            submit(own);
        }
    }
}

/* Returns what a call has to report before the call does anything: lost, or stalled and now
 * cleared. */
static enum usb_link_status state_of(struct bulk_link *bulk) {
    if (bulk->handle == NULL || bulk->is_lost) {
        return USB_LINK_LOST;
    }
    if (!bulk->is_out_stalled && !bulk->is_in_stalled) {
        return USB_LINK_OK;
    }
    /* What was in flight behind the stall is of no use: the bus sends it again. */
    int error = 0;
    if (!cancel(bulk)) {
        lose(bulk, "stalled transfers do not end");
        return USB_LINK_LOST;
    }
    if (bulk->is_out_stalled) {
        error = libusb_clear_halt(bulk->handle, bulk->out_endpoint);
    }
    if (error == 0 && bulk->is_in_stalled) {
        error = libusb_clear_halt(bulk->handle, bulk->in_endpoint);
    }
    bulk->is_out_stalled = bulk->is_in_stalled = false;
    if (error != 0) {
        lose(bulk, libusb_strerror(error));
        return USB_LINK_LOST;
    }
    listen_anew(bulk);
    return USB_LINK_STALLED;
}

static enum usb_link_status bulk_send(struct usb_link *link, const uint8_t *bytes, size_t count) {
    struct bulk_link *bulk = (struct bulk_link *)link;
    struct timespec began = stopwatch_start();
    for (;;) {
        enum usb_link_status status = state_of(bulk);
        if (status != USB_LINK_OK) {
            return status;
        }
        for (unsigned i = 0; i < OUT_TRANSFERS; i++) {
            struct bulk_transfer *own = &bulk->out[i];
            if (!own->is_busy) {
                memcpy(own->bytes, bytes, count);
                libusb_fill_bulk_transfer(own->transfer, bulk->handle, bulk->out_endpoint,
                                          own->bytes, (int)count, out_is_done, own, 0);
                submit(own);
                return bulk->is_lost ? USB_LINK_LOST : USB_LINK_OK;
            }
        }
        if (stopwatch_seconds(&began) * 1000 >= SEND_MS) {
            (void)cancel(bulk);
            listen_anew(bulk);
            return USB_LINK_TIMEOUT;
        }
        work(bulk, POLL_MS);
    }
}

static enum usb_link_status bulk_receive(struct usb_link *link, uint8_t *bytes, size_t room,
                                         unsigned timeout_ms, size_t *count) {
    struct bulk_link *bulk = (struct bulk_link *)link;
    struct timespec began = stopwatch_start();
    work(bulk, 0);
    while (bulk->queue_count == 0) {
        enum usb_link_status status = state_of(bulk);
        long left = (long)timeout_ms - (long)(stopwatch_seconds(&began) * 1000);
        if (status != USB_LINK_OK) {
            return status;
        }
        if (left <= 0) {
            return USB_LINK_TIMEOUT;
        }
        work(bulk, left);
    }
    *count = bulk->queue_count < room ? bulk->queue_count : room;
    for (size_t i = 0; i < *count; i++) {
        bytes[i] = bulk->queue[(bulk->queue_begin + i) % QUEUE_BYTES];
    }
    bulk->queue_begin = (bulk->queue_begin + *count) % QUEUE_BYTES;
    bulk->queue_count -= *count;
    return USB_LINK_OK;
}

/* ---- Opening and closing ------------------------------------------------------------------- */

/* Finds the addresses of the bulk pair, which are the device's to choose. */
static bool find_endpoints(struct bulk_link *bulk, libusb_device *device) {
    struct libusb_config_descriptor *configuration = NULL;
    bulk->out_endpoint = bulk->in_endpoint = 0;
    if (libusb_get_active_config_descriptor(device, &configuration) != 0) {
        return false;
    }
    if (configuration->bNumInterfaces > USB_BULK_INTERFACE &&
        configuration->interface[USB_BULK_INTERFACE].num_altsetting > 0) {
        const struct libusb_interface_descriptor *interface =
            configuration->interface[USB_BULK_INTERFACE].altsetting;
        for (unsigned i = 0; i < interface->bNumEndpoints; i++) {
            const struct libusb_endpoint_descriptor *endpoint = &interface->endpoint[i];
            if ((endpoint->bmAttributes & 3) == LIBUSB_TRANSFER_TYPE_BULK) {
                *((endpoint->bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0 ? &bulk->in_endpoint
                                                                         : &bulk->out_endpoint) =
                    endpoint->bEndpointAddress;
            }
        }
    }
    libusb_free_config_descriptor(configuration);
    return bulk->out_endpoint != 0 && bulk->in_endpoint != 0;
}

static enum usb_open_status claim(struct bulk_link *bulk, const struct usb_found *found,
                                  char *reason) {
    int error = libusb_open(found->device, &bulk->handle);
    if (error == LIBUSB_ERROR_ACCESS) {
        bulk->handle = NULL;
        usb_explain_access(reason, found->path);
        return USB_OPEN_DENIED;
    }
    if (error == 0) {
        error = find_endpoints(bulk, found->device)
                    ? libusb_claim_interface(bulk->handle, USB_BULK_INTERFACE)
                    : LIBUSB_ERROR_NOT_FOUND;
        if (error != 0) {
            libusb_close(bulk->handle);
            bulk->handle = NULL;
        }
    } else {
        bulk->handle = NULL;
    }
    if (error != 0) {
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "%s: can't be opened: %s", found->path,
                       libusb_strerror(error));
        return error == LIBUSB_ERROR_BUSY ? USB_OPEN_REFUSED : USB_OPEN_ABSENT;
    }
    return USB_OPEN_OK;
}

static enum usb_open_status open_device(struct bulk_link *bulk, const char *serial, char *reason) {
    struct usb_found found[USB_FOUND_MOST];
    unsigned index = 0, count = enumerate(bulk->context, found, USB_FOUND_MOST);
    enum usb_open_status status = usb_choose(found, count, serial, &index, reason);
    if (status == USB_OPEN_OK) {
        status = claim(bulk, &found[index], reason);
    }
    if (status == USB_OPEN_OK) {
        memcpy(bulk->serial, found[index].serial, sizeof bulk->serial);
        bulk->is_lost = bulk->is_out_stalled = bulk->is_in_stalled = false;
        bulk->queue_count = 0;
        listen_anew(bulk);
    }
    forget(found, count);
    return status;
}

static bool let_go(struct bulk_link *bulk) {
    bool is_clean = cancel(bulk);
    if (bulk->handle != NULL && is_clean) {
        (void)libusb_release_interface(bulk->handle, USB_BULK_INTERFACE);
        libusb_close(bulk->handle);
        bulk->handle = NULL;
    }
    return is_clean;
}

static enum usb_link_status bulk_reopen(struct usb_link *link, unsigned timeout_ms) {
    struct bulk_link *bulk = (struct bulk_link *)link;
    struct timespec began = stopwatch_start();
    char reason[USB_LINK_REASON_SIZE];
    while (let_go(bulk)) {
        if (open_device(bulk, bulk->serial, reason) == USB_OPEN_OK) {
            return USB_LINK_OK;
        }
        if (stopwatch_seconds(&began) * 1000 >= timeout_ms) {
            return USB_LINK_TIMEOUT;
        }
        work(bulk, POLL_MS); /* the arrival of a device is an event as well */
        const struct timespec pause = {0, POLL_MS * 1000000L};
        (void)nanosleep(&pause, NULL);
    }
    return USB_LINK_TIMEOUT;
}

static void bulk_close(struct usb_link *link) {
    struct bulk_link *bulk = (struct bulk_link *)link;
    if (!let_go(bulk)) {
        return; /* libusb still holds transfers: memory is lost rather than written to later */
    }
    free_transfers(bulk);
    libusb_exit(bulk->context);
    free(bulk);
}

static enum usb_open_status open_link(const char *serial, struct usb_link **link, char *reason) {
    static const struct usb_link_operations operations = {bulk_send, bulk_receive, bulk_reopen,
                                                          bulk_close};
    struct bulk_link *bulk = calloc(1, sizeof *bulk);
    *link = NULL;
    if (bulk == NULL || !begin(&bulk->context, reason)) {
        if (bulk == NULL) {
            (void)snprintf(reason, USB_LINK_REASON_SIZE, "out of memory");
        }
        free(bulk);
        return USB_OPEN_REFUSED;
    }
    bulk->link.operations = &operations;
    enum usb_open_status status = USB_OPEN_REFUSED;
    if (make_transfers(bulk)) {
        status = open_device(bulk, serial, reason);
    } else {
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "out of memory");
    }
    if (status != USB_OPEN_OK) {
        bulk_close(&bulk->link);
        return status;
    }
    *link = &bulk->link;
    return USB_OPEN_OK;
}

extern const struct usb_backend usb_backend_bulk;

const struct usb_backend usb_backend_bulk = {"usb", list, open_link};
