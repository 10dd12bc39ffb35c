/* SPDX-License-Identifier: MIT */
/* Reads a trace, binary or text, and names what is wrong with it. */
#include "trace_reader.h"

#include <errno.h>
#include <inttypes.h>
#include <xxhash.h>

enum { LONGEST_LINE = 255 };

static enum trace_status fail_at(struct trace_reader *reader, enum trace_status status,
                                 uint64_t offset, const char *message) {
    reader->error.status = status;
    reader->error.line = 0;
    reader->error.offset = offset;
    snprintf(reader->error.message, sizeof reader->error.message, "%s", message);
    return status;
}

/* Reports that the file could not be read at the next byte. */
static enum trace_status fail_to_read(struct trace_reader *reader) {
    return fail_at(reader, TRACE_IO_ERROR, reader->offset, strerror(errno));
}

static enum trace_status fail_on_line(struct trace_reader *reader, const char *message) {
    fail_at(reader, TRACE_BAD_LINE, reader->offset, message);
    reader->error.line = reader->line;
    return TRACE_BAD_LINE;
}

/* ---- The binary form ------------------------------------------------------------------------ */

/* Reads exactly size bytes, or fails naming what was to be read. */
static bool read_bytes(struct trace_reader *reader, uint8_t *bytes, size_t size, const char *what) {
    size_t got = fread(bytes, 1, size, reader->file);
    reader->offset += got;
    if (got == size) {
        return true;
    }
    if (ferror(reader->file)) {
        (void)fail_to_read(reader);
    } else {
        char message[TRACE_MESSAGE_SIZE];
        snprintf(message, sizeof message,
                 "the trace is truncated: the file ends in %s, after %" PRIu64 " whole accesses",
                 what, reader->accesses);
        fail_at(reader, TRACE_TRUNCATED, reader->offset, message);
    }
    return false;
}

static enum trace_status read_header(struct trace_reader *reader) {
    uint8_t bytes[TRACE_HEADER_SIZE];
    if (!read_bytes(reader, bytes, TRACE_HEADER_SIZE, "the header")) {
        return reader->error.status;
    }
    if (memcmp(bytes, trace_magic, TRACE_MAGIC_SIZE) != 0) {
        return fail_at(reader, TRACE_NOT_TRACE, 0,
                       "this is no trace: a binary one begins with 89 53 46 54 0D 0A 1A 0A");
    }
    reader->checksum = XXH3_64bits(bytes, TRACE_HEADER_SIZE - TRACE_CHECKSUM_SIZE);
    if (trace_get(bytes + 16, TRACE_CHECKSUM_SIZE) != reader->checksum) {
        return fail_at(reader, TRACE_CORRUPT, 0, "the header is corrupt: its checksum is wrong");
    }
    uint64_t version = trace_get(bytes + 8, 2);
    if (version != TRACE_VERSION) {
        char message[TRACE_MESSAGE_SIZE];
        snprintf(message, sizeof message,
                 "the trace has version %" PRIu64 " of the format; this program reads version 1",
                 version);
        return fail_at(reader, TRACE_LATER_VERSION, 8, message);
    }
    if (bytes[10] >= BOARD_PROFILES) {
        return fail_at(reader, TRACE_CORRUPT, 10,
                       "unknown profile; allowed are 0 (1987) and 1 (later)");
    }
    reader->header.profile = (enum board_profile)bytes[10];
    reader->header.base = (uint16_t)trace_get(bytes + 12, 2);
    reader->has_header = true;
    return TRACE_OK;
}

/* Reads and checks what follows the last block: the count, the checksum, and the end of the
 * file. */
static enum trace_status read_end(struct trace_reader *reader) {
    uint8_t bytes[TRACE_END_SIZE + TRACE_CHECKSUM_SIZE] = {0};
    if (!read_bytes(reader, bytes + 8, sizeof bytes - 8, "the trailer")) {
        return reader->error.status;
    }
    uint64_t checksum = XXH3_64bits_withSeed(bytes, TRACE_END_SIZE, reader->checksum);
    if (trace_get(bytes + TRACE_END_SIZE, TRACE_CHECKSUM_SIZE) != checksum) {
        return fail_at(reader, TRACE_CORRUPT, reader->block_offset,
                       "the trailer is corrupt: its checksum is wrong");
    }
    if (trace_get(bytes + 8, 8) != reader->accesses) {
        return fail_at(reader, TRACE_CORRUPT, reader->block_offset + 8,
                       "the trailer counts another number of accesses than the trace has");
    }
    if (getc(reader->file) != EOF) {
        return fail_at(reader, TRACE_CORRUPT, reader->offset, "bytes follow the end of the trace");
    }
    if (ferror(reader->file)) {
        return fail_to_read(reader);
    }
    reader->error.status = TRACE_END;
    return TRACE_END;
}

