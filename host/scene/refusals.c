/* SPDX-License-Identifier: MIT */
/* Records what is wrong with a scene file while the file is read, and writes it in its order. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "scene/reader_internal.h"

enum { INDENT = 4, SHOWN_MOST = 92, SHOWN_BEFORE = 60 };

bool scene_fail(struct scene_reader *reader, struct scene_place at, const char *format, ...) {
    if (reader->refusal_count++ < SCENE_REFUSALS_MOST) {
        struct scene_refusal *refusal = &reader->refusals[reader->refusal_count - 1];
        va_list arguments;
        va_start(arguments, format);
        (void)vsnprintf(refusal->text, sizeof refusal->text, format, arguments);
        va_end(arguments);
        refusal->at = at;
    }
    return false;
}

/* Tells whether a refusal stands before another one, in the file's order. */
static bool is_before(const struct scene_refusal *one, const struct scene_refusal *other) {
    return one->at.line < other->at.line ||
           (one->at.line == other->at.line && one->at.column < other->at.column);
}

/* Appends to a text, as far as there is room. Control characters of the file become '?', so that a
 * line stays one line. */
static size_t append(char *text, size_t used, size_t size, const char *piece, size_t length) {
    for (size_t i = 0; i < length && used + 1 < size; i++) {
        const bool is_control = (unsigned char)piece[i] < 0x20 || piece[i] == 0x7F;
        text[used++] = piece[i] == '\t' ? ' ' : is_control ? '?' : piece[i];
    }
    text[used] = '\0';
    return used;
}

/* Appends the file's line with a mark under the column. Of a long line the part round the mark is
 * shown. A byte that goes on with a letter of UTF-8 takes no column. */
static size_t show_place(char *text, size_t used, size_t size, const char *file,
                         struct scene_place at) {
    for (unsigned line = 1; line < at.line; line++) {
        const char *end = strchr(file, '\n');
        if (end == NULL) {
            return used;
        }
        file = end + 1;
    }
    size_t length = strcspn(file, "\r\n"), column = at.column - 1;
    if (column > length || used + 2 * (INDENT + SHOWN_MOST) + 4 > size) {
        return used;
    }
    size_t first = column > SHOWN_BEFORE && length > SHOWN_MOST ? column - SHOWN_BEFORE : 0;
    used += (size_t)sprintf(text + used, "\n%*s", INDENT, "");
    used = append(text, used, size, file + first,
                  length - first < SHOWN_MOST ? length - first : SHOWN_MOST);
    used += (size_t)sprintf(text + used, "\n%*s", INDENT, "");
    for (size_t i = first; i < column; i++) {
        if (((unsigned char)file[i] & 0xC0) != 0x80) {
            text[used++] = ' ';
        }
    }
    text[used++] = '^';
    text[used] = '\0';
    return used;
}

void scene_report(const struct scene_reader *reader, const char *text, struct scene_error *error) {
    const struct scene_refusal *sorted[SCENE_REFUSALS_MOST];
    const size_t size = sizeof error->text;
    size_t count = 0, used = 0;
    for (size_t i = 0; i < reader->refusal_count && i < SCENE_REFUSALS_MOST; i++) {
        size_t at = count++;
        for (; at > 0 && is_before(&reader->refusals[i], sorted[at - 1]); at--) {
            sorted[at] = sorted[at - 1];
        }
        sorted[at] = &reader->refusals[i];
    }
    for (size_t i = 0; i < count; i++) {
        const struct scene_place at = sorted[i]->at;
        char place[256];
        int length = at.line == 0 ? snprintf(place, sizeof place, "%.200s: ", reader->path)
                                  : snprintf(place, sizeof place, "%.200s:%u:%u: ", reader->path,
                                             at.line, at.column);
        if (i > 0 && used + 1 < size) {
            error->text[used++] = '\n';
        }
        used = append(error->text, used, size, place, (size_t)length);
        used = append(error->text, used, size, sorted[i]->text, strlen(sorted[i]->text));
        if (at.line > 0) {
            used = show_place(error->text, used, size, text, at);
        }
    }
}
