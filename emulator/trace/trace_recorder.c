/* SPDX-License-Identifier: MIT */
/* Records port accesses: the binary form by prediction, the text form a line each. */
#include "trace_recorder.h"

#include <errno.h>
#include <xxhash.h>

static void write_out(struct trace_recorder *recorder, const void *bytes, size_t size) {
    if (recorder->error_number == 0 && fwrite(bytes, 1, size, recorder->file) != size) {
        recorder->error_number = errno;
        bus_fail(&recorder->bus, BUS_IO_ERROR);
    }
}

static void flush_out(struct trace_recorder *recorder) {
    if (recorder->error_number == 0 && fflush(recorder->file) != 0) {
        recorder->error_number = errno;
        bus_fail(&recorder->bus, BUS_IO_ERROR);
    }
}

/* ---- The binary form ------------------------------------------------------------------------ */

static void begin_block(struct trace_recorder *recorder) {
    recorder->used = TRACE_BLOCK_HEADER_SIZE;
    recorder->block_accesses = 0;
    trace_model_reset(&recorder->model);
}

/* Writes the buffered block, if it holds anything, and begins the next. */
static void end_block(struct trace_recorder *recorder) {
    if (recorder->block_accesses == 0) {
        return;
    }
    trace_put(recorder->buffer, recorder->used - TRACE_BLOCK_HEADER_SIZE, 4);
    trace_put(recorder->buffer + 4, recorder->block_accesses, 4);
    recorder->checksum = XXH3_64bits_withSeed(recorder->buffer, recorder->used, recorder->checksum);
    trace_put(recorder->buffer + recorder->used, recorder->checksum, TRACE_CHECKSUM_SIZE);
    write_out(recorder, recorder->buffer, recorder->used + TRACE_CHECKSUM_SIZE);
    recorder->accesses += recorder->block_accesses;
    begin_block(recorder);
}

static void write_header(struct trace_recorder *recorder, const struct trace_header *header) {
    uint8_t bytes[TRACE_HEADER_SIZE] = {0};
    memcpy(bytes, trace_magic, TRACE_MAGIC_SIZE);
    trace_put(bytes + 8, TRACE_VERSION, 2);
    bytes[10] = (uint8_t)header->profile;
    trace_put(bytes + 12, header->base, 2);
    recorder->checksum = XXH3_64bits(bytes, TRACE_HEADER_SIZE - TRACE_CHECKSUM_SIZE);
    trace_put(bytes + TRACE_HEADER_SIZE - TRACE_CHECKSUM_SIZE, recorder->checksum,
              TRACE_CHECKSUM_SIZE);
    write_out(recorder, bytes, sizeof bytes);
}

static void write_end(struct trace_recorder *recorder) {
    uint8_t bytes[TRACE_END_SIZE + TRACE_CHECKSUM_SIZE] = {0};
    trace_put(bytes + 8, recorder->accesses, 8);
    trace_put(bytes + TRACE_END_SIZE,
              XXH3_64bits_withSeed(bytes, TRACE_END_SIZE, recorder->checksum), TRACE_CHECKSUM_SIZE);
    write_out(recorder, bytes, sizeof bytes);
}

/* Adds an access that has a rare code: another kind than predicted, or another port than the
 * board's. Returns the code. */
static unsigned put_unexpected(struct trace_recorder *recorder, unsigned offset, uint16_t port,
                               uint16_t value, unsigned width, bool is_read) {
    uint8_t *bytes = recorder->buffer + recorder->used;
    unsigned size = 0;
    unsigned code = TRACE_CODE_KIND;
    if (offset < BOARD_PORTS) {
        unsigned slot = trace_slot(offset, width, is_read);
        bytes[size++] = (uint8_t)slot;
        trace_model_update(&recorder->model, slot, value);
    } else {
        code = TRACE_CODE_FOREIGN;
        bytes[size++] =
            (uint8_t)((is_read ? TRACE_FLAG_READ : 0) | (width == BUS_WORD ? TRACE_FLAG_WORD : 0));
        trace_put(bytes + size, port, 2);
        size += 2;
    }
    trace_put(bytes + size, value, width);
    recorder->used += size + width;
    return code;
}

/* Adds one access to the block. The common case has no branch that depends on the value: which
 * bytes a picture has can't be predicted by the CPU. */
