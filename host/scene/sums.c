/* SPDX-License-Identifier: MIT */
/* Numbers of a scene file: sums and products, parentheses, and numbers with names. */
#include <math.h>
#include <string.h>

#include "scene/parser_internal.h"

/* Parentheses within each other, of one number. */
enum { PARENTHESES_MOST = 32 };

const struct constant *find_constant(const struct checker *checker, const struct token *token) {
    const struct constant *constant = checker->constants;
    while (constant != NULL && (strlen(constant->name) != token->length ||
                                memcmp(constant->name, token->start, token->length) != 0)) {
        constant = constant->before;
    }
    return constant;
}

static bool read_sum(struct checker *checker, double first, int level, double *sum);

/* Reads a number, a name, or a sum in parentheses, with signs before it. */
static bool read_factor(struct checker *checker, const struct token *first, int level,
                        double *factor) {
    struct token token = *first;
    bool is_negative = false;
    *factor = 0;
    while (token_is(&token, '-') || token_is(&token, '+')) {
        is_negative = is_negative != token_is(&token, '-');
        if (!next_token(checker, &token)) {
            return false;
        }
    }
    if (token_is(&token, '(')) {
        if (level == PARENTHESES_MOST) {
            return scene_fail(checker->reader, token.line,
                              "parentheses nest too deep: at most %d levels are allowed",
                              PARENTHESES_MOST);
        }
        if (!next_token(checker, &token) || !read_factor(checker, &token, level + 1, factor) ||
            !read_sum(checker, *factor, level + 1, factor) || !next_token(checker, &token)) {
            return false;
        }
        if (token_is(&token, ',') && checker->stack[checker->depth].open == '[') {
            return only_plain(checker, &token);
        }
        if (!token_is(&token, ')')) {
            return unexpected(checker, &token, "')'");
        }
    } else if (token_is_number(&token)) {
        *factor = token_number(&token);
    } else if (token.kind == TOKEN_NAME) {
        const struct constant *constant = find_constant(checker, &token);
        if (constant == NULL) {
            return refuse_word(checker, &token);
        }
        *factor = constant->value;
    } else {
        return unexpected(checker, &token, "a number");
    }
    *factor = is_negative ? -*factor : *factor;
    return true;
}

/* Goes on with a product whose first factor has been read. */
static bool read_product(struct checker *checker, int level, double *product) {
    struct token mark, token;
    for (;;) {
        double factor = 0;
        if (!peek(checker, &mark)) {
            return false;
        }
        if (!token_is(&mark, '*') && !token_is(&mark, '/')) {
            return true;
        }
        checker->has_next = false;
        if (!next_token(checker, &token) || !read_factor(checker, &token, level, &factor)) {
            return false;
        }
        *product = token_is(&mark, '*') ? *product * factor : *product / factor;
        if (!isfinite(*product)) {
            return scene_fail(checker->reader, mark.line,
                              "what '%c' gives here is no finite number", *mark.start);
        }
    }
}

/* Goes on with a sum whose first factor has been read. In "2-1" the sign is the number's own; so it
 * goes on only without a blank before it: [1 -2] lacks a comma. */
static bool read_sum(struct checker *checker, double first, int level, double *sum) {
    struct token mark, token;
    *sum = first;
    if (!read_product(checker, level, sum)) {
        return false;
    }
    for (;;) {
        double product = 0;
        if (!peek(checker, &mark)) {
            return false;
        }
        const char *before = mark.start > checker->scanner.text ? mark.start - 1 : mark.start;
        bool is_signed = token_is_number(&mark) && (*mark.start == '-' || *mark.start == '+') &&
                         strchr(" \t\r\n/", *before) == NULL;
        if (!token_is(&mark, '+') && !token_is(&mark, '-') && !is_signed) {
            return true;
        }
        checker->has_next = false;
        token = mark;
        if ((!is_signed && !next_token(checker, &token)) ||
            !read_factor(checker, &token, level, &product) ||
            !read_product(checker, level, &product)) {
            return false;
        }
        *sum = token_is(&mark, '-') ? *sum - product : *sum + product;
        if (!isfinite(*sum)) {
            return scene_fail(checker->reader, mark.line, "this sum is no finite number");
        }
    }
}

bool go_on_with_sum(struct checker *checker, double first, double *sum) {
    return read_sum(checker, first, 0, sum);
}

bool read_number(struct checker *checker, const struct token *token, double *number) {
    double first = 0;
    return read_factor(checker, token, 0, &first) && read_sum(checker, first, 0, number);
}

bool read_constant(struct checker *checker, const struct token *name) {
    const struct constant *other = find_constant(checker, name);
    struct constant *constant = take_memory(checker, sizeof *constant);
    struct token token;
    if (other != NULL) {
        return scene_fail(checker->reader, name->line, "'%.*s' has its 'let' on line %u already",
                          token_shown(name), name->start, other->line);
    }
    if (constant == NULL || (constant->name = copy_text(checker, name)) == NULL ||
        !next_token(checker, &token)) {
        return false;
    }
    if (!token_is(&token, '=')) {
        return unexpected(checker, &token, "'='");
    }
    if (!next_token(checker, &token) || !read_number(checker, &token, &constant->value)) {
        return false;
    }
    constant->line = name->line;
    constant->before = checker->constants;
    checker->constants = constant;
    return true;
}
