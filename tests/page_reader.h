/* SPDX-License-Identifier: MIT */
/* Reads the pages that the program writes, Markdown and HTML, into one list of blocks. A page that
 * leaves something open fails the test. */
#ifndef SUPERFRAME_TESTS_PAGE_READER_H
#define SUPERFRAME_TESTS_PAGE_READER_H

#include "shell_fixture.h"

enum block_kind { HEADING, PARAGRAPH, HEAD_ROW, ROW, TABLE_END, PICTURE };

enum { BLOCKS_MOST = 512, BLOCK_SIZE = 2100, CELLS_MOST = 32, NESTING_MOST = 8 };

struct block {
    enum block_kind kind;
    int level;             /* of a heading */
    char text[BLOCK_SIZE]; /* cells are parted by '|', a picture's file and caption too */
};

struct page {
    size_t count;
    struct block blocks[BLOCKS_MOST];
};

static inline void add_block(struct page *page, enum block_kind kind, int level, const char *text) {
    assert_true(page->count < BLOCKS_MOST && strlen(text) < BLOCK_SIZE);
    struct block *block = &page->blocks[page->count++];
    block->kind = kind;
    block->level = level;
    strcpy(block->text, text);
}

/* ---- Markdown ------------------------------------------------------------------------------- */

/* Takes a line off the text. */
static inline void take_line(const char **at, char line[BLOCK_SIZE]) {
    size_t length = strcspn(*at, "\n");
    assert_true((*at)[length] == '\n' && length < BLOCK_SIZE);
    memcpy(line, *at, length);
    line[length] = '\0';
    *at += length + 1;
}

static inline void take_empty_line(const char **at) {
    char line[BLOCK_SIZE];
    take_line(at, line);
    assert_string_equal(line, "");
}

static inline size_t count_of(const char *text, char letter) {
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += *text == letter;
    }
    return count;
}

/* Takes a table: a head, the line below it, rows, and the empty line that ends it. */
static inline void take_table(struct page *page, const char **at, char line[BLOCK_SIZE]) {
    size_t bars = count_of(line, '|');
    for (enum block_kind kind = HEAD_ROW; line[0] != '\0'; kind = ROW) {
        size_t length = strlen(line);
        assert_true(length > 4 && strncmp(line, "| ", 2) == 0);
        assert_string_equal(line + length - 2, " |");
        assert_int_equal(count_of(line, '|'), bars);
        line[length - 2] = '\0';
        add_block(page, kind, 0, line + 2);
        take_line(at, line);
        if (kind == HEAD_ROW) {
            assert_int_equal(strspn(line, "|-"), 4 * (bars - 1) + 1);
            assert_int_equal(strlen(line), 4 * (bars - 1) + 1);
            take_line(at, line);
        }
    }
    add_block(page, TABLE_END, 0, "");
}

/* Takes ![caption](file), and the caption below it. */
static inline void take_picture(struct page *page, const char **at, char line[BLOCK_SIZE]) {
    char caption[BLOCK_SIZE], file[64], text[2 * BLOCK_SIZE];
    assert_int_equal(sscanf(line, "![%2000[^]]](%63[^)])", caption, file), 2);
    take_empty_line(at);
    take_line(at, line);
    assert_string_equal(line, caption);
    (void)snprintf(text, sizeof text, "%s|%s", file, caption);
    add_block(page, PICTURE, 0, text);
}

static inline void read_markdown(const char *text, struct page *page) {
    char line[BLOCK_SIZE];
    page->count = 0;
    while (*text != '\0') {
        take_line(&text, line);
        if (line[0] == '|') {
            take_table(page, &text, line);
            continue;
        }
        if (line[0] == '#') {
            size_t level = strspn(line, "#");
            assert_int_equal(line[level], ' ');
            add_block(page, HEADING, (int)level, line + level + 1);
        } else if (line[0] == '!') {
            take_picture(page, &text, line);
        } else {
            assert_true(line[0] != '\0');
            add_block(page, PARAGRAPH, 0, line);
        }
        take_empty_line(&text);
    }
}

/* ---- HTML ----------------------------------------------------------------------------------- */

struct html {
    struct page *page;
    int depth;
    char open[NESTING_MOST][16]; /* elements, from the outermost */
    char text[BLOCK_SIZE];       /* since the last tag */
    char row[BLOCK_SIZE], title[BLOCK_SIZE], file[64], alternative[BLOCK_SIZE];
    bool is_head;
};

/* Each element, and what it may stand in. */
static inline void assert_place(const struct html *html, const char *name) {
    static const char *const places[][2] = {{"html", ""},
                                            {"head", "html"},
                                            {"body", "html"},
                                            {"title", "head"},
                                            {"style", "head"},
                                            {"meta", "head"},
                                            {"h1", "body"},
                                            {"h2", "body"},
                                            {"h3", "body"},
                                            {"p", "body"},
                                            {"table", "body"},
                                            {"tr", "table"},
                                            {"th", "tr"},
                                            {"td", "tr"},
                                            {"figure", "body"},
                                            {"img", "figure"},
                                            {"figcaption", "figure"}};
    const char *parent = html->depth > 0 ? html->open[html->depth - 1] : "";
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        if (strcmp(places[i][0], name) == 0) {
            assert_string_equal(parent, places[i][1]);
            return;
        }
    }
    fail_msg("an element <%s>", name);
}

