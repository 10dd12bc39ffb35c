/* SPDX-License-Identifier: MIT */
/* What the parts of the parser share: tokens that are read again, refusals, memory of the tree. */
#include "scene/parser_internal.h"

#include <string.h>
#include <strings.h>

bool next_token(struct parser *parser, struct token *token) {
    if (parser->has_next) {
        *token = parser->next;
        parser->has_next = false;
        return true;
    }
    return scanner_next(&parser->scanner, token);
}

bool peek(struct parser *parser, struct token *token) {
    if (!next_token(parser, token)) {
        return false;
    }
    parser->next = *token;
    parser->has_next = true;
    return true;
}

bool unexpected(struct parser *parser, const struct token *token, const char *wanted) {
    if (token->kind == TOKEN_END) {
        return scene_fail(parser->reader, token->line, "the file ends where %s is wanted", wanted);
    }
    return scene_fail(parser->reader, token->line, "'%.*s' stands where %s is wanted",
                      token_shown(token), token->start, wanted);
}

bool only_plain(struct parser *parser, const struct token *token) {
    return scene_fail(parser->reader, token->line,
                      "an array [ ] holds plain values only: use a list ( ) here");
}

bool refuse_word(struct parser *parser, const struct token *token) {
    static const char *const truths[] = {"yes", "no", "on", "off"};
    if (token_is_infinite_or_nan(token)) {
        return scene_fail(parser->reader, token->line,
                          "'%.*s' is invalid: every number must be finite", token_shown(token),
                          token->start);
    }
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++) {
        if (strlen(truths[i]) == token->length &&
            strncasecmp(truths[i], token->start, token->length) == 0) {
            return scene_fail(parser->reader, token->line, "'%.*s' is invalid: write true or false",
                              token_shown(token), token->start);
        }
    }
    return scene_fail(parser->reader, token->line,
                      "'%.*s' is no value: strings stand in quotes, as in \"%.*s\", and a number "
                      "gets a name by 'let %.*s = ...;' before",
                      token_shown(token), token->start, token_shown(token), token->start,
                      token_shown(token), token->start);
}

void *take_memory(struct parser *parser, size_t size) {
    void *memory = memory_take(&parser->reader->memory, size);
    if (memory == NULL) {
        scene_fail(parser->reader, 1, "not enough memory to read the scene");
    }
    return memory;
}

const char *copy_text(struct parser *parser, const struct token *token) {
    const bool is_string = token->kind == TOKEN_STRING;
    char *copy = take_memory(parser, token->length + 1);
    size_t used = 0;
    for (size_t i = is_string; copy != NULL && i + is_string < token->length; i++) {
        i += is_string && token->start[i] == '\\';
        copy[used++] = token->start[i];
    }
    return copy;
}
