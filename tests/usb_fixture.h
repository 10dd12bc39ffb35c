/* SPDX-License-Identifier: MIT */
/* An adapter with a board behind it in this process, and a link to it that breaks as asked. */
#ifndef SUPERFRAME_TESTS_USB_FIXTURE_H
#define SUPERFRAME_TESTS_USB_FIXTURE_H

#include "adapter/bus.h"
#include "board_fixture.h"
#include "usb_device.h"

/* One in so many packets, on average; 0: never. */
struct cable_faults {
    uint32_t lose, corrupt, duplicate; /* packets to the adapter */
    uint32_t lose_reply, corrupt_reply, duplicate_reply;
    uint32_t stall;        /* sendings */
    uint32_t unplug;       /* sendings */
    uint32_t power_cycle;  /* of the unplugs: the adapter forgets */
    uint32_t restart;      /* packets to the adapter: it forgets, and its cable stays */
    bool is_board_cleared; /* with each of these, the board's memory too */
    unsigned unplugs_most; /* after so many it does not come back */
    bool is_hid;
};

/* What went through the link, counted without the bus. */
struct cable_tally {
    uint64_t sent_bytes, received_bytes, resent, timeouts, stalls, reconnects;
    uint64_t sessions; /* that frames belonged to */
    uint32_t session, highest_sent;
};

/* The cable, and what is at its end. */
struct cable {
    struct usb_link link; /* the first member */
    struct cable_faults faults;
    uint64_t random;
    bool is_gone;
    unsigned unplugs, power_cycles;
    uint64_t struck; /* faults so far */
    struct cable_tally tally;
    struct usb_device device;
    struct bus *far_bus; /* where the adapter's accesses go */
    struct board *far_board;
};

static inline bool cable_strikes(struct cable *cable, uint32_t one_in) {
    bool strikes = one_in != 0 && next_random(&cable->random) % one_in == 0;
    cable->struck += strikes;
    return strikes;
}

static inline void cable_configure(struct cable *cable) {
    static const uint8_t set_configuration[8] = {0, 9, 1, 0, 0, 0, 0, 0};
    uint8_t in[USB_CONTROL_MOST];
    assert_int_equal(usb_device_control(&cable->device, set_configuration, NULL, in), 0);
}

/* Starts the adapter anew, whether its cable stays or not. */
static inline void cable_restart(struct cable *cable) {
    cable->power_cycles++;
    usb_device_init(&cable->device, cable->far_bus, 0, "test", true);
    if (cable->faults.is_board_cleared) {
        struct board_desc desc = cable->far_board->desc;
        desc.noise = true;
        desc.noise_seed = cable->power_cycles;
        assert_true(board_init(cable->far_board, &desc));
    }
    cable_configure(cable);
}

static inline void cable_clear_halts(struct cable *cable) {
    static const uint8_t endpoints[4] = {USB_BULK_OUT, USB_BULK_IN, USB_HID_OUT, USB_HID_IN};
    for (unsigned i = 0; i < 4; i++) {
        const uint8_t clear[8] = {2, 1, 0, 0, endpoints[i], 0, 0, 0};
        uint8_t in[USB_CONTROL_MOST];
        assert_int_equal(usb_device_control(&cable->device, clear, NULL, in), 0);
    }
}

static inline void cable_flip_bit(struct cable *cable, uint8_t *bytes, size_t count) {
    uint32_t bit = next_random(&cable->random) % (uint32_t)(8 * count);
    bytes[bit / 8] ^= (uint8_t)(1U << bit % 8);
}

static inline bool cable_deliver(struct cable *cable, const uint8_t *packet, size_t count) {
    uint8_t copy[512];
    if (cable_strikes(cable, cable->faults.restart)) {
        cable_restart(cable);
    }
    if (cable_strikes(cable, cable->faults.lose)) {
        return true;
    }
    memcpy(copy, packet, count);
    if (cable_strikes(cable, cable->faults.corrupt)) {
        cable_flip_bit(cable, copy, count);
    }
    unsigned times = cable_strikes(cable, cable->faults.duplicate) ? 2 : 1;
    bool is_taken = true;
    while (times-- > 0) {
        is_taken = usb_device_out(&cable->device, cable->faults.is_hid ? USB_HID_OUT : USB_BULK_OUT,
                                  copy, count) &&
                   is_taken;
    }
    return is_taken;
}

static inline enum usb_link_status cable_carry(struct cable *cable, const uint8_t *bytes,
                                               size_t count) {
    bool is_taken = true;
    bool is_unplugged = cable_strikes(cable, cable->faults.unplug);
    size_t until = is_unplugged ? next_random(&cable->random) % (count + 1) : count;
    if (cable->is_gone) {
        return USB_LINK_LOST;
    }
    if (cable_strikes(cable, cable->faults.stall)) {
        return USB_LINK_STALLED;
    }
    for (size_t place = 0; place < until;) {
        uint8_t report[USB_REPORT_BYTES];
        if (cable->faults.is_hid) {
            place += usb_report_pack(report, bytes + place, until - place);
            is_taken = cable_deliver(cable, report, sizeof report) && is_taken;
        } else {
            size_t packet = until - place < 512 ? until - place : 512;
            is_taken = cable_deliver(cable, bytes + place, packet) && is_taken;
            place += packet;
        }
    }
    if (is_unplugged) {
        cable->is_gone = true;
        cable->unplugs++;
        return USB_LINK_LOST;
    }
    if (!is_taken) {
        cable_clear_halts(cable);
        return USB_LINK_STALLED;
    }
    return USB_LINK_OK;
}