static inline void close_element(struct html *html, const char *name) {
    assert_true(html->depth > 0);
    assert_string_equal(html->open[--html->depth], name);
    if (name[0] == 'h' && name[1] >= '1' && name[1] <= '3') {
        add_block(html->page, HEADING, name[1] - '0', html->text);
    } else if (strcmp(name, "p") == 0) {
        add_block(html->page, PARAGRAPH, 0, html->text);
    } else if (strcmp(name, "th") == 0 || strcmp(name, "td") == 0) {
        html->is_head = name[1] == 'h';
        assert_true(strlen(html->row) + strlen(html->text) + 2 < BLOCK_SIZE);
        strcat(strcat(html->row, html->row[0] != '\0' ? "|" : ""), html->text);
    } else if (strcmp(name, "tr") == 0) {
        add_block(html->page, html->is_head ? HEAD_ROW : ROW, 0, html->row);
        html->row[0] = '\0';
    } else if (strcmp(name, "table") == 0) {
        add_block(html->page, TABLE_END, 0, "");
    } else if (strcmp(name, "title") == 0) {
        strcpy(html->title, html->text);
    } else if (strcmp(name, "figcaption") == 0) {
        char text[2 * BLOCK_SIZE];
        assert_string_equal(html->text, html->alternative);
        (void)snprintf(text, sizeof text, "%s|%s", html->file, html->text);
        add_block(html->page, PICTURE, 0, text);
    }
    html->text[0] = '\0';
}

static inline void open_element(struct html *html, const char *tag, const char *name) {
    bool is_alone = strcmp(name, "meta") == 0 || strcmp(name, "img") == 0;
    assert_place(html, name);
    assert_int_equal(strspn(html->text, "\n"), strlen(html->text));
    html->text[0] = '\0';
    if (strcmp(name, "img") == 0) {
        assert_int_equal(
            sscanf(tag, "img src=\"%63[^\"]\" alt=\"%2000[^\"]\">", html->file, html->alternative),
            2);
    } else if (!is_alone) {
        assert_true(html->depth < NESTING_MOST);
        strcpy(html->open[html->depth++], name);
    }
}

/* Texts that stand for themselves in Markdown must do so in HTML: nothing is escaped. */
static inline void read_html(const char *text, struct page *page) {
    static const char begin[] = "<!DOCTYPE html>\n";
    static struct html html;
    memset(&html, 0, sizeof html);
    html.page = page;
    page->count = 0;
    assert_memory_equal(text, begin, sizeof begin - 1);
    for (text += sizeof begin - 1; *text != '\0';) {
        char name[16];
        size_t length = strcspn(text, "<");
        assert_true(strlen(html.text) + length < BLOCK_SIZE);
        strncat(html.text, text, length);
        text += length;
        if (*text == '<') {
            bool is_end = text[1] == '/';
            text += is_end ? 2 : 1;
            assert_int_equal(sscanf(text, "%15[a-z0-9]", name), 1);
            is_end ? close_element(&html, name) : open_element(&html, text, name);
            text += strcspn(text, ">") + 1;
        }
    }
    assert_int_equal(html.depth, 0);
    assert_string_equal(html.text, "\n");
    assert_string_equal(html.title, page->blocks[0].text);
}

/* ---- Both ----------------------------------------------------------------------------------- */

/* Finds what stands below a heading; the page's end where there is no such heading. */
static inline size_t find_section(const struct page *page, const char *heading) {
    for (size_t i = 0; i < page->count; i++) {
        if (page->blocks[i].kind == HEADING && strcmp(page->blocks[i].text, heading) == 0) {
            return i + 1;
        }
    }
    return page->count;
}

/* Finds the next row of the section that a place is in; NULL: there is none. */
static inline const char *next_row(const struct page *page, size_t *place) {
    while (*place < page->count && page->blocks[*place].kind != HEADING) {
        const struct block *block = &page->blocks[(*place)++];
        if (block->kind == ROW) {
            return block->text;
        }
    }
    return NULL;
}

/* Splits a row; cells point into text. */
static inline size_t split(char text[BLOCK_SIZE], const char *row, char letter,
                           char *cells[CELLS_MOST]) {
    size_t count = 1;
    strcpy(text, row);
    cells[0] = text;
    for (char *at = text; *at != '\0'; at++) {
        if (*at == letter) {
            assert_true(count < CELLS_MOST);
            *at = '\0';
            cells[count++] = at + 1;
        }
    }
    return count;
}

static inline double number(const char *text) {
    char *end;
    double value = strtod(text, &end);
    assert_true(end != text && *end == '\0');
    return value;
}

/* Checks what every page has: one title before all else, headings once, nothing empty, rows of one
 * table with as many cells as its head. */
static inline void assert_sound(const struct page *page) {
    size_t cells = 0; /* 0: outside of a table */
    assert_true(page->count > 0 && page->blocks[0].kind == HEADING && page->blocks[0].level == 1);
    for (size_t i = 0; i < page->count; i++) {
        const struct block *block = &page->blocks[i];
        bool is_in_table = block->kind == ROW || block->kind == TABLE_END;
        assert_int_equal(is_in_table, cells > 0);
        assert_int_equal(block->kind == TABLE_END, block->text[0] == '\0');
        if (block->kind == HEAD_ROW || block->kind == ROW) {
            size_t found = count_of(block->text, '|') + 1;
            assert_true(block->kind == HEAD_ROW || found == cells);
            cells = found;
        } else if (block->kind == TABLE_END) {
            cells = 0;
        } else if (block->kind == HEADING) {
            assert_true(i == 0 || block->level > 1);
            assert_int_equal(find_section(page, block->text), i + 1);
        }
    }
}

/* Checks that two pages say the same in the same order. */
static inline void assert_same_page(const struct page *a, const struct page *b) {
    for (size_t i = 0; i < a->count && i < b->count; i++) {
        assert_string_equal(a->blocks[i].text, b->blocks[i].text);
        assert_int_equal(a->blocks[i].kind, b->blocks[i].kind);
        assert_int_equal(a->blocks[i].level, b->blocks[i].level);
    }
    assert_int_equal(a->count, b->count);
}

#endif
