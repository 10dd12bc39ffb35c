/* SPDX-License-Identifier: MIT */
/* A page that is written twice, as Markdown and as HTML: headings, tables, pictures, numbers as
 * text. */
#include "lab/measure/page.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/path.h"

void page_begin(const struct report *report, const char *title) {
    if (report->is_html) {
        (void)fprintf(report->file,
                      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                      "<title>%s</title>\n<style>body{font-family:sans-serif;max-width:60em;"
                      "margin:2em auto;padding:0 1em;line-height:1.4}td,th{border:1px solid #999;"
                      "padding:.2em .5em;text-align:left}table{border-collapse:collapse}"
                      "img{max-width:100%%}figure{margin:1.5em 0}figcaption{color:#555}"
                      "</style></head><body>\n",
                      title);
    }
    page_heading(report, 1, title);
}

void page_end(const struct report *report) {
    if (report->is_html) {
        (void)fputs("</body></html>\n", report->file);
    }
}

void page_heading(const struct report *report, int level, const char *text) {
    if (report->is_html) {
        (void)fprintf(report->file, "<h%d>%s</h%d>\n", level, text, level);
    } else {
        (void)fprintf(report->file, "%.*s %s\n\n", level, "###", text);
    }
}

void page_paragraph(const struct report *report, const char *format, ...) {
    char text[PAGE_TEXT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (report->is_html) {
        (void)fprintf(report->file, "<p>%s</p>\n", text);
    } else {
        (void)fprintf(report->file, "%s\n\n", text);
    }
}

void page_row(const struct report *report, bool is_head, const char *cells) {
    const char *tag = is_head ? "th" : "td";
    if (!report->is_html) {
        (void)fprintf(report->file, "| %s |\n", cells);
        for (const char *c = cells; is_head && *c != '\0'; c++) {
            (void)fputs(c == cells ? "|---|" : *c == '|' ? "---|" : "", report->file);
        }
        (void)fputs(is_head ? "\n" : "", report->file);
        return;
    }
    (void)fprintf(report->file, "%s<tr><%s>", is_head ? "<table>\n" : "", tag);
    for (; *cells != '\0'; cells++) {
        if (*cells == '|') {
            (void)fprintf(report->file, "</%s><%s>", tag, tag);
        } else {
            (void)fputc(*cells, report->file);
        }
    }
    (void)fprintf(report->file, "</%s></tr>\n", tag);
}

void page_end_table(const struct report *report) {
    (void)fputs(report->is_html ? "</table>\n" : "\n", report->file);
}

void page_picture(const struct report *report, const char *file, const char *caption) {
    char *path = path_join(report->measure->folder, file);
    bool is_there = path != NULL && access(path, R_OK) == 0;
    free(path);
    if (!is_there) {
        return;
    }
    if (report->is_html) {
        (void)fprintf(report->file,
                      "<figure><img src=\"%s\" alt=\"%s\"><figcaption>%s</figcaption></figure>\n",
                      file, caption, caption);
    } else {
        (void)fprintf(report->file, "![%s](%s)\n\n%s\n\n", caption, file, caption);
    }
}

const char *page_threshold(double threshold, char text[32]) {
    if (!(threshold > 0)) {
        return "none";
    }
    double inverse = 1 / threshold;
    (void)snprintf(text, 32, "1/%.*f", fabs(inverse - round(inverse)) < 1e-6 ? 0 : 3, inverse);
    return text;
}

const char *page_seconds(double seconds, char text[32]) {
    if (isnan(seconds)) {
        return "–";
    }
    if (seconds < 120) {
        (void)snprintf(text, 32, "%.3g s", seconds);
    } else if (seconds < 7200) {
        (void)snprintf(text, 32, "%.0f min", seconds / 60);
    } else {
        (void)snprintf(text, 32, "%.1f h", seconds / 3600);
    }
    return text;
}

const char *page_setting(const struct measure_setting *setting, char text[96]) {
    char threshold[32];
    if (setting->error > 0) {
        (void)snprintf(text, 96, "%s, --error %g, N up to %u", setting->arithmetic, setting->error,
                       setting->depth);
    } else {
        (void)snprintf(text, 96, "%s, N = %u, threshold %s, tail %s", setting->arithmetic,
                       setting->depth, page_threshold(setting->threshold, threshold),
                       setting->tail);
    }
    return text;
}
