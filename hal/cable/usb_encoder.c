/* SPDX-License-Identifier: MIT */
/* Recognises pixels in a stream of accesses and finds the cheapest ops for a run of them. */
#include "usb_encoder.h"

enum {
    HEADER_COST = 12, /* eighths of a byte: what one op more costs, roughly; the op is exact */
    NO_WAY = 255
};

#define NEVER UINT32_C(0x3FFFFFFF) /* a cost that an int of 16 bits does not hold */

/* What decides which ways can send a pixel or pair. */
struct pixel_facts {
    unsigned changed; /* mask of the primaries that differ from the pixel before */
    bool is_copy, is_pair, is_extreme;
};

void usb_encoder_init(struct usb_encoder *encoder, size_t payload_most, void (*full)(void *context),
                      void *context) {
    usb_memory_clear(&encoder->memory);
    encoder->payload_most = payload_most;
    encoder->full = full;
    encoder->context = context;
    encoder->used = 0;
    encoder->stage = 0;
    encoder->count = 0;
}

/* Reserves so many bytes for an op. If the op has no room, the full payload is handed on first. */
static uint8_t *reserve(struct usb_encoder *encoder, size_t bytes) {
    if (encoder->used + bytes > encoder->payload_most) {
        encoder->full(encoder->context);
        encoder->used = 0;
    }
    uint8_t *place = encoder->payload + encoder->used;
    encoder->used += bytes;
    return place;
}

