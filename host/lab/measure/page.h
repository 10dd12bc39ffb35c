/* SPDX-License-Identifier: MIT */
/* A page that is written twice, as Markdown and as HTML: headings, tables, pictures, numbers as
 * text. */
#ifndef SUPERFRAME_MEASURE_PAGE_H
#define SUPERFRAME_MEASURE_PAGE_H

#include <stdbool.h>
#include <stdio.h>

#include "lab/measure/measure.h"

/* What the page is about, and where it goes. */
struct report {
    const struct measure *measure;
    const struct measure_settings *settings;
    FILE *file;
    bool is_html;
};

enum { PAGE_TEXT_SIZE = 2048 };

void page_begin(const struct report *report, const char *title);
void page_end(const struct report *report);

/* Writes a heading. level: 1..3; 1 is the page's title. */
void page_heading(const struct report *report, int level, const char *text);

/* Writes a paragraph, formatted as by printf(); at most PAGE_TEXT_SIZE bytes. */
void page_paragraph(const struct report *report, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* Writes a row of a table, with cells parted by '|'. The first row of a table is its head. */
void page_row(const struct report *report, bool is_head, const char *cells);
void page_end_table(const struct report *report);

/* Writes a picture of the report's folder with its caption; nothing where the file is missing. */
void page_picture(const struct report *report, const char *file, const char *caption);

/* Returns a threshold as "1/4096", or "none". */
const char *page_threshold(double threshold, char text[32]);

/* Returns a time as "12.5 s", "7 min" or "3.1 h"; NaN as a dash. */
const char *page_seconds(double seconds, char text[32]);

/* Returns a setting in words: arithmetic, depth, and what ends a branch. */
const char *page_setting(const struct measure_setting *setting, char text[96]);

#endif
