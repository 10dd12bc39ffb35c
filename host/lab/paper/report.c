/* SPDX-License-Identifier: MIT */
/* The paper's claims beside what was measured: claims.md, and index.html with the figures. */
#include <string.h>

#include "base/complain.h"
#include "lab/paper/paper.h"

/* Stands for a letter that means something else in a format. The list ends with no letter. */
struct escape {
    char letter;
    const char *stands;
};

static const struct escape html[] = {
    {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\0', NULL}};
static const struct escape markdown[] = {
    {'|', "\\|"}, {'<', "&lt;"}, {'*', "\\*"}, {'^', "\\^"}, {'\0', NULL}};

static void put(FILE *file, const char *text, const struct escape *escapes) {
    for (; *text != '\0'; text++) {
        const struct escape *found = escapes;
        while (found->letter != '\0' && found->letter != *text) {
            found++;
        }
        if (found->letter != '\0') {
            (void)fputs(found->stands, file);
        } else {
            (void)fputc(*text, file);
        }
    }
}

/* ---- Markdown ------------------------------------------------------------------------------- */

static int write_markdown(const struct paper *paper) {
    FILE *file = paper_create(paper, "claims.md");
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fprintf(file, "Made by `superframe paper`, arithmetic %s.\n\n",
                  paper->arithmetic->image->name);
    (void)fputs("| | claim | what the paper says | what was measured | holds | why |\n"
                "|---|---|---|---|---|---|\n",
                file);
    for (int i = 0; i < PAPER_CLAIMS; i++) {
        const struct paper_claim *claim = &paper->claims[i];
        (void)fprintf(file, "| %d | ", i + 1);
        put(file, claim->title, markdown);
        (void)fputs(" | ", file);
        put(file, claim->says, markdown);
        (void)fputs(" | ", file);
        put(file, claim->measured, markdown);
        (void)fprintf(file, " | **%s** | ", paper_verdict_text(claim->verdict));
        put(file, claim->why, markdown);
        (void)fputs(" |\n", file);
    }
    return paper_close(file, "claims.md");
}

/* ---- HTML ----------------------------------------------------------------------------------- */

static const char html_head[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n"
    "<title>The figures of the paper, and its claims</title>\n<style>\n"
    "body { font-family: sans-serif; margin: 2em; max-width: 90em; }\n"
    "figure { display: inline-block; width: 640px; max-width: 100%; margin: 0 1em 2em 0; "
    "vertical-align: top; }\n"
    "figure.wide { width: 1000px; }\n"
    "img { max-width: 100%; }\n"
    "table { border-collapse: collapse; }\n"
    "td, th { border: 1px solid #999; padding: 0.4em; text-align: left; vertical-align: top; }\n"
    "</style>\n</head>\n<body>\n"
    "<h1>The figures of the paper, and its claims</h1>\n"
    "<p>M. Iizuka, Y. Ohe: Visual Appearance of Color and Image Quality of Computer-Generated 3-D "
    "Transparent Objects, 1988. Made by <code>superframe paper</code>, arithmetic ";

static void put_figure(FILE *file, const char *type, const char *name, const char *label,
                       const char *caption) {
    (void)fprintf(file, "<figure%s><img src=\"%s.png\" alt=\"", type, name);
    put(file, label, html);
    (void)fputs("\"><figcaption><b>", file);
    put(file, label, html);
    (void)fputs("</b> ", file);
    put(file, caption, html);
    (void)fputs("</figcaption></figure>\n", file);
}

static void put_figures(FILE *file, const struct paper *paper) {
    (void)fputs(".</p>\n<h2>Figures</h2>\n", file);
    for (int i = 0; paper_figures[i].file != NULL; i++) {
        const struct paper_figure *figure = &paper_figures[i];
        if (paper->figures[i] != NULL) {
            put_figure(file, "", figure->file, figure->label, figure->caption);
        } else {
            (void)fprintf(file, "<p>%s: the scene %s is not built in.</p>\n", figure->label,
                          figure->shot.scene);
        }
    }
    if (paper->has_plots) {
        put_figure(file, " class=\"wide\"", "fig7-rays", "Fig. 7, in rays",
                   "Points: measured. Lines: reading (i); dashed: reading (ii).");
        put_figure(file, " class=\"wide\"", "fig7-tests", "Fig. 7, in solid tests",
                   "A solid test is a ray against a primitive.");
    } else {
        (void)fputs("<p>Fig. 7: gnuplot was not there; it draws fig7.gp.</p>\n", file);
    }
    put_figure(file, " class=\"wide\"", "contact-sheet", "Contact sheet",
               "All figures at half their size, in the order above.");
}

static void put_cell(FILE *file, const char *text) {
    (void)fputs("<td>", file);
    put(file, text, html);
    (void)fputs("</td>", file);
}

static int write_html(const struct paper *paper) {
    FILE *file = paper_create(paper, "index.html");
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fputs(html_head, file);
    (void)fputs(paper->arithmetic->image->name, file);
    put_figures(file, paper);
    (void)fputs("<h2>Claims</h2>\n<table>\n<tr><th></th><th>claim</th><th>what the paper says</th>"
                "<th>what was measured</th><th>holds</th><th>why</th></tr>\n",
                file);
    for (int i = 0; i < PAPER_CLAIMS; i++) {
        const struct paper_claim *claim = &paper->claims[i];
        (void)fprintf(file, "<tr><td>%d</td>", i + 1);
        put_cell(file, claim->title);
        put_cell(file, claim->says);
        put_cell(file, claim->measured);
        put_cell(file, paper_verdict_text(claim->verdict));
        put_cell(file, claim->why);
        (void)fputs("</tr>\n", file);
    }
    (void)fputs("</table>\n</body>\n</html>\n", file);
    return paper_close(file, "index.html");
}

int paper_write_report(const struct paper *paper) {
    int status = write_markdown(paper);
    return status == STATUS_DONE ? write_html(paper) : status;
}
