/* SPDX-License-Identifier: MIT */
/* The parser's next token: it is taken or refused, and behind a refused one the way is found again.
 */
#include <string.h>

#include "scene/parser_internal.h"

enum { BRACKETS_MOST = 64 };

void parser_advance(struct parser *parser) {
    if (!parser->is_astray) {
        parser->next = scanner_next(&parser->scanner);
    }
}

void parser_unexpected(struct parser *parser, const char *wanted) {
    const struct token *next = &parser->next;
    if (parser->is_astray) {
        return;
    }
    parser->is_astray = true;
    if (parser->scanner.is_cut) {
        return;
    }
    if (next->kind == TOKEN_END) {
        (void)scene_fail(parser->reader, next->at, "the file ends where %s is wanted", wanted);
    } else if (next->kind != TOKEN_REFUSED) {
        (void)scene_fail(parser->reader, next->at, "'%.*s' stands where %s is wanted",
                         token_shown(next), next->start, wanted);
    }
}

void *parser_take_memory(struct parser *parser, size_t size) {
    static const struct scene_place nowhere = {0, 0};
    void *memory = memory_take(&parser->reader->memory, size);
    if (memory == NULL) {
        (void)scene_fail(parser->reader, nowhere, "not enough memory to read the scene");
    }
    return memory;
}

bool parser_is_next(const struct parser *parser, char mark) {
    return !parser->is_astray && token_is(&parser->next, mark);
}

void parser_pass_over(struct parser *parser, const char *marks) {
    const struct token *next = &parser->next;
    unsigned open = 0;
    parser->is_astray = false;
    while (next->kind != TOKEN_END) {
        const bool is_mark = next->kind == TOKEN_MARK && strchr(marks, *next->start) != NULL;
        if (open == 0 && (is_mark || token_closes(next))) {
            return;
        }
        open += token_is(next, '{') || token_is(next, '(') || token_is(next, '[');
        open -= token_closes(next);
        parser_advance(parser);
    }
}

bool parser_enter(struct parser *parser) {
    if (parser->depth == BRACKETS_MOST) {
        const bool is_new = !parser->is_astray;
        parser->is_astray = parser->is_unclosed = true;
        return is_new && scene_fail(parser->reader, parser->next.at,
                                    "brackets nest too deep: at most %d levels are allowed; named "
                                    "parts make a scene flatter",
                                    BRACKETS_MOST);
    }
    parser->depth++;
    return true;
}