/* Reads and checks the next block. Returns TRACE_END if there is none. */
static enum trace_status read_block(struct trace_reader *reader) {
    uint8_t checksum[TRACE_CHECKSUM_SIZE];
    reader->block_offset = reader->offset;
    if (!read_bytes(reader, reader->block, TRACE_BLOCK_HEADER_SIZE, "a block's header")) {
        return reader->error.status;
    }
    reader->size = (uint32_t)trace_get(reader->block, 4);
    reader->block_accesses = (uint32_t)trace_get(reader->block + 4, 4);
    if (reader->size == 0 && reader->block_accesses == 0) {
        return read_end(reader);
    }
    /* Four accesses take a byte at least. */
    if (reader->size > TRACE_PAYLOAD_LIMIT || reader->block_accesses == 0 ||
        reader->block_accesses > (uint64_t)reader->size * 4) {
        return fail_at(reader, TRACE_CORRUPT, reader->block_offset,
                       "the block's header is corrupt: its lengths are out of range");
    }
    if (!read_bytes(reader, reader->block + TRACE_BLOCK_HEADER_SIZE, reader->size, "a block") ||
        !read_bytes(reader, checksum, TRACE_CHECKSUM_SIZE, "a block's checksum")) {
        return reader->error.status;
    }
    reader->checksum = XXH3_64bits_withSeed(
        reader->block, TRACE_BLOCK_HEADER_SIZE + (size_t)reader->size, reader->checksum);
    if (trace_get(checksum, TRACE_CHECKSUM_SIZE) != reader->checksum) {
        return fail_at(reader, TRACE_CORRUPT, reader->block_offset,
                       "the block is corrupt: its checksum is wrong");
    }
    reader->used = 0;
    reader->block_done = 0;
    trace_model_reset(&reader->model);
    return TRACE_OK;
}

/* Takes the next bytes of the payload. Returns NULL if the payload has fewer. */
static const uint8_t *take(struct trace_reader *reader, uint32_t count) {
    if (count > reader->size - reader->used) {
        return NULL;
    }
    const uint8_t *bytes = reader->block + TRACE_BLOCK_HEADER_SIZE + reader->used;
    reader->used += count;
    return bytes;
}

static bool take_value(struct trace_reader *reader, struct trace_access *access) {
    const uint8_t *bytes = take(reader, access->width);
    if (bytes != NULL) {
        access->value = (uint16_t)trace_get(bytes, access->width);
    }
    return bytes != NULL;
}

static bool take_foreign(struct trace_reader *reader, struct trace_access *access) {
    const uint8_t *bytes = take(reader, 3);
    if (bytes == NULL || bytes[0] > (TRACE_FLAG_READ | TRACE_FLAG_WORD)) {
        return false;
    }
    access->is_read = (bytes[0] & TRACE_FLAG_READ) != 0;
    access->width = (bytes[0] & TRACE_FLAG_WORD) != 0 ? 2 : 1;
    access->port = (uint16_t)trace_get(bytes + 1, 2);
    return take_value(reader, access);
}

/* Decodes one access. Returns false if no recorder can have written the payload. */
static bool decode(struct trace_reader *reader, struct trace_access *access) {
    struct trace_model *model = &reader->model;
    unsigned slot = model->next[model->previous];
    if (reader->block_done % 4 == 0) {
        const uint8_t *control = take(reader, 1);
        if (control == NULL) {
            return false;
        }
        reader->control = *control;
    }
    unsigned code = (unsigned)reader->control >> (2 * (reader->block_done % 4)) & 3;
    if (code == TRACE_CODE_FOREIGN) {
        return take_foreign(reader, access);
    }
    if (code == TRACE_CODE_KIND) {
        const uint8_t *kind = take(reader, 1);
        if (kind == NULL || *kind >= TRACE_SLOTS) {
            return false;
        }
        slot = *kind;
    }
    access->port = (uint16_t)(reader->header.base + slot / 4);
    access->width = (uint8_t)((slot >> 1 & 1) + 1);
    access->is_read = (slot & 1) != 0;
    access->value = model->predicted[slot];
    if (code != TRACE_CODE_EXPECTED && !take_value(reader, access)) {
        return false;
    }
    trace_model_update(model, slot, access->value);
    return true;
}

