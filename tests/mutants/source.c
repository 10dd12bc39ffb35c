/* SPDX-License-Identifier: MIT */
#include "source.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void *source_memory(void *memory) {
    if (memory == NULL) {
        (void)fputs("mutate: out of memory\n", stderr);
        exit(2);
    }
    return memory;
}

static void read_text(struct source *source) {
    FILE *file = fopen(source->path, "rb");
    size_t room = 4096, got;

    if (file == NULL) {
        perror(source->path);
        exit(2);
    }
    source->text = source_memory(malloc(room));
    while ((got = fread(source->text + source->length, 1, room - source->length - 1, file)) > 0) {
        source->length += got;
        if (source->length + 1 == room) {
            room *= 2;
            source->text = source_memory(realloc(source->text, room));
        }
    }
    source->text[source->length] = '\0';
    (void)fclose(file);
}

/* Returns the end of the line that holds `at`, lines continued by a backslash taken as one. */
static size_t end_of_line(const char *text, size_t at) {
    while (text[at] != '\0' && text[at] != '\n') {
        at += text[at] == '\\' && text[at + 1] != '\0' ? 2 : 1;
    }
    return at;
}

static bool is_word(char character) {
    return isalnum((unsigned char)character) || character == '_';
}

/* Returns what follows the spaces from `at` on. */
static size_t after_spaces(const char *text, size_t at) {
    return at + strspn(text + at, " \t");
}

/* Returns where tokens go on after the # at `at`: behind a macro's name, or at the line's end. */
static size_t after_directive(const char *text, size_t at) {
    size_t word = after_spaces(text, at + 1);

    if (strncmp(text + word, "define", 6) != 0) {
        return end_of_line(text, at);
    }
    word = after_spaces(text, word + 6);
    while (is_word(text[word])) {
        word++;
    }
    return word;
}

/* Returns the end of a comment, a directive or a space at `at`; `at` if a token begins there. */
static size_t after_blank(const char *text, size_t at) {
    const char *end;

    if (text[at] == '/' && text[at + 1] == '*') {
        end = strstr(text + at + 2, "*/");
        return end != NULL ? (size_t)(end - text) + 2 : strlen(text);
    }
    if (text[at] == '#') {
        return after_directive(text, at);
    }
    return isspace((unsigned char)text[at]) || text[at] == '\\' ? at + 1 : at;
}

static size_t end_of_text(const char *text, size_t at) {
    char quote = text[at++];

    while (text[at] != '\0' && text[at] != quote) {
        at += text[at] == '\\' && text[at + 1] != '\0' ? 2 : 1;
    }
    return text[at] != '\0' ? at + 1 : at;
}

static size_t end_of_number(const char *text, size_t at) {
    bool is_hexadecimal = text[at] == '0' && (text[at + 1] == 'x' || text[at + 1] == 'X');

    for (;; at++) {
        char sign = text[at + 1];

        if (!is_word(text[at]) && text[at] != '.') {
            return at;
        }
        if ((sign == '+' || sign == '-') &&
            strchr(is_hexadecimal ? "pP" : "eE", text[at]) != NULL) {
            at++;
        }
    }
}

static size_t end_of_sign(const char *text, size_t at) {
    static const char *const signs[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>",
                                        "<=",  ">=",  "==",  "!=", "&&", "||", "+=", "-=",
                                        "*=",  "/=",  "%=",  "&=", "|=", "^=", "##"};

    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (strncmp(text + at, signs[i], strlen(signs[i])) == 0) {
            return at + strlen(signs[i]);
        }
    }
    return at + 1;
}

/* Sets a token's kind and end by the characters at the token's start. */
static void measure_token(const char *text, struct token *token) {
    char first = text[token->start];

    if (isdigit((unsigned char)first) ||
        (first == '.' && isdigit((unsigned char)text[token->start + 1]))) {
        token->kind = TOKEN_NUMBER;
        token->end = end_of_number(text, token->start);
    } else if (is_word(first)) {
        token->kind = TOKEN_WORD;
        token->end = token->start;
        while (is_word(text[token->end])) {
            token->end++;
        }
    } else if (first == '"' || first == '\'') {
        token->kind = TOKEN_TEXT;
        token->end = end_of_text(text, token->start);
    } else {
        token->kind = TOKEN_SIGN;
        token->end = end_of_sign(text, token->start);
    }
}

static void split(struct source *source) {
    size_t room = 0, at = 0;
    int line = 1;

    while (source->text[at] != '\0') {
        size_t next = after_blank(source->text, at);
        struct token token = {.start = at, .line = line};

        if (next == at) {
            if (source->count == room) {
                room = room * 2 + 256;
                source->tokens =
                    source_memory(realloc(source->tokens, room * sizeof *source->tokens));
            }
            measure_token(source->text, &token);
            source->tokens[source->count++] = token;
            next = token.end;
        }
        for (; at < next; at++) {
            line += source->text[at] == '\n';
        }
    }
}

bool source_is(const struct source *source, size_t i, const char *characters) {
    const struct token *token = &source->tokens[i];

    return i < source->count && strlen(characters) == token->end - token->start &&
           memcmp(source->text + token->start, characters, token->end - token->start) == 0;
}

/* Pairs brackets of all kinds, and counts those that are open before each token. */
static void pair_brackets(struct source *source) {
    enum { DEEPEST = 256 };
    size_t open[DEEPEST], depth = 0;
    int braces = 0, parentheses = 0;

    for (size_t i = 0; i < source->count; i++) {
        struct token *token = &source->tokens[i];
        char sign = token->kind == TOKEN_SIGN ? source->text[token->start] : ' ';

        token->partner = i;
        token->braces = braces;
        token->parentheses = parentheses;
        if (strchr("({[", sign) != NULL && depth < DEEPEST) {
            open[depth++] = i;
        } else if (strchr(")}]", sign) != NULL && depth > 0) {
            token->partner = open[--depth];
            source->tokens[open[depth]].partner = i;
        }
        braces += (sign == '{') - (sign == '}');
        parentheses += (sign == '(' || sign == '[') - (sign == ')' || sign == ']');
    }
}

/* Names each token's function: the word before the last parenthesis outside of all braces. */
static void name_functions(struct source *source) {
    size_t function = NO_FUNCTION;

    for (size_t i = 0; i < source->count; i++) {
        struct token *token = &source->tokens[i];

        if (token->braces == 0 && (source_is(source, i, ";") || source_is(source, i, "="))) {
            function = NO_FUNCTION;
        }
        if (token->braces == 0 && token->parentheses == 0 && token->kind == TOKEN_WORD &&
            source_is(source, i + 1, "(")) {
            function = i;
        }
        token->function = token->braces > 0 ? function : NO_FUNCTION;
        if (token->braces == 1 && source_is(source, i, "}")) {
            function = NO_FUNCTION;
        }
    }
}

struct source source_read(const char *path) {
    struct source source = {.path = path};

    read_text(&source);
    split(&source);
    pair_brackets(&source);
    name_functions(&source);
    return source;
}
