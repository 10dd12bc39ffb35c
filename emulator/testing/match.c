/* SPDX-License-Identifier: MIT */
/* Expected writes against those that were made. */
#include "match.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_SIZE = 256, LINE_SHOWN_SIZE = 64, CONTEXT = 5, SHOWN_MOST = 8 };

/* A line of what is expected. */
struct line {
    bool is_gap; /* "...": any number of writes */
    uint16_t port, port_mask, value, value_mask;
    uint8_t width;
    unsigned number; /* in the text, from 1 */
    char text[LINE_SHOWN_SIZE];
};

/* Expected lines, and the writes since the mark. */
struct sides {
    struct line *lines;
    size_t line_count;
    const struct trace_access **writes;
    size_t write_count;
    char *report;
    size_t used; /* of the report */
};

static void add(struct sides *sides, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

static void add(struct sides *sides, const char *format, ...) {
    va_list arguments;
    size_t room = MATCH_REPORT_SIZE - sides->used;
    va_start(arguments, format);
    int length = vsnprintf(sides->report + sides->used, room, format, arguments);
    va_end(arguments);
    sides->used += length < 0 ? 0 : (size_t)length < room ? (size_t)length : room - 1;
}

/* ---- What is expected ----------------------------------------------------------------------- */

/* Returns the mask of a word of hex digits: 0 bits where the word has a ?, which stands for any
 * digit. */
static uint16_t mask_of(const char *word, size_t length) {
    unsigned mask = 0xFFFF;
    for (size_t i = 0; i < length; i++) {
        if (word[i] == '?') {
            mask &= ~(0xFU << 4 * (length - 1 - i));
        }
    }
    return (uint16_t)mask;
}

/* Finds word number 0, 1 or 2 of a line that has so many, and the word's length. */
static const char *word_of(const char *text, int which, size_t *length) {
    static const char blanks[] = " \t\r";
    text += strspn(text, blanks);
    while (which-- > 0) {
        text += strcspn(text, blanks);
        text += strspn(text, blanks);
    }
    *length = strcspn(text, " \t\r#");
    return text;
}

/* Reads one line. On TRACE_LINE_BAD message says why. */
static enum trace_line read_line(const char *text, struct line *line, char *message) {
    char digits[LINE_SIZE];
    struct trace_access access;
    size_t length;
    const char *word = word_of(text, 0, &length);
    line->is_gap = length == 3 && strncmp(word, "...", 3) == 0;
    if (line->is_gap) {
        word += 3 + strspn(word + 3, " \t\r");
        if (*word == '\0' || *word == '#') {
            return TRACE_LINE_ACCESS;
        }
        (void)snprintf(message, TRACE_MESSAGE_SIZE, "more than ...; allowed is a # comment");
        return TRACE_LINE_BAD;
    }
    (void)snprintf(digits, sizeof digits, "%s", text);
    for (char *c = digits; *c != '\0' && *c != '#'; c++) {
        *c = *c == '?' ? '0' : *c;
    }
    enum trace_line kind = trace_text_parse(digits, &access, message);
    if (kind != TRACE_LINE_ACCESS) {
        return kind;
    }
    if (access.is_read) {
        (void)snprintf(message, TRACE_MESSAGE_SIZE, "a read; allowed are out8, out16 and ...");
        return TRACE_LINE_BAD;
    }
    word = word_of(text, 1, &length);
    line->port = access.port;
    line->port_mask = mask_of(word, length);
    word = word_of(text, 2, &length);
    line->value = access.value;
    line->value_mask = mask_of(word, length);
    line->width = access.width;
    return TRACE_LINE_ACCESS;
}

/* Keeps what is shown of a line: the line as it was given, without leading blanks and comment. */
static void show_line(struct line *line, const char *text) {
    size_t length;
    const char *word = word_of(text, 0, &length);
    (void)snprintf(
        line->text, sizeof line->text, "%.*s",
        (int)(strcspn(word, "#") < sizeof line->text ? strcspn(word, "#") : sizeof line->text - 1),
        word);
}

static bool read_expected(struct sides *sides, const char *expected) {
    char text[LINE_SIZE], message[TRACE_MESSAGE_SIZE] = "the line is too long";
    for (unsigned number = 1; *expected != '\0'; number++) {
        size_t length = strcspn(expected, "\n");
        struct line *line = &sides->lines[sides->line_count];
        enum trace_line kind = TRACE_LINE_BAD;
        if (length < sizeof text) {
            memcpy(text, expected, length);
            text[length] = '\0';
            kind = read_line(text, line, message);
        }
        if (kind == TRACE_LINE_BAD) {
            add(sides, "line %u of what is expected: %s\n", number, message);
            return false;
        }
        if (kind == TRACE_LINE_ACCESS) {
            line->number = number;
            show_line(line, text);
            sides->line_count++;
        }
        expected += length + (expected[length] == '\n' ? 1 : 0);
    }
    return true;
}

static size_t count_lines(const char *text) {
    size_t count = 1;
    for (; *text != '\0'; text++) {
        count += *text == '\n' ? 1 : 0;
    }
    return count;
}

bool kit_is_whole(const struct superframe_kit *kit, char *report) {
    if (kit->bus.status != BUS_OK) {
        (void)snprintf(report, KIT_REPORT_SIZE,
                       "nothing has reached the board since access %zu: %s\n", kit->count,
                       kit->bus.status == BUS_IO_ERROR ? "out of memory"
                                                       : bus_status_text(kit->bus.status));
        return false;
    }
    return true;
}

/* Gathers both sides. Returns false, with the report filled, if a side can't be gathered. */
static bool gather(struct sides *sides, const struct superframe_kit *kit, const char *expected,
                   char *report) {
    memset(sides, 0, sizeof *sides);
    sides->report = report;
    report[0] = '\0';
    sides->lines = calloc(count_lines(expected), sizeof *sides->lines);
    sides->writes = calloc(kit->count - kit->mark + 1, sizeof(const struct trace_access *));
    if (!kit_is_whole(kit, report)) {
        return false;
    }
    if (sides->lines == NULL || sides->writes == NULL) {
        add(sides, "out of memory\n");
        return false;
    }
    for (size_t i = kit->mark; i < kit->count; i++) {
        if (!kit->accesses[i].is_read) {
            sides->writes[sides->write_count++] = &kit->accesses[i];
        }
    }
    return read_expected(sides, expected);
}

static void let_go(struct sides *sides) {
    free(sides->lines);
    free((void *)sides->writes);
}

/* ---- In order ------------------------------------------------------------------------------- */

static bool fits(const struct line *line, const struct trace_access *write) {
    return line->width == write->width && (write->port & line->port_mask) == line->port &&
           (write->value & line->value_mask) == line->value;
}

/* Matches as a shell matches *: after a gap that did not work out, one more write goes into the
 * gap. *line and *write tell how far the match got: the first line that found no write, and the
 * write there. */
static bool matches(const struct sides *sides, size_t *line, size_t *write) {
    size_t i = 0, j = 0, gap = SIZE_MAX, after_gap = 0;
    *line = *write = 0;
    while (j < sides->write_count || i < sides->line_count) {
        if (i < sides->line_count && sides->lines[i].is_gap) {
            gap = i++;
            after_gap = j;
        } else if (i < sides->line_count && j < sides->write_count &&
                   fits(&sides->lines[i], sides->writes[j])) {
            i++;
            j++;
        } else if (gap != SIZE_MAX && after_gap < sides->write_count) {
            i = gap + 1;
            j = ++after_gap;
        } else {
            return false;
        }
        if (i > *line || (i == *line && gap == SIZE_MAX)) {
            *line = i;
            *write = j;
        }
    }
    return true;
}

static void add_write(struct sides *sides, const char *mark, size_t number) {
    char text[TRACE_TEXT_SIZE];
    if (number < sides->write_count) {
        (void)trace_text_format(text, sides->writes[number]);
        add(sides, "%s %7zu  %s\n", mark, number + 1, text);
    } else {
        add(sides, "%s          (no more writes)\n", mark);
    }
}

bool match_writes(const struct superframe_kit *kit, const char *expected, char *report) {
    struct sides sides;
    size_t line, write;
    bool does_match = gather(&sides, kit, expected, report);
    if (does_match) {
        does_match = matches(&sides, &line, &write);
        if (!does_match) {
            add(&sides, "the writes differ from what is expected, first at write %zu (of %zu):\n",
                write + 1, sides.write_count);
            for (size_t i = write > CONTEXT ? write - CONTEXT : 0; i < write; i++) {
                add_write(&sides, "        ", i);
            }
            if (line < sides.line_count) {
                add(&sides, "expected line %2u  %s\n", sides.lines[line].number,
                    sides.lines[line].text);
            } else {
                add(&sides, "expected          (no more writes)\n");
            }
            add_write(&sides, "found   ", write);
        }
    }
    let_go(&sides);
    return does_match;
}

/* ---- In any order --------------------------------------------------------------------------- */

static uint64_t key_of(uint16_t port, uint16_t value, uint8_t width) {
    return (uint64_t)port << 24 | (uint64_t)value << 8 | width;
}

static int compare_keys(const void *a, const void *b) {
    uint64_t one = *(const uint64_t *)a, other = *(const uint64_t *)b;
    return one < other ? -1 : one > other;
}

static void add_key(struct sides *sides, const char *mark, uint64_t key) {
    char text[TRACE_TEXT_SIZE];
    const struct trace_access access = {(uint16_t)(key >> 24), (uint16_t)(key >> 8), (uint8_t)key,
                                        false};
    (void)trace_text_format(text, &access);
    add(sides, "%s %s\n", mark, text);
}

/* Walks two sorted lists and reports what only one of them has. */
static bool same_keys(struct sides *sides, const uint64_t *expected, const uint64_t *found) {
    size_t i = 0, j = 0, differences = 0;
    while (i < sides->line_count || j < sides->write_count) {
        bool is_missing =
            j == sides->write_count || (i < sides->line_count && expected[i] < found[j]);
        if (!is_missing && i < sides->line_count && expected[i] == found[j]) {
            i++;
            j++;
            continue;
        }
        if (differences++ < SHOWN_MOST) {
            add_key(sides, is_missing ? "expected, not found:" : "found, not expected:",
                    is_missing ? expected[i] : found[j]);
        }
        i += is_missing ? 1 : 0;
        j += is_missing ? 0 : 1;
    }
    if (differences > SHOWN_MOST) {
        add(sides, "and %zu more\n", differences - SHOWN_MOST);
    }
    return differences == 0;
}

static bool match_sorted(struct sides *sides) {
    uint64_t *expected = calloc(sides->line_count + 1, sizeof *expected);
    uint64_t *found = calloc(sides->write_count + 1, sizeof *found);
    bool does_match = expected != NULL && found != NULL;
    if (!does_match) {
        add(sides, "out of memory\n");
    }
    for (size_t i = 0; i < sides->line_count && does_match; i++) {
        const struct line *line = &sides->lines[i];
        if (line->is_gap || (line->port_mask & line->value_mask) != 0xFFFF) {
            add(sides, "line %u of what is expected: no ? and no ... where the order is free\n",
                line->number);
            does_match = false;
            break;
        }
        expected[i] = key_of(line->port, line->value, line->width);
    }
    for (size_t i = 0; i < sides->write_count && does_match; i++) {
        const struct trace_access *write = sides->writes[i];
        found[i] = key_of(write->port, write->value, write->width);
    }
    if (does_match) {
        qsort(expected, sides->line_count, sizeof *expected, compare_keys);
        qsort(found, sides->write_count, sizeof *found, compare_keys);
        does_match = same_keys(sides, expected, found);
    }
    free(expected);
    free(found);
    return does_match;
}

bool match_writes_any_order(const struct superframe_kit *kit, const char *expected, char *report) {
    struct sides sides;
    bool does_match = gather(&sides, kit, expected, report) && match_sorted(&sides);
    let_go(&sides);
    return does_match;
}