static enum trace_status next_binary(struct trace_reader *reader, struct trace_access *access) {
    if (reader->block_done == reader->block_accesses) {
        enum trace_status status = read_block(reader);
        if (status != TRACE_OK) {
            return status;
        }
    }
    if (!decode(reader, access)) {
        return fail_at(reader, TRACE_CORRUPT,
                       reader->block_offset + TRACE_BLOCK_HEADER_SIZE + reader->used,
                       "the block is malformed: its bytes don't make accesses");
    }
    reader->block_done++;
    if (reader->block_done == reader->block_accesses && reader->used != reader->size) {
        return fail_at(reader, TRACE_CORRUPT,
                       reader->block_offset + TRACE_BLOCK_HEADER_SIZE + reader->used,
                       "the block is malformed: bytes follow its last access");
    }
    reader->accesses++;
    return TRACE_OK;
}

/* ---- The text form -------------------------------------------------------------------------- */

/* Reads a line without its end. Returns TRACE_END if there is no line. The last line may have no
 * end, but a line that was cut off by a read error is none. */
static enum trace_status read_line(struct trace_reader *reader, char line[LONGEST_LINE + 1]) {
    unsigned length = 0;
    int c;
    reader->line++;
    while ((c = getc(reader->file)) != EOF && c != '\n') {
        reader->offset++;
        if (c == '\0') {
            return fail_on_line(reader, "a zero byte; allowed is plain text");
        }
        if (length == LONGEST_LINE) {
            return fail_on_line(reader, "the line is too long; allowed are 255 bytes");
        }
        line[length++] = (char)c;
    }
    if (c == EOF && ferror(reader->file)) {
        return fail_to_read(reader);
    }
    if (c == EOF && length == 0) {
        reader->error.status = TRACE_END;
        return TRACE_END;
    }
    reader->offset += c == '\n';
    line[length] = '\0';
    return TRACE_OK;
}

static enum trace_status next_text(struct trace_reader *reader, struct trace_access *access) {
    char line[LONGEST_LINE + 1];
    char message[TRACE_MESSAGE_SIZE];
    for (;;) {
        enum trace_status status = read_line(reader, line);
        if (status != TRACE_OK) {
            return status;
        }
        switch (trace_text_parse(line, access, message)) {
        case TRACE_LINE_ACCESS:
            reader->accesses++;
            return TRACE_OK;
        case TRACE_LINE_EMPTY:
            break;
        case TRACE_LINE_BAD:
            return fail_on_line(reader, message);
        }
    }
}

/* ---- Either --------------------------------------------------------------------------------- */

enum trace_status trace_reader_open(struct trace_reader *reader, FILE *file) {
    memset(reader, 0, sizeof *reader);
    reader->file = file;
    int first = getc(file);
    if (first == EOF) {
        return ferror(file)
                   ? fail_to_read(reader)
                   : fail_at(reader, TRACE_NOT_TRACE, 0,
                             "the file is empty; allowed are a binary trace or lines of text");
    }
    ungetc(first, file);
    reader->format = first == trace_magic[0] ? TRACE_BINARY : TRACE_TEXT;
    return reader->format == TRACE_BINARY ? read_header(reader) : TRACE_OK;
}

enum trace_status trace_reader_require(struct trace_reader *reader,
                                       const struct trace_header *header) {
    char message[TRACE_MESSAGE_SIZE];
    if (!reader->has_header) {
        return reader->error.status;
    }
    if (reader->header.profile != header->profile) {
        snprintf(message, sizeof message, "the trace was recorded for profile %s, not %s",
                 board_profile_text(reader->header.profile), board_profile_text(header->profile));
        return fail_at(reader, TRACE_WRONG_PROFILE, 10, message);
    }
    if (reader->header.base != header->base) {
        snprintf(message, sizeof message, "the trace was recorded at base %04X, not %04X",
                 reader->header.base, header->base);
        return fail_at(reader, TRACE_WRONG_BASE, 12, message);
    }
    return TRACE_OK;
}

enum trace_status trace_reader_next(struct trace_reader *reader, struct trace_access *access) {
    if (reader->error.status != TRACE_OK) {
        return reader->error.status;
    }
    return reader->format == TRACE_BINARY ? next_binary(reader, access) : next_text(reader, access);
}
