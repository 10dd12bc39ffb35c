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

/* level: 1 for the page's title. */
void page_heading(const struct report *report, int level, const char *text);

/* As printf; at most PAGE_TEXT_SIZE bytes. */
void page_paragraph(const struct report *report, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/* Cells are parted by '|'. The first row of a table is its head. */
void page_row(const struct report *report, bool is_head, const char *cells);
void page_end_table(const struct report *report);

/* A picture of the report's folder; nothing where it is not there. */
void page_picture(const struct report *report, const char *file, const char *caption);

/* "1/4096", or "none". */
const char *page_threshold(double threshold, char text[32]);

/* "12.5 s", "7 min", "3.1 h"; a dash for NaN. */
const char *page_seconds(double seconds, char text[32]);

/* Arithmetic, depth, and what ends a branch, in words. */
const char *page_setting(const struct measure_setting *setting, char text[96]);

#endif