static bool equal(const uint8_t *a, const uint8_t *b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static bool is_extreme(uint8_t primary) {
    return primary == 0x00 || primary == 0xFF;
}

static struct pixel_facts facts_of(const struct usb_encoder *encoder, unsigned i) {
    const uint8_t *colour = encoder->run[i];
    const uint8_t *before = i == 0 ? encoder->memory.colour : encoder->run[i - 1];
    unsigned x = (unsigned)encoder->first_x + i;
    struct pixel_facts facts = {0, false, false, false};
    for (unsigned primary = 0; primary < 3; primary++) {
        facts.changed |= colour[primary] != before[primary] ? 1U << primary : 0U;
    }
    facts.is_copy = x < BOARD_WIDTH && equal(colour, encoder->memory.line[x]);
    facts.is_pair = i + 1 < encoder->count && equal(colour, encoder->run[i + 1]);
    facts.is_extreme = is_extreme(colour[0]) && is_extreme(colour[1]) && is_extreme(colour[2]);
    return facts;
}

static unsigned mask_of(unsigned way) {
    return way >= USB_WAY_PAIRS ? way - USB_WAY_PAIRS + 1 : way - USB_WAY_PIXELS + 1;
}

static bool is_pairs(unsigned way) {
    return way >= USB_WAY_PAIRS && way < USB_WAY_PLANES;
}

static unsigned bits_of(unsigned mask) {
    return (mask & 1) + (mask >> 1 & 1) + (mask >> 2 & 1);
}

static bool can_send(unsigned way, const struct pixel_facts *facts) {
    if (way == USB_WAY_SAME) {
        return facts->changed == 0;
    }
    if (way == USB_WAY_COPY) {
        return facts->is_copy;
    }
    if (way == USB_WAY_PLANES) {
        return facts->is_extreme;
    }
    return (facts->changed & ~mask_of(way)) == 0 && (!is_pairs(way) || facts->is_pair);
}

/* Returns the cost of one more pixel or pair, in eighths of a byte. */
static uint32_t data_cost(unsigned way) {
    if (way == USB_WAY_SAME || way == USB_WAY_COPY) {
        return 0;
    }
    return way == USB_WAY_PLANES ? 3 : 8 * bits_of(mask_of(way));
}

/* Tries to go on from pixel i by one way. */
static void try_way(struct usb_plan *plan, unsigned i, unsigned way) {
    unsigned end = i + (is_pairs(way) ? 2 : 1);
    uint32_t on = plan->cost[i][way];
    uint32_t anew = (i == 0 ? 0 : plan->cost[i][plan->best[i]]) + HEADER_COST;
    uint32_t cost = (on <= anew ? on : anew) + data_cost(way);
    if (cost < plan->cost[end][way]) {
        plan->cost[end][way] = cost;
        plan->before[end][way] = on <= anew ? (uint8_t)way : (i == 0 ? NO_WAY : plan->best[i]);
    }
}

/* Finds the way of each pixel of the run. */
static void make_plan(struct usb_encoder *encoder) {
    struct usb_plan *plan = &encoder->plan;
    for (unsigned i = 0; i <= encoder->count; i++) {
        for (unsigned way = 0; way < USB_WAYS; way++) {
            plan->cost[i][way] = NEVER;
        }
    }
    for (unsigned i = 0; i <= encoder->count; i++) {
        unsigned best = 0;
        for (unsigned way = 1; way < USB_WAYS; way++) {
            best = plan->cost[i][way] < plan->cost[i][best] ? way : best;
        }
        plan->best[i] = (uint8_t)best;
        if (i == encoder->count) {
            break;
        }
        struct pixel_facts facts = facts_of(encoder, i);
        for (unsigned way = 0; way < USB_WAYS; way++) {
            if (can_send(way, &facts)) {
                try_way(plan, i, way);
            }
        }
    }
    unsigned i = encoder->count;
    unsigned way = plan->best[i];
    while (i > 0) {
        unsigned before = plan->before[i][way];
        plan->way[--i] = (uint8_t)way;
        if (is_pairs(way)) {
            plan->way[--i] = (uint8_t)way;
        }
        way = before;
    }
}

/* Each function below emits one op for up to count pixels from first on, and returns how many
 * pixels the op took. */

static unsigned put_known(struct usb_encoder *encoder, unsigned way, unsigned count) {
    if (count <= USB_FEW_MOST) {
        unsigned code = way == USB_WAY_SAME ? USB_OP_SAME_FEW : USB_OP_COPY_FEW;
        reserve(encoder, 1)[0] = (uint8_t)(code | (count - 1));
    } else {
        uint8_t *op = reserve(encoder, 3);
        op[0] = way == USB_WAY_SAME ? USB_OP_SAME : USB_OP_COPY;
        usb_put16(op + 1, (uint16_t)count);
    }
    return count;
}

static unsigned put_planes(struct usb_encoder *encoder, unsigned first, unsigned count) {
    uint8_t *op = reserve(encoder, 3 + 3 * (((size_t)count + 7) / 8));
    op[0] = USB_OP_PLANES;
    usb_put16(op + 1, (uint16_t)count);
    op += 3;
    for (unsigned n = 0; n < count; n += 8) {
        for (unsigned primary = 0; primary < 3; primary++) {
            unsigned plane = 0;
            for (unsigned bit = 0; bit < 8 && n + bit < count; bit++) {
                plane |= (encoder->run[first + n + bit][primary] & 1U) << bit;
            }
            *op++ = (uint8_t)plane;
        }
    }
    return count;
}

static unsigned put_pixels(struct usb_encoder *encoder, unsigned way, unsigned first,
                           unsigned count) {
    unsigned mask = mask_of(way), step = is_pairs(way) ? 2 : 1;
    unsigned groups = count / step < USB_PIXELS_MOST ? count / step : USB_PIXELS_MOST;
    uint8_t *op = reserve(encoder, 2 + (size_t)groups * bits_of(mask));
    *op++ = (uint8_t)((is_pairs(way) ? USB_OP_PAIRS : USB_OP_PIXELS) | mask);
    *op++ = (uint8_t)(groups - 1);
    for (unsigned n = 0; n < groups; n++) {
        for (unsigned primary = 0; primary < 3; primary++) {
            if ((mask >> primary & 1) != 0) {
                *op++ = encoder->run[first + n * step][primary];
            }
        }
    }
    return groups * step;
}

static unsigned put_op(struct usb_encoder *encoder, unsigned first, unsigned count) {
    unsigned way = encoder->plan.way[first];
    if (way == USB_WAY_SAME || way == USB_WAY_COPY) {
        return put_known(encoder, way, count);
    }
    return way == USB_WAY_PLANES ? put_planes(encoder, first, count)
                                 : put_pixels(encoder, way, first, count);
}

static void seek(struct usb_encoder *encoder, uint16_t x) {
    if (encoder->memory.next_x != x) {
        uint8_t *op = reserve(encoder, 3);
        op[0] = USB_OP_SEEK;
        usb_put16(op + 1, x);
        encoder->memory.next_x = x;
    }
}

static void encode_run(struct usb_encoder *encoder) {
    if (encoder->count == 0) {
        return;
    }
    seek(encoder, encoder->first_x);
    make_plan(encoder);
    for (unsigned first = 0; first < encoder->count;) {
        unsigned end = first + 1;
        while (end < encoder->count && encoder->plan.way[end] == encoder->plan.way[first]) {
            end++;
        }
        first += put_op(encoder, first, end - first);
    }
    for (unsigned i = 0; i < encoder->count; i++) {
        usb_memory_pixel(&encoder->memory, encoder->run[i]);
    }
    encoder->count = 0;
}

static void put_plain(struct usb_encoder *encoder, unsigned offset, uint16_t value,
                      unsigned width) {
    if (offset == BOARD_Y && width == BUS_WORD && value == (uint16_t)(encoder->memory.y + 1)) {
        reserve(encoder, 1)[0] = USB_OP_NEXT_LINE;
    } else if (width == BUS_BYTE) {
        uint8_t *op = reserve(encoder, 2);
        op[0] = (uint8_t)(USB_OP_WRITE_BYTE | offset);
        op[1] = (uint8_t)value;
    } else {
        uint8_t *op = reserve(encoder, 3);
        op[0] = (uint8_t)(USB_OP_WRITE_WORD | offset);
        usb_put16(op + 1, value);
    }
    usb_memory_write(&encoder->memory, offset, value, width);
}

void usb_encoder_flush(struct usb_encoder *encoder) {
    unsigned stage = encoder->stage;
    encode_run(encoder);
    encoder->stage = 0;
    if (stage > 0) {
        put_plain(encoder, BOARD_X, encoder->x, BUS_WORD);
    }
    for (unsigned i = 1; i < stage; i++) {
        put_plain(encoder, BOARD_RED + 2 * (i - 1), encoder->colour[i - 1], BUS_BYTE);
    }
}

/* Takes a whole pixel, which joins the run or begins the next one. */
static void take_pixel(struct usb_encoder *encoder) {
    if (encoder->count == BOARD_WIDTH ||
        (encoder->count > 0 && encoder->x != encoder->first_x + encoder->count)) {
        encode_run(encoder);
    }
    if (encoder->count == 0) {
        encoder->first_x = encoder->x;
    }
    for (unsigned i = 0; i < 3; i++) {
        encoder->run[encoder->count][i] = encoder->colour[i];
    }
    encoder->count++;
    encoder->stage = 0;
}

/* Takes the access if it begins a pixel or goes on with one. Returns false if it does neither. */
static bool goes_on(struct usb_encoder *encoder, unsigned offset, uint16_t value, unsigned width) {
    if (encoder->stage == 0) {
        if (offset != BOARD_X || width != BUS_WORD) {
            return false;
        }
        encoder->x = value;
        encoder->stage = 1;
        return true;
    }
    if (width != BUS_BYTE || offset != BOARD_RED + 2 * (encoder->stage - 1)) {
        return false;
    }
    encoder->colour[encoder->stage - 1] = (uint8_t)value;
    if (encoder->stage == 3) {
        take_pixel(encoder);
    } else {
        encoder->stage++;
    }
    return true;
}

static bool is_of_the_board(unsigned offset, unsigned width) {
    return offset + width <= BOARD_PORTS;
}

bool usb_encoder_write(struct usb_encoder *encoder, unsigned offset, uint16_t value,
                       unsigned width) {
    if (!is_of_the_board(offset, width)) {
        return false;
    }
    if (!goes_on(encoder, offset, value, width)) {
        usb_encoder_flush(encoder);
        if (!goes_on(encoder, offset, value, width)) {
            put_plain(encoder, offset, width == BUS_BYTE ? (uint16_t)(value & 0xFF) : value, width);
        }
    }
    return true;
}

bool usb_encoder_read(struct usb_encoder *encoder, unsigned offset, unsigned width) {
    if (!is_of_the_board(offset, width)) {
        return false;
    }
    usb_encoder_flush(encoder);
    reserve(encoder, 1)[0] =
        (uint8_t)((width == BUS_BYTE ? USB_OP_READ_BYTE : USB_OP_READ_WORD) | offset);
    return true;
}

void usb_encoder_read_pixels(struct usb_encoder *encoder, uint16_t x, unsigned count) {
    usb_encoder_flush(encoder);
    seek(encoder, x);
    uint8_t *op = reserve(encoder, 2);
    op[0] = USB_OP_READ_PIXELS;
    op[1] = (uint8_t)(count - 1);
    encoder->memory.next_x = (uint16_t)(x + count);
}
