/* SPDX-License-Identifier: MIT */
/* The operations of a payload: taken apart in one place, then checked or run. */
#include "usb_ops.h"

/* One op, taken apart. */
struct op {
    uint8_t code;        /* of enum usb_op */
    uint8_t low;         /* offset or mask */
    uint16_t number;     /* value, count of pixels or of pairs */
    const uint8_t *data; /* what follows it */
    size_t length;       /* of everything, the op's own byte included */
    size_t reads;        /* bytes it gives */
};

static unsigned bits_of(unsigned mask) {
    return (mask & 1) + (mask >> 1 & 1) + (mask >> 2 & 1);
}

/* Takes apart the ops with a number of 16 bits: SEEK, SAME, COPY, PLANES. head is three bytes at
 * least; nothing behind them is read here. */
static void take_apart_counted(const uint8_t *ops, const uint8_t *head, struct op *op) {
    op->number = usb_get16(head + 1);
    op->length = 3;
    if (op->code == USB_OP_PLANES) {
        op->data = ops + 3;
        op->length += 3 * (((size_t)op->number + 7) / 8);
    }
}

static void take_apart_pixels(const uint8_t *ops, const uint8_t *head, struct op *op) {
    op->code = (uint8_t)(ops[0] & 0xF8);
    op->low = ops[0] & 7;
    op->number = (uint16_t)(head[1] + 1);
    op->data = ops + 2;
    op->length = 2 + (size_t)op->number * bits_of(op->low);
}

/* Takes the first op apart. Returns false if the op is unknown or not whole; of the codes 4Xh
 * is_in_range() finds the unknown ones. */
static bool take_apart(const uint8_t *ops, size_t count, struct op *op) {
    /* An op that is cut off is read as if zeros followed; its length then does not fit. */
    const uint8_t padded[3] = {ops[0], count > 1 ? ops[1] : (uint8_t)0, 0};
    const uint8_t *head = count >= 3 ? ops : padded;
    const struct op empty = {ops[0], 0, 0, ops, 1, 0};
    *op = empty;
    switch (ops[0] >> 4) {
    case 0:
    case 1:
        op->code = (uint8_t)(ops[0] & 0xF0);
        op->low = ops[0] & 15;
        op->number = op->code == USB_OP_WRITE_BYTE ? head[1] : usb_get16(head + 1);
        op->length = op->code == USB_OP_WRITE_BYTE ? 2 : 3;
        break;
    case 2:
    case 3:
        op->code = (uint8_t)(ops[0] & 0xF0);
        op->low = ops[0] & 15;
        op->reads = op->code == USB_OP_READ_BYTE ? 1 : 2;
        break;
    case 4:
        if (ops[0] == USB_OP_READ_PIXELS) {
            op->number = (uint16_t)(head[1] + 1);
            op->length = 2;
            op->reads = 3 * (size_t)op->number;
        } else if (ops[0] != USB_OP_NEXT_LINE) {
            take_apart_counted(ops, head, op);
        }
        break;
    case 5:
    case 6:
        op->code = (uint8_t)(ops[0] >> 4 == 5 ? USB_OP_SAME : USB_OP_COPY);
        op->number = (uint16_t)((ops[0] & 15) + 1);
        break;
    case 8:
        if ((ops[0] & 7) == 0) {
            return false;
        }
        take_apart_pixels(ops, head, op);
        break;
    default:
        return false;
    }
    return op->length <= count;
}

/* Tells whether an op is known and its numbers are in range. *next_x moves on as the op moves
 * it. */
static bool is_in_range(const struct op *op, uint16_t *next_x) {
    size_t pixels = op->number;
    switch (op->code) {
    case USB_OP_WRITE_BYTE:
    case USB_OP_READ_BYTE:
        return true;
    case USB_OP_READ_WORD:
        return op->low < BOARD_PORTS - 1;
    case USB_OP_WRITE_WORD:
        if (op->low == BOARD_Y) {
            *next_x = 0;
        }
        return op->low < BOARD_PORTS - 1; /* its high byte would leave the board's ports */
    case USB_OP_NEXT_LINE:
        *next_x = 0;
        return true;
    case USB_OP_SEEK:
        *next_x = op->number;
        return true;
    case USB_OP_COPY:
        if (*next_x >= BOARD_WIDTH || pixels > (size_t)(BOARD_WIDTH - *next_x)) {
            return false;
        }
        break;
    case USB_OP_SAME:
    case USB_OP_PLANES:
    case USB_OP_READ_PIXELS:
    case USB_OP_PIXELS:
        break;
    case USB_OP_PAIRS:
        pixels *= 2;
        break;
    default:
        return false;
    }
    *next_x = (uint16_t)(*next_x + pixels);
    return pixels >= 1 && pixels <= BOARD_WIDTH;
}

bool usb_ops_check(const struct usb_memory *memory, const uint8_t *ops, size_t count,
                   size_t *reads) {
    uint16_t next_x = memory->next_x;
    *reads = 0;
    while (count > 0) {
        struct op op;
        if (!take_apart(ops, count, &op) || !is_in_range(&op, &next_x)) {
            return false;
        }
        *reads += op.reads;
        if (*reads > USB_READ_MOST) {
            return false;
        }
        ops += op.length;
        count -= op.length;
    }
    return true;
}

