/* SPDX-License-Identifier: MIT */
/* Cuts a scene's text into tokens. */
#ifndef SUPERFRAME_SCENE_TOKENS_H
#define SUPERFRAME_SCENE_TOKENS_H

#include "scene/reader_internal.h"

enum token_kind {
    TOKEN_END,
    TOKEN_REFUSED, /* refused already */
    TOKEN_NAME,
    TOKEN_STRING,
    TOKEN_BOOLEAN,
    TOKEN_NUMBER, /* a whole one of 64 bits, perhaps with the suffix L, or any other */
    TOKEN_MARK    /* one of = : , ; { } ( ) [ ] + - * / */
};

struct token {
    enum token_kind kind;
    struct scene_place at;
    const char *start; /* in the scanner's text */
    size_t length;
    double number; /* of TOKEN_NUMBER */
};

struct scanner {
    struct scene_reader *reader; /* for errors */
    const char *text;            /* ended by NUL */
    size_t length;
    size_t at;
    unsigned line;
    size_t line_start; /* in the text */
    bool is_cut;       /* a comment takes the rest, which was refused */
};

/* Reads the next token. What is wrong is recorded, and becomes TOKEN_REFUSED. */
struct token scanner_next(struct scanner *scanner);

/* Tells whether a token is this mark. */
bool token_is(const struct token *token, char mark);

/* Tells whether a token is a bracket that closes. */
bool token_closes(const struct token *token);

/* Tells whether a token spells a word. */
bool token_spells(const struct token *token, const char *word);

/* Tells whether a token is a number with a sign that stands right behind what is before it, as in
 * "2-1". */
bool token_is_signed_onward(const struct scanner *scanner, const struct token *token);

/* Returns how many of a token's first bytes an error message shows. */
int token_shown(const struct token *token);

/* Tells whether a token spells infinity or not-a-number, with or without a sign. */
bool token_is_infinite_or_nan(const struct token *token);

#endif
