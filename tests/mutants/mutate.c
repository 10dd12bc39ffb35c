/* SPDX-License-Identifier: MIT */
/* Draws one small change of the C files that it is given: mutate SEED NUMBER PATTERN COPY FILE...
 *
 * All FILEs are read for their enumerations; those that match a word of PATTERN (as a shell's,
 * where
 * `*` stands for slashes too) are drawn from: a line first, then one of the line's mutations, so
 * that a line of a table counts for no more than any other. SEED and NUMBER say which.
 *
 * The changed file is written to COPY. Standard output gets five lines: the file, the number of the
 * line, the function that it is in (or "-"), the lines as they are and as they are changed, each in
 * one line without superfluous spaces.
 *
 * Exit status: 0, 1 nothing to draw from, 2 bad usage or a file that can't be read or written. */
#include "operators.h"

#include "splitmix64.h"

#include <ctype.h>
#include <fnmatch.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool matches(const char *patterns, const char *path) {
    char word[256];
    int used;

    while (sscanf(patterns, "%255s%n", word, &used) == 1) {
        if (fnmatch(word, path, 0) == 0) {
            return true;
        }
        patterns += used;
    }
    return false;
}

/* Tells if two neighbours of the list are changes of one line. */
static bool is_same_line(const struct mutation *a, const struct mutation *b) {
    return a->source == b->source && a->line == b->line;
}

static int by_place(const void *left, const void *right) {
    const struct mutation *a = left, *b = right;

    if (a->source != b->source) {
        return a->source < b->source ? -1 : 1;
    }
    if (a->line != b->line) {
        return a->line < b->line ? -1 : 1;
    }
    if (a->start != b->start) {
        return a->start < b->start ? -1 : 1;
    }
    return a->end != b->end ? (a->end < b->end ? -1 : 1) : strcmp(a->text, b->text);
}

/* Draws a line, then one of its mutations. The list is sorted by place, and not empty. */
static const struct mutation *draw(const struct mutations *mutations, uint64_t state) {
    const struct mutation *list = mutations->list;
    size_t lines = 1, line, first = 0, last;

    for (size_t i = 1; i < mutations->count; i++) {
        lines += !is_same_line(&list[i - 1], &list[i]);
    }
    line = (size_t)(splitmix64(&state) % lines);
    while (line > 0) {
        first++;
        line -= !is_same_line(&list[first - 1], &list[first]);
    }
    for (last = first; last < mutations->count && is_same_line(&list[first], &list[last]);) {
        last++;
    }
    return &list[first + (size_t)(splitmix64(&state) % (last - first))];
}

/* Writes bytes, or, on one line, with each run of spaces as one. Skips spaces at first. */
static void put(FILE *to, const char *text, size_t length, bool on_one_line, bool *is_blank) {
    for (size_t i = 0; i < length; i++) {
        bool is_space = isspace((unsigned char)text[i]);

        if (!on_one_line || !is_space) {
            (void)fputc(text[i], to);
        } else if (!*is_blank) {
            (void)fputc(' ', to);
        }
        *is_blank = is_space;
    }
}

/* Writes a part of the file, from byte `from` to `to`, with the mutation in it. */
static void put_changed(FILE *file, const struct mutation *mutation, size_t from, size_t to,
                        bool on_one_line) {
    const char *text = mutation->source->text;
    size_t kept = mutation->is_wrapped ? mutation->end : mutation->start;
    bool is_blank = true;

    put(file, text + from, mutation->start - from, on_one_line, &is_blank);
    put(file, mutation->text, strlen(mutation->text), on_one_line, &is_blank);
    put(file, text + mutation->start, kept - mutation->start, on_one_line, &is_blank);
    put(file, ")", mutation->is_wrapped, on_one_line, &is_blank);
    put(file, text + mutation->end, to - mutation->end, on_one_line, &is_blank);
}

/* Prints where the mutation is, and its lines before and after. */
static void print(const struct mutation *mutation) {
    const struct source *source = mutation->source;
    size_t from = mutation->start, to = mutation->end;
    bool is_blank = true;

    while (from > 0 && source->text[from - 1] != '\n') {
        from--;
    }
    to += strcspn(source->text + to, "\n");
    (void)printf("%s\n%d\n", source->path, mutation->line);
    if (mutation->function == NO_FUNCTION) {
        (void)puts("-");
    } else {
        const struct token *name = &source->tokens[mutation->function];

        (void)printf("%.*s\n", (int)(name->end - name->start), source->text + name->start);
    }
    put(stdout, source->text + from, to - from, true, &is_blank);
    (void)putchar('\n');
    put_changed(stdout, mutation, from, to, true);
    (void)putchar('\n');
}

static bool write_copy(const char *path, const struct mutation *mutation) {
    FILE *file = fopen(path, "wb");
    bool is_written;

    if (file == NULL) {
        perror(path);
        return false;
    }
    put_changed(file, mutation, 0, mutation->source->length, false);
    is_written = !ferror(file);
    if (fclose(file) != 0 || !is_written) {
        perror(path);
        return false;
    }
    return true;
}

int main(int argc, char **argv) {
    struct siblings siblings = {0};
    struct mutations mutations = {0};
    const struct mutation *drawn;
    struct source *sources;
    int count = argc - 5;
    uint64_t state;

    if (count < 1) {
        (void)fputs("usage: mutate SEED NUMBER PATTERN COPY FILE...\n", stderr);
        return 2;
    }
    sources = source_memory(calloc((size_t)count, sizeof *sources));
    for (int i = 0; i < count; i++) {
        sources[i] = source_read(argv[5 + i]);
        siblings_collect(&siblings, &sources[i]);
    }
    siblings_sort(&siblings);
    for (int i = 0; i < count; i++) {
        if (matches(argv[3], sources[i].path)) {
            operators_apply(&mutations, &sources[i], &siblings);
        }
    }
    if (mutations.count == 0) {
        (void)fprintf(stderr, "mutate: no file matches %s\n", argv[3]);
        return 1;
    }
    qsort(mutations.list, mutations.count, sizeof *mutations.list, by_place);
    state = strtoull(argv[1], NULL, 10);
    state = splitmix64(&state) + strtoull(argv[2], NULL, 10);
    drawn = draw(&mutations, state);
    print(drawn);
    return write_copy(argv[4], drawn) ? 0 : 2;
}