/* Notes a frame that is handed to the link, from its own header. */
static inline void cable_note_frame(struct cable_tally *tally, const uint8_t *bytes, size_t count) {
    struct usb_header header;
    size_t length;
    assert_int_equal(usb_frame_scan(bytes, count, &header, &length), USB_SCAN_FRAME);
    assert_int_equal(length, count);
    if (header.session != tally->session) {
        tally->session = header.session;
        tally->highest_sent = 0;
        tally->sessions++;
    }
    tally->sent_bytes += count;
    if (header.kind == USB_KIND_RUN) {
        assert_true(header.sequence <= tally->highest_sent + 1);
        tally->resent += header.sequence <= tally->highest_sent;
        tally->highest_sent += header.sequence > tally->highest_sent;
    }
}

static inline enum usb_link_status cable_send(struct usb_link *link, const uint8_t *bytes,
                                              size_t count) {
    struct cable *cable = (struct cable *)link;
    cable_note_frame(&cable->tally, bytes, count);
    enum usb_link_status status = cable_carry(cable, bytes, count);
    cable->tally.stalls += status == USB_LINK_STALLED;
    return status;
}

static inline enum usb_link_status cable_fetch(struct cable *cable, uint8_t *bytes, size_t room,
                                               size_t *count) {
    bool is_hid = cable->faults.is_hid;
    for (;;) {
        uint8_t packet[USB_REPORT_BYTES];
        if (cable->is_gone) {
            return USB_LINK_LOST;
        }
        int got =
            usb_device_in(&cable->device, is_hid ? USB_HID_IN : USB_BULK_IN, packet, sizeof packet);
        if (got <= 0) {
            return USB_LINK_TIMEOUT;
        }
        if (cable_strikes(cable, cable->faults.lose_reply)) {
            continue;
        }
        if (cable_strikes(cable, cable->faults.corrupt_reply)) {
            cable_flip_bit(cable, packet, (size_t)got);
        }
        size_t length = is_hid ? usb_report_length(packet, (size_t)got) : (size_t)got;
        const uint8_t *stream = is_hid ? packet + 1 : packet;
        size_t times =
            2 * length <= room && cable_strikes(cable, cable->faults.duplicate_reply) ? 2 : 1;
        if (length == 0) {
            continue;
        }
        assert_true(length <= room);
        for (size_t i = 0; i < times; i++) {
            memcpy(bytes + i * length, stream, length);
        }
        *count = times * length;
        return USB_LINK_OK;
    }
}

/* Nothing will come later that is not there now. A glance, without patience, is no timeout. */
static inline enum usb_link_status cable_receive(struct usb_link *link, uint8_t *bytes, size_t room,
                                                 unsigned timeout_ms, size_t *count) {
    struct cable *cable = (struct cable *)link;
    enum usb_link_status status = cable_fetch(cable, bytes, room, count);
    cable->tally.timeouts += status == USB_LINK_TIMEOUT && timeout_ms > 0;
    cable->tally.received_bytes += status == USB_LINK_OK ? *count : 0;
    return status;
}

static inline enum usb_link_status cable_reopen(struct usb_link *link, unsigned timeout_ms) {
    struct cable *cable = (struct cable *)link;
    (void)timeout_ms;
    if (cable->unplugs > cable->faults.unplugs_most) {
        return USB_LINK_TIMEOUT;
    }
    cable->is_gone = false;
    cable->tally.reconnects++;
    if (cable_strikes(cable, cable->faults.power_cycle)) {
        cable_restart(cable);
    }
    usb_device_reset(&cable->device);
    cable_configure(cable);
    return USB_LINK_OK;
}

static inline void cable_close(struct usb_link *link) {
    (void)link;
}

/* Plugs in an adapter whose accesses go to far_bus. */
static inline void cable_plug(struct cable *cable, const struct cable_faults *faults, uint64_t seed,
                              struct bus *far_bus, struct board *far_board) {
    static const struct usb_link_operations cable_operations = {cable_send, cable_receive,
                                                                cable_reopen, cable_close};
    memset(cable, 0, sizeof *cable);
    cable->link.operations = &cable_operations;
    cable->faults = *faults;
    cable->random = seed * 2 + 1;
    cable->far_bus = far_bus;
    cable->far_board = far_board;
    usb_device_init(&cable->device, far_bus, 0, "test", true);
    cable_configure(cable);
}

/* Limits without any waiting in them. */
static inline struct usb_limits quick_limits(uint64_t seed) {
    struct usb_limits limits = usb_default_limits();
    limits.seed = seed;
    limits.reopen_ms = 200;
    return limits;
}

#endif
