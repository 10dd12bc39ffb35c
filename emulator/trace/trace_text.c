/* SPDX-License-Identifier: MIT */
/* The plain-text form of a trace: one access a line. */
#include "trace.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    uint8_t width;
    bool is_read;
} operations[] = {{"out8", 1, false}, {"out16", 2, false}, {"in8", 1, true}, {"in16", 2, true}};

enum { OPERATIONS = sizeof operations / sizeof operations[0] };

int trace_error_format(char *text, size_t size, const char *name, const struct trace_error *error) {
    if (error->line != 0) {
        return snprintf(text, size, "%s:%" PRIu64 ": %s", name, error->line, error->message);
    }
    return snprintf(text, size, "%s: byte %" PRIu64 ": %s", name, error->offset, error->message);
}

bool trace_access_equal(const struct trace_access *a, const struct trace_access *b) {
    return a->port == b->port && a->value == b->value && a->width == b->width &&
           a->is_read == b->is_read;
}

/* ---- Writing -------------------------------------------------------------------------------- */

static char *put_hex(char *text, unsigned value, unsigned digits) {
    for (unsigned i = digits; i-- > 0;) {
        *text++ = "0123456789ABCDEF"[value >> (4 * i) & 15];
    }
    return text;
}

unsigned trace_text_format(char text[TRACE_TEXT_SIZE], const struct trace_access *access) {
    unsigned operation = (access->is_read ? 2U : 0U) + access->width - 1U;
    size_t length = strlen(operations[operation].name);
    char *end = text + length;
    memcpy(text, operations[operation].name, length);
    *end++ = ' ';
    end = put_hex(end, access->port, 4);
    *end++ = ' ';
    end = put_hex(end, access->value, access->width * 2U);
    *end = '\0';
    return (unsigned)(end - text);
}

/* ---- Reading -------------------------------------------------------------------------------- */

static bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

static bool is_word_end(char c) {
    return c == '\0' || c == '#' || is_space(c);
}

static const char *skip_space(const char *text) {
    while (is_space(*text)) {
        text++;
    }
    return text;
}

/* Returns the value of a hex digit, 16 if the character is none. */
static unsigned hex_digit(char c) {
    if (c >= '0' && c <= '9') {
        return (unsigned)(c - '0');
    }
    if (c >= 'A' && c <= 'F') {
        return (unsigned)(c - 'A') + 10;
    }
    if (c >= 'a' && c <= 'f') {
        return (unsigned)(c - 'a') + 10;
    }
    return 16;
}

/* Reads 1..digits hex digits and the end of the word. Returns where the next word begins, NULL if
 * there is something else. */
static const char *parse_hex(const char *text, unsigned digits, uint16_t *value) {
    unsigned count = 0;
    unsigned number = 0;
    while (hex_digit(*text) < 16 && count <= digits) {
        number = number << 4 | hex_digit(*text++);
        count++;
    }
    if (count == 0 || count > digits || !is_word_end(*text)) {
        return NULL;
    }
    *value = (uint16_t)number;
    return skip_space(text);
}

/* Tells whether a word is an operation's name, whatever the case. */
static bool is_operation(const char *word, size_t length, const char *name) {
    if (length != strlen(name)) {
        return false;
    }
    for (size_t i = 0; i < length; i++) {
        char c = word[i] >= 'A' && word[i] <= 'Z' ? (char)(word[i] - 'A' + 'a') : word[i];
        if (c != name[i]) {
            return false;
        }
    }
    return true;
}

static enum trace_line bad_line(char *message, const char *reason) {
    snprintf(message, TRACE_MESSAGE_SIZE, "%s", reason);
    return TRACE_LINE_BAD;
}

enum trace_line trace_text_parse(const char *line, struct trace_access *access, char *message) {
    const char *text = skip_space(line);
    size_t length = 0;
    unsigned operation = 0;
    if (*text == '\0' || *text == '#') {
        return TRACE_LINE_EMPTY;
    }
    while (!is_word_end(text[length])) {
        length++;
    }
    while (operation < OPERATIONS && !is_operation(text, length, operations[operation].name)) {
        operation++;
    }
    if (operation == OPERATIONS) {
        return bad_line(message,
                        "unknown operation; allowed are out8, out16, in8, in16 and # comments");
    }
    access->width = operations[operation].width;
    access->is_read = operations[operation].is_read;
    text = parse_hex(skip_space(text + length), 4, &access->port);
    if (text == NULL) {
        return bad_line(message, "bad port; allowed are 1 to 4 hex digits");
    }
    text = parse_hex(text, access->width * 2U, &access->value);
    if (text == NULL) {
        return bad_line(message, access->width == 1 ? "bad value; allowed are 1 or 2 hex digits"
                                                    : "bad value; allowed are 1 to 4 hex digits");
    }
    if (*text != '\0' && *text != '#') {
        return bad_line(message, "more than a port and a value; allowed is a # comment");
    }
    return TRACE_LINE_ACCESS;
}
