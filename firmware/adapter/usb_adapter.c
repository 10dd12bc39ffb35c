/* SPDX-License-Identifier: MIT */
/* The adapter: finds frames in a stream, runs each once and in order, replies to each. */
#include "usb_adapter.h"

#include "board_ports.h"

void usb_adapter_init(struct usb_adapter *adapter, struct bus *bus, uint16_t base_served) {
    adapter->bus = bus;
    adapter->base_served = base_served;
    adapter->session = adapter->last = 0;
    adapter->base = 0;
    adapter->data_count = 0;
    adapter->frames_run = adapter->duplicates = adapter->damaged = 0;
    usb_memory_clear(&adapter->memory);
    usb_adapter_detach(adapter);
}

void usb_adapter_detach(struct usb_adapter *adapter) {
    adapter->input_count = 0;
    adapter->output_count = 0;
}

static void reply(struct usb_adapter *adapter, uint8_t status, uint32_t sequence,
                  const uint8_t *payload, size_t count) {
    const struct usb_header header = {USB_VERSION, USB_KIND_REPLY,  adapter->session,
                                      sequence,    adapter->last,   (uint16_t)count,
                                      status,      USB_CREDITS_MOST};
    uint8_t *place = adapter->output + adapter->output_count;
    adapter->output_count =
        (uint16_t)(adapter->output_count + usb_frame_pack(place, &header, payload));
}

static bool is_served(const struct usb_adapter *adapter, uint16_t base) {
    return adapter->base_served != 0 ? base == adapter->base_served : board_base_is_offered(base);
}

/* Answers a hello. A hello for the current session changes nothing, so that a late duplicate does
 * no harm. */
static void answer_hello(struct usb_adapter *adapter, const struct usb_header *header,
                         const uint8_t *payload) {
    uint8_t bytes[USB_HELLO_REPLY_BYTES];
    uint8_t status = USB_STATUS_OK;
    uint16_t base = header->length >= USB_HELLO_BYTES ? usb_get16(payload) : 0;
    bool is_current = header->session == adapter->session;
    if (!is_served(adapter, base) || header->session == 0 ||
        (is_current && base != adapter->base)) {
        status = USB_STATUS_BAD_BASE;
    } else if (!is_current && (header->status & USB_HELLO_START) == 0) {
        status = USB_STATUS_UNKNOWN_SESSION;
    } else if (!is_current) {
        adapter->session = header->session;
        adapter->last = 0;
        adapter->base = base;
        usb_memory_clear(&adapter->memory);
        adapter->data_count = 0;
    }
    const struct usb_hello_reply hello = {
        USB_PAYLOAD_MOST, USB_READ_MOST, adapter->base != 0 ? adapter->base : adapter->base_served,
        USB_CREDITS_MOST, USB_CAN_BURST | USB_CAN_COPY | USB_CAN_READ};
    usb_hello_reply_pack(bytes, &hello);
    reply(adapter, status, 0, bytes, sizeof bytes);
}

static void answer_run(struct usb_adapter *adapter, const struct usb_header *header,
                       const uint8_t *ops) {
    size_t reads;
    uint8_t status = USB_STATUS_OK;
    if (adapter->session == 0 || header->session != adapter->session) {
        status = USB_STATUS_UNKNOWN_SESSION;
    } else if (header->sequence <= adapter->last) {
        bool is_last = header->sequence == adapter->last;
        adapter->duplicates++;
        reply(adapter, USB_STATUS_DUPLICATE, header->sequence, adapter->data,
              is_last ? adapter->data_count : 0);
        return;
    } else if (header->sequence != adapter->last + 1) {
        status = USB_STATUS_GAP;
    } else if (!usb_ops_check(&adapter->memory, ops, header->length, &reads)) {
        status = USB_STATUS_BAD_OP;
    }
    if (status != USB_STATUS_OK) {
        reply(adapter, status, header->sequence, ops, 0);
        return;
    }
    adapter->data_count = (uint16_t)usb_ops_run(&adapter->memory, adapter->bus, adapter->base, ops,
                                                header->length, adapter->data);
    adapter->last = header->sequence;
    adapter->frames_run++;
    reply(adapter, USB_STATUS_OK, header->sequence, adapter->data, adapter->data_count);
}

static void answer(struct usb_adapter *adapter, const struct usb_header *header) {
    const uint8_t *payload = adapter->input + USB_HEADER_BYTES;
    if (header->version != USB_VERSION) {
        reply(adapter, USB_STATUS_BAD_VERSION, header->sequence, payload, 0);
    } else if (header->kind == USB_KIND_HELLO) {
        answer_hello(adapter, header, payload);
    } else if (header->kind == USB_KIND_RUN) {
        answer_run(adapter, header, payload);
    } else {
        reply(adapter, USB_STATUS_BAD_KIND, header->sequence, payload, 0);
    }
}

static void drop_input(struct usb_adapter *adapter, size_t count) {
    for (size_t i = count; i < adapter->input_count; i++) {
        adapter->input[i - count] = adapter->input[i];
    }
    adapter->input_count = (uint16_t)(adapter->input_count - count);
}

static bool has_room_for_reply(const struct usb_adapter *adapter) {
    return adapter->output_count + USB_REPLY_MOST <= USB_OUTPUT_BYTES;
}

/* Answers the frames in the input. Returns false if a reply must be fetched first. */
static bool work_off(struct usb_adapter *adapter) {
    for (;;) {
        struct usb_header header;
        size_t length = 0;
        if (!has_room_for_reply(adapter)) {
            return false;
        }
        switch (usb_frame_scan(adapter->input, adapter->input_count, &header, &length)) {
        case USB_SCAN_MORE:
            return true;
        case USB_SCAN_FRAME:
            answer(adapter, &header);
            break;
        case USB_SCAN_DAMAGED:
            adapter->damaged++;
            reply(adapter, USB_STATUS_BAD_CHECK, header.sequence, adapter->input, 0);
            break;
        case USB_SCAN_NOISE:
            adapter->damaged++;
            break;
        }
        drop_input(adapter, length);
    }
}

size_t usb_adapter_receive(struct usb_adapter *adapter, const uint8_t *bytes, size_t count) {
    size_t taken = 0;
    for (;;) {
        bool may_go_on = work_off(adapter);
        while (taken < count && adapter->input_count < USB_FRAME_MOST) {
            adapter->input[adapter->input_count++] = bytes[taken++];
        }
        if (taken == count) {
            (void)work_off(adapter);
            return taken;
        }
        if (!may_go_on) {
            return taken;
        }
    }
}

size_t usb_adapter_fetch(struct usb_adapter *adapter, uint8_t *bytes, size_t room) {
    size_t count = adapter->output_count < room ? adapter->output_count : room;
    for (size_t i = 0; i < count; i++) {
        bytes[i] = adapter->output[i];
    }
    for (size_t i = count; i < adapter->output_count; i++) {
        adapter->output[i - count] = adapter->output[i];
    }
    adapter->output_count = (uint16_t)(adapter->output_count - count);
    (void)work_off(adapter); /* frames that waited for room */
    return count;
}
