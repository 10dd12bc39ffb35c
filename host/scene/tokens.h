/* SPDX-License-Identifier: MIT */
/* Cuts a scene's text into tokens. */
#ifndef SUPERFRAME_SCENE_TOKENS_H
#define SUPERFRAME_SCENE_TOKENS_H

#include "scene/reader_internal.h"

enum token_kind {
    TOKEN_END,
    TOKEN_NAME,
    TOKEN_STRING,
    TOKEN_BOOLEAN,
    TOKEN_INTEGER, /* of 64 bits, perhaps with the suffix L */
    TOKEN_FLOAT,
    TOKEN_MARK /* one of = : , ; { } ( ) [ ] + - * / */
};

struct token {
    enum token_kind kind;
    unsigned line;
    const char *start; /* in the scanner's text */
    size_t length;
};

struct scanner {
    struct scene_reader *reader; /* for errors */
    const char *text;            /* ended by NUL */
    size_t length;
    size_t at;
    unsigned line;
};

/* Reads the next token. Returns false with the failure recorded. */
bool scanner_next(struct scanner *scanner, struct token *token);

/* Tells whether a token is this mark. */
bool token_is(const struct token *token, char mark);

bool token_is_number(const struct token *token);

/* Returns what a number token says. */
double token_number(const struct token *token);

/* Returns how many of a token's first bytes an error message shows. */
int token_shown(const struct token *token);

/* Tells whether a token spells infinity or not-a-number, with or without a sign. */
bool token_is_infinite_or_nan(const struct token *token);

#endif