static inline void put_binary(struct trace_recorder *recorder, uint16_t port, uint16_t value,
                              unsigned width, bool is_read) {
    struct trace_model *model = &recorder->model;
    unsigned offset = (uint16_t)(port - recorder->base);
    unsigned place = recorder->block_accesses & 3;
    unsigned code = TRACE_CODE_EXPECTED;
    if (place == 0) {
        if (recorder->used > TRACE_BUFFER_SIZE - TRACE_CHECKSUM_SIZE - 4 * TRACE_LONGEST_ACCESS) {
            end_block(recorder);
        }
        recorder->control = recorder->used++;
        recorder->buffer[recorder->control] = 0;
    }
    unsigned slot = trace_slot(offset, width, is_read);
    if (slot == model->next[model->previous]) {
        unsigned differs = value != model->predicted[slot] ? 1 : 0;
        recorder->buffer[recorder->used] = (uint8_t)value;
        recorder->buffer[recorder->used + 1] = (uint8_t)(value >> 8);
        recorder->used += width & (0U - differs);
        code = differs; /* TRACE_CODE_EXPECTED or TRACE_CODE_VALUE */
        trace_model_update(model, slot, value);
    } else {
        code = put_unexpected(recorder, offset, port, value, width, is_read);
    }
    recorder->buffer[recorder->control] |= (uint8_t)(code << (2 * place));
    recorder->block_accesses++;
}

static void binary_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    value = width == BUS_BYTE ? (uint16_t)(value & 0xFF) : value;
    bus_write(recorder->inner, port, value, width);
    put_binary(recorder, port, value, width, false);
    if (recorder->inner->status != BUS_OK) {
        bus_fail(bus, recorder->inner->status);
    }
}

static uint16_t binary_read(struct bus *bus, uint16_t port, unsigned width) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    uint16_t value = bus_read(recorder->inner, port, width);
    put_binary(recorder, port, value, width, true);
    bus_fail(bus, recorder->inner->status);
    return value;
}

static void binary_flush(struct bus *bus) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    end_block(recorder);
    flush_out(recorder);
    bus_fail(bus, bus_flush(recorder->inner));
}

static const struct bus_operations binary_operations = {binary_write, binary_read, binary_flush};

/* ---- The text form -------------------------------------------------------------------------- */

static void end_text(struct trace_recorder *recorder) {
    if (recorder->used > 0) {
        write_out(recorder, recorder->buffer, recorder->used);
        recorder->used = 0;
    }
}

static void put_text(struct trace_recorder *recorder, uint16_t port, uint16_t value, unsigned width,
                     bool is_read) {
    struct trace_access access = {port, value, (uint8_t)width, is_read};
    if (recorder->used > TRACE_BUFFER_SIZE - TRACE_TEXT_SIZE) {
        end_text(recorder);
    }
    recorder->used += trace_text_format((char *)recorder->buffer + recorder->used, &access);
    recorder->buffer[recorder->used++] = '\n';
    recorder->accesses++;
}

static void text_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    bus_write(recorder->inner, port, value, width);
    put_text(recorder, port, value, width, false);
    bus_fail(bus, recorder->inner->status);
}

static uint16_t text_read(struct bus *bus, uint16_t port, unsigned width) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    uint16_t value = bus_read(recorder->inner, port, width);
    put_text(recorder, port, value, width, true);
    bus_fail(bus, recorder->inner->status);
    return value;
}

static void text_flush(struct bus *bus) {
    struct trace_recorder *recorder = (struct trace_recorder *)bus;
    end_text(recorder);
    flush_out(recorder);
    bus_fail(bus, bus_flush(recorder->inner));
}

static const struct bus_operations text_operations = {text_write, text_read, text_flush};

/* ---- Begin and end -------------------------------------------------------------------------- */

void trace_recorder_init(struct trace_recorder *recorder, struct bus *inner, FILE *file,
                         enum trace_format format, const struct trace_header *header) {
    memset(recorder, 0, sizeof *recorder);
    recorder->bus.status = inner->status;
    recorder->inner = inner;
    recorder->file = file;
    recorder->base = header->base;
    if (format == TRACE_BINARY) {
        recorder->bus.operations = &binary_operations;
        write_header(recorder, header);
        begin_block(recorder);
    } else {
        recorder->bus.operations = &text_operations;
        recorder->used = (uint32_t)snprintf((char *)recorder->buffer, TRACE_BUFFER_SIZE,
                                            "# profile %s, base %04X\n",
                                            board_profile_text(header->profile), header->base);
    }
}

enum bus_status trace_recorder_finish(struct trace_recorder *recorder) {
    if (recorder->bus.operations == &binary_operations) {
        end_block(recorder);
        write_end(recorder);
    } else {
        end_text(recorder);
    }
    flush_out(recorder);
    return recorder->error_number != 0 ? BUS_IO_ERROR : BUS_OK;
}
