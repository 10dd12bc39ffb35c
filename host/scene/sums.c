/* SPDX-License-Identifier: MIT */
/* Numbers of a scene file: sums and products, parentheses, and numbers with names. */
#include <math.h>
#include <string.h>

#include "scene/parser_internal.h"

/* Parentheses within each other, of one number. */
enum { PARENTHESES_MOST = 32 };

const struct constant *find_constant(const struct parser *parser, const struct token *token) {
    const struct constant *constant = parser->constants;
    while (constant != NULL && (strlen(constant->name) != token->length ||
                                memcmp(constant->name, token->start, token->length) != 0)) {
        constant = constant->before;
    }
    return constant;
}

static bool read_sum(struct parser *parser, double first, int level, double *sum);

/* Reads a number, a name, or a sum in parentheses, with signs before it. */
static bool read_factor(struct parser *parser, const struct token *first, int level,
                        double *factor) {
    struct token token = *first;
    bool is_negative = false;
    *factor = 0;
    while (token_is(&token, '-') || token_is(&token, '+')) {
        is_negative = is_negative != token_is(&token, '-');
        if (!next_token(parser, &token)) {
            return false;
        }
    }
    if (token_is(&token, '(')) {
        if (level == PARENTHESES_MOST) {
            return scene_fail(parser->reader, token.line,
                              "parentheses nest too deep: at most %d levels are allowed",
                              PARENTHESES_MOST);
        }
        if (!next_token(parser, &token) || !read_factor(parser, &token, level + 1, factor) ||
            !read_sum(parser, *factor, level + 1, factor) || !next_token(parser, &token)) {
            return false;
        }
        if (token_is(&token, ',') && parser->stack[parser->depth].open == '[') {
            return only_plain(parser, &token);
        }
        if (!token_is(&token, ')')) {
            return unexpected(parser, &token, "')'");
        }
    } else if (token_is_number(&token)) {
        *factor = token_number(&token);
    } else if (token.kind == TOKEN_NAME) {
        const struct constant *constant = find_constant(parser, &token);
        if (constant == NULL) {
            return refuse_word(parser, &token);
        }
        *factor = constant->value;
    } else {
        return unexpected(parser, &token, "a number");
    }
    *factor = is_negative ? -*factor : *factor;
    return true;
}

/* Goes on with a product whose first factor has been read. */
static bool read_product(struct parser *parser, int level, double *product) {
    struct token mark, token;
    for (;;) {
        double factor = 0;
        if (!peek(parser, &mark)) {
            return false;
        }
        if (!token_is(&mark, '*') && !token_is(&mark, '/')) {
            return true;
        }
        parser->has_next = false;
        if (!next_token(parser, &token) || !read_factor(parser, &token, level, &factor)) {
            return false;
        }
        *product = token_is(&mark, '*') ? *product * factor : *product / factor;
        if (!isfinite(*product)) {
            return scene_fail(parser->reader, mark.line, "what '%c' gives here is no finite number",
                              *mark.start);
        }
    }
}

/* Goes on with a sum whose first factor has been read. In "2-1" the sign is the number's own; so it
 * goes on only without a blank before it: [1 -2] lacks a comma. */
static bool read_sum(struct parser *parser, double first, int level, double *sum) {
    struct token mark, token;
    *sum = first;
    if (!read_product(parser, level, sum)) {
        return false;
    }
    for (;;) {
        double product = 0;
        if (!peek(parser, &mark)) {
            return false;
        }
        const char *before = mark.start > parser->scanner.text ? mark.start - 1 : mark.start;
        bool is_signed = token_is_number(&mark) && (*mark.start == '-' || *mark.start == '+') &&
                         strchr(" \t\r\n/", *before) == NULL;
        if (!token_is(&mark, '+') && !token_is(&mark, '-') && !is_signed) {
            return true;
        }
        parser->has_next = false;
        token = mark;
        if ((!is_signed && !next_token(parser, &token)) ||
            !read_factor(parser, &token, level, &product) ||
            !read_product(parser, level, &product)) {
            return false;
        }
        *sum = token_is(&mark, '-') ? *sum - product : *sum + product;
        if (!isfinite(*sum)) {
            return scene_fail(parser->reader, mark.line, "this sum is no finite number");
        }
    }
}

bool go_on_with_sum(struct parser *parser, double first, double *sum) {
    return read_sum(parser, first, 0, sum);
}

bool read_number(struct parser *parser, const struct token *token, double *number) {
    double first = 0;
    return read_factor(parser, token, 0, &first) && read_sum(parser, first, 0, number);
}

bool read_constant(struct parser *parser, const struct token *name) {
    const struct constant *other = find_constant(parser, name);
    struct constant *constant = take_memory(parser, sizeof *constant);
    struct token token;
    if (other != NULL) {
        return scene_fail(parser->reader, name->line, "'%.*s' has its 'let' on line %u already",
                          token_shown(name), name->start, other->line);
    }
    if (constant == NULL || (constant->name = copy_text(parser, name)) == NULL ||
        !next_token(parser, &token)) {
        return false;
    }
    if (!token_is(&token, '=')) {
        return unexpected(parser, &token, "'='");
    }
    if (!next_token(parser, &token) || !read_number(parser, &token, &constant->value)) {
        return false;
    }
    constant->line = name->line;
    constant->before = parser->constants;
    parser->constants = constant;
    return true;
}
