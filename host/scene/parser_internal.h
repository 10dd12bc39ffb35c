/* SPDX-License-Identifier: MIT */
/* What the parser of scene files and its arithmetic share. */
#ifndef SUPERFRAME_SCENE_PARSER_INTERNAL_H
#define SUPERFRAME_SCENE_PARSER_INTERNAL_H

#include "scene/tokens.h"
#include "scene/tree.h"

/* An open bracket, or the file itself. */
struct bracket {
    char open; /* { ( [, or NUL: the file */
    unsigned line;
    size_t count;       /* keys or elements so far */
    size_t first_key;   /* of a group, in the keys of all open groups */
    size_t first_value; /* of what it holds, among the values so far */
    struct scene_value itself;
    enum token_kind element; /* of an array, once it has one */
};

enum expectation { WANT_KEY, WANT_EQUALS, WANT_VALUE, WANT_FIRST_VALUE, AFTER_VALUE };

/* A number with a name: `let r = 0.6;`. */
struct constant {
    const char *name;
    double value;
    unsigned line;
    struct constant *before;
};

struct parser {
    struct scene_reader *reader;
    struct scanner scanner;
    struct token next; /* was read too far, if has_next */
    bool has_next;
    struct scene_value *values; /* of all open brackets */
    size_t value_count, value_room;
    struct constant *constants; /* the last one */
    struct bracket stack[SCENE_BRACKETS_MOST + 1];
    size_t depth; /* the innermost open bracket is stack[depth] */
    struct token *keys;
    size_t key_count;
    enum expectation expectation;
    struct token key;       /* the last one */
    const char *key_name;   /* the same, ended by NUL */
    struct token value;     /* the last plain value */
    struct token separator; /* the last one */
};

/* Reads the next token, or the one that was read too far. */
bool next_token(struct parser *parser, struct token *token);

/* Reads the next token, which will be read again. */
bool peek(struct parser *parser, struct token *token);

/* Records that a token stands where something else is wanted, and returns false. */
bool unexpected(struct parser *parser, const struct token *token, const char *wanted);

/* Records that an array may not hold lists or groups, and returns false. */
bool only_plain(struct parser *parser, const struct token *token);

/* Records that a word is no value, and returns false. */
bool refuse_word(struct parser *parser, const struct token *token);

/* Takes memory of the tree; NULL with the failure recorded. */
void *take_memory(struct parser *parser, size_t size);

/* Copies what a token spells; of a string, what stands in its quotes. NULL with the failure
 * recorded. */
const char *copy_text(struct parser *parser, const struct token *token);

/* Finds a number with a name; NULL: no `let` has that name so far. */
const struct constant *find_constant(const struct parser *parser, const struct token *token);

/* Reads the number that begins with this token. */
bool read_number(struct parser *parser, const struct token *token, double *number);

/* Goes on with a sum whose first factor has been read. */
bool go_on_with_sum(struct parser *parser, double first, double *sum);

/* Reads `let NAME = NUMBER`, whose name is this token. */
bool read_constant(struct parser *parser, const struct token *name);

#endif
