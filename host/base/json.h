/* SPDX-License-Identifier: MIT */
/* JSON as it is written: objects and lists, one entry a line, indented. */
#ifndef SUPERFRAME_JSON_H
#define SUPERFRAME_JSON_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* A value that is being written. All zero but `out`: nothing was written yet. */
struct json {
    FILE *out;
    unsigned depth; /* objects and lists that are open */
    bool has_entry; /* the innermost has an entry: the next one needs a comma */
};

/* The following write an entry of the innermost object or list. key: in an object; NULL: in a list,
 * or for the whole value. */

/* Begins an object, or a list; json_end() with the same kind of bracket ends it. */
void json_begin_object(struct json *json, const char *key);
void json_begin_list(struct json *json, const char *key);

/* Ends the innermost object or list; after the outermost the line ends, too. */
void json_end_object(struct json *json);
void json_end_list(struct json *json);

/* Writes a text; NULL becomes null. UTF-8 goes out as it is; each byte that is no part of a
 * character becomes \ufffd. */
void json_text(struct json *json, const char *key, const char *text);

void json_count(struct json *json, const char *key, uint64_t count);
void json_flag(struct json *json, const char *key, bool flag);

/* Writes a value in base 16 as a text, with zeros before it up to so many digits. */
void json_hexadecimal(struct json *json, const char *key, uint64_t value, int digits);

/* Writes a number that reads back as it is; an infinity or a NaN becomes null. */
void json_real(struct json *json, const char *key, double number);

/* Writes a number rounded to so many digits; an infinity or a NaN becomes null. */
void json_rounded(struct json *json, const char *key, double number, int digits);

/* Writes a number with so many digits behind the point; an infinity or a NaN becomes null. */
void json_decimal(struct json *json, const char *key, double number, int places);

#endif
