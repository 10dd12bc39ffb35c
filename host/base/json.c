/* SPDX-License-Identifier: MIT */
/* JSON as it is written. */
#include "base/json.h"

#include <inttypes.h>
#include <math.h>

/* Returns the number of bytes of the UTF-8 character that the text begins with; 0: the text begins
 * with none. */
static size_t utf8_length(const char *text) {
    /* Kinds of characters by their first byte, with the range of the second one (RFC 3629).
     * Surrogates, what is beyond 10FFFF, and what fewer bytes could say are left out. */
    static const struct {
        unsigned char first, last, low, high;
        size_t length;
    } kinds[] = {
        {0x01, 0x7F, 0, 0xFF, 1},    {0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3},
        {0xE1, 0xEC, 0x80, 0xBF, 3}, {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3},
        {0xF0, 0xF0, 0x90, 0xBF, 4}, {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4}};
    const unsigned char *bytes = (const unsigned char *)text;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (bytes[0] < kinds[i].first || bytes[0] > kinds[i].last) {
            continue;
        }
        bool is_whole = bytes[1] >= kinds[i].low && bytes[1] <= kinds[i].high;
        for (size_t j = 2; j < kinds[i].length && is_whole; j++) {
            is_whole = bytes[j] >= 0x80 && bytes[j] <= 0xBF; /* no NUL, so none beyond the end */
        }
        return is_whole ? kinds[i].length : 0;
    }
    return 0;
}

/* Writes a text in JSON's quotes and escapes. */
static void write_string(FILE *out, const char *text) {
    (void)fputc('"', out);
    while (*text != '\0') {
        size_t length = utf8_length(text);
        unsigned letter = (unsigned char)*text;
        if (length == 0) {
            (void)fputs("\\ufffd", out); /* U+FFFD marks what is no character */
        } else if (letter < 0x20 || letter == '"' || letter == '\\') {
            (void)fprintf(out, "\\u%04x", letter);
        } else {
            (void)fwrite(text, 1, length, out);
        }
        text += length > 0 ? length : 1;
    }
    (void)fputc('"', out);
}

/* Begins an entry: the comma after the one before it, a line of its own, its key. */
static void begin_entry(struct json *json, const char *key) {
    if (json->has_entry) {
        (void)fputc(',', json->out);
    }
    if (json->depth > 0) {
        (void)fprintf(json->out, "\n%*s", (int)(2 * json->depth), "");
    }
    if (key != NULL) {
        write_string(json->out, key);
        (void)fputs(": ", json->out);
    }
    json->has_entry = true;
}

static void begin(struct json *json, const char *key, char bracket) {
    begin_entry(json, key);
    (void)fputc(bracket, json->out);
    json->depth++;
    json->has_entry = false;
}

static void end(struct json *json, char bracket) {
    json->depth--;
    if (json->has_entry) {
        (void)fprintf(json->out, "\n%*s", (int)(2 * json->depth), "");
    }
    (void)fputc(bracket, json->out);
    json->has_entry = true;
    if (json->depth == 0) {
        (void)fputc('\n', json->out);
    }
}

void json_begin_object(struct json *json, const char *key) {
    begin(json, key, '{');
}

void json_begin_list(struct json *json, const char *key) {
    begin(json, key, '[');
}

void json_end_object(struct json *json) {
    end(json, '}');
}

void json_end_list(struct json *json) {
    end(json, ']');
}

void json_count(struct json *json, const char *key, uint64_t count) {
    begin_entry(json, key);
    (void)fprintf(json->out, "%" PRIu64, count);
}

void json_flag(struct json *json, const char *key, bool flag) {
    begin_entry(json, key);
    (void)fputs(flag ? "true" : "false", json->out);
}

void json_hexadecimal(struct json *json, const char *key, uint64_t value, int digits) {
    begin_entry(json, key);
    (void)fprintf(json->out, "\"%0*" PRIx64 "\"", digits, value);
}

void json_real(struct json *json, const char *key, double number) {
    json_rounded(json, key, number, 17);
}

void json_rounded(struct json *json, const char *key, double number, int digits) {
    begin_entry(json, key);
    (void)fprintf(json->out, isfinite(number) ? "%.*g" : "null", digits, number);
}

void json_decimal(struct json *json, const char *key, double number, int places) {
    begin_entry(json, key);
    (void)fprintf(json->out, isfinite(number) ? "%.*f" : "null", places, number);
}

void json_text(struct json *json, const char *key, const char *text) {
    begin_entry(json, key);
    if (text != NULL) {
        write_string(json->out, text);
    } else {
        (void)fputs("null", json->out);
    }
}