/* Clears by bytes: a constant to copy from would take 2 KB of an adapter's flash. */
void usb_memory_clear(struct usb_memory *memory) {
    uint8_t *bytes = (uint8_t *)memory;
    for (size_t i = 0; i < sizeof *memory; i++) {
        bytes[i] = 0;
    }
}

void usb_memory_pixel(struct usb_memory *memory, const uint8_t colour[3]) {
    for (unsigned i = 0; i < 3; i++) {
        memory->colour[i] = colour[i];
        if (memory->next_x < BOARD_WIDTH) {
            memory->line[memory->next_x][i] = colour[i];
        }
    }
    memory->next_x++;
}

void usb_memory_write(struct usb_memory *memory, unsigned offset, uint16_t value, unsigned width) {
    if (offset == BOARD_Y && width == BUS_WORD) {
        memory->y = value;
        memory->next_x = 0;
    }
}

/* Where ops run. */
struct target {
    struct usb_memory *memory;
    struct bus *bus;
    uint16_t base;
};

static uint16_t port(const struct target *target, unsigned offset) {
    return (uint16_t)(target->base + offset);
}

static void draw(const struct target *target, const uint8_t colour[3]) {
    struct bus *bus = target->bus;
    bus_write(bus, port(target, BOARD_X), target->memory->next_x, BUS_WORD);
    bus_write(bus, port(target, BOARD_RED), colour[0], BUS_BYTE);
    bus_write(bus, port(target, BOARD_GREEN), colour[1], BUS_BYTE);
    bus_write(bus, port(target, BOARD_BLUE), colour[2], BUS_BYTE);
    usb_memory_pixel(target->memory, colour);
}

static void draw_pixels(const struct target *target, const struct op *op) {
    const uint8_t *data = op->data;
    for (unsigned n = 0; n < op->number; n++) {
        uint8_t colour[3];
        for (unsigned i = 0; i < 3; i++) {
            colour[i] = (op->low >> i & 1) != 0 ? *data++ : target->memory->colour[i];
        }
        draw(target, colour);
        if (op->code == USB_OP_PAIRS) {
            draw(target, colour);
        }
    }
}

static void draw_planes(const struct target *target, const struct op *op) {
    for (unsigned n = 0; n < op->number; n++) {
        const uint8_t *planes = op->data + (size_t)3 * (n / 8);
        uint8_t colour[3];
        for (unsigned i = 0; i < 3; i++) {
            colour[i] = (planes[i] >> n % 8 & 1) != 0 ? 0xFF : 0x00;
        }
        draw(target, colour);
    }
}

/* Draws SAME and COPY. The line is read before it is drawn over. */
static void draw_known(const struct target *target, const struct op *op) {
    for (unsigned n = 0; n < op->number; n++) {
        struct usb_memory *memory = target->memory;
        const uint8_t *known =
            op->code == USB_OP_COPY ? memory->line[memory->next_x] : memory->colour;
        uint8_t colour[3] = {known[0], known[1], known[2]};
        draw(target, colour);
    }
}

static size_t read_pixels(const struct target *target, const struct op *op, uint8_t *data) {
    size_t used = 0;
    for (unsigned n = 0; n < op->number; n++) {
        bus_write(target->bus, port(target, BOARD_X), target->memory->next_x++, BUS_WORD);
        for (unsigned offset = BOARD_RED; offset <= BOARD_BLUE; offset += 2) {
            data[used++] = (uint8_t)bus_read(target->bus, port(target, offset), BUS_BYTE);
        }
    }
    return used;
}

static size_t run_op(const struct target *target, const struct op *op, uint8_t *data) {
    unsigned width =
        op->code == USB_OP_WRITE_BYTE || op->code == USB_OP_READ_BYTE ? BUS_BYTE : BUS_WORD;
    switch (op->code) {
    case USB_OP_WRITE_BYTE:
    case USB_OP_WRITE_WORD:
        bus_write(target->bus, port(target, op->low), op->number, width);
        usb_memory_write(target->memory, op->low, op->number, width);
        return 0;
    case USB_OP_READ_BYTE:
    case USB_OP_READ_WORD: {
        uint16_t value = bus_read(target->bus, port(target, op->low), width);
        data[0] = (uint8_t)value;
        if (width == BUS_WORD) {
            data[1] = (uint8_t)(value >> 8);
        }
        return width;
    }
    case USB_OP_SEEK:
        target->memory->next_x = op->number;
        return 0;
    case USB_OP_NEXT_LINE: {
        uint16_t y = (uint16_t)(target->memory->y + 1);
        bus_write(target->bus, port(target, BOARD_Y), y, BUS_WORD);
        usb_memory_write(target->memory, BOARD_Y, y, BUS_WORD);
        return 0;
    }
    case USB_OP_READ_PIXELS:
        return read_pixels(target, op, data);
    case USB_OP_PLANES:
        draw_planes(target, op);
        return 0;
    case USB_OP_PIXELS:
    case USB_OP_PAIRS:
        draw_pixels(target, op);
        return 0;
    default:
        draw_known(target, op);
        return 0;
    }
}

size_t usb_ops_run(struct usb_memory *memory, struct bus *bus, uint16_t base, const uint8_t *ops,
                   size_t count, uint8_t *data) {
    const struct target target = {memory, bus, base};
    size_t used = 0;
    while (count > 0) {
        struct op op;
        if (!take_apart(ops, count, &op)) {
            return used; /* not reached: the payload was checked */
        }
        used += run_op(&target, &op, data + used);
        ops += op.length;
        count -= op.length;
    }
    return used;
}
