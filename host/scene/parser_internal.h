/* SPDX-License-Identifier: MIT */
/* What the parser of scene files and its arithmetic share. */
#ifndef SUPERFRAME_SCENE_PARSER_INTERNAL_H
#define SUPERFRAME_SCENE_PARSER_INTERNAL_H

#include "scene/tokens.h"

/* An open bracket, or the file itself. */
struct bracket {
    const struct bracket *outer;
    struct scene_place at;
    char open, close;   /* NUL: the file's */
    size_t first_value; /* of what the bracket holds, among the values so far */
};

/* A number with a name: `let r = 0.6;`. */
struct constant {
    struct token name;
    double value;
    const struct constant *before;
};

struct parser {
    struct scene_reader *reader;
    struct scanner scanner;
    struct token next;
    const struct bracket *bracket; /* the innermost open one */
    unsigned depth;                /* of brackets and parentheses */
    bool is_astray;                /* `next` stands where nothing like it is wanted */
    bool is_unclosed;              /* the file ends in a bracket, which has been said */
    struct scene_value *values;    /* of all open brackets */
    size_t value_count, value_room;
    const struct constant *constants; /* the last one */
};

/* Takes the next token. Where the parser is astray, that token is not taken. */
void parser_advance(struct parser *parser);

/* Records that the next token is not what is wanted, unless the token was refused already. The
 * parser is astray then. */
void parser_unexpected(struct parser *parser, const char *wanted);

/* Takes memory of the tree; NULL with the failure recorded. */
void *parser_take_memory(struct parser *parser, size_t size);

/* Tells whether the next token is a mark, where the parser is not astray. */
bool parser_is_next(const struct parser *parser, char mark);

/* Passes over tokens up to one of these marks, or to a bracket that closes. Brackets that open here
 * are passed over whole. Then the parser is no longer astray. */
void parser_pass_over(struct parser *parser, const char *marks);

/* Counts one bracket or pair of parentheses more, whose first mark is the next token. Returns false
 * where that is one too many. */
bool parser_enter(struct parser *parser);

/* Reads a sum. *is_good becomes false where something in it was refused. */
double parser_read_sum(struct parser *parser, bool *is_good);

/* Goes on with a sum whose first factor has been read. */
double parser_go_on_with_sum(struct parser *parser, double first, bool *is_good);

/* Tells whether a sum goes on here. In "2-1" the sign is the number's own. Such a number goes on
 * only without a blank before it: [1 -2] lacks a comma. */
bool parser_goes_on(const struct parser *parser);

/* Reads `let NAME = NUMBER`, of which `let` has been taken. A number that is refused has its name
 * all the same, so that its uses are not refused as well. */
void parser_read_constant(struct parser *parser);

#endif
