/* SPDX-License-Identifier: MIT */
/* Numbers of a scene file: sums and products, parentheses, and numbers with names. */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "scene/parser_internal.h"

static const struct constant *find_constant(const struct parser *parser,
                                            const struct token *token) {
    const struct constant *constant = parser->constants;
    while (constant != NULL && (constant->name.length != token->length ||
                                memcmp(constant->name.start, token->start, token->length) != 0)) {
        constant = constant->before;
    }
    return constant;
}

/* Records that the next token, a word, is no value. */
static void refuse_word(struct parser *parser) {
    static const char *const truths[] = {"yes", "no", "on", "off"};
    const struct token *word = &parser->next;
    if (token_is_infinite_or_nan(word)) {
        (void)scene_fail(parser->reader, word->at, "'%.*s' is invalid: every number must be finite",
                         token_shown(word), word->start);
        return;
    }
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++) {
        if (strlen(truths[i]) == word->length &&
            strncasecmp(truths[i], word->start, word->length) == 0) {
            (void)scene_fail(parser->reader, word->at, "'%.*s' is invalid: write true or false",
                             token_shown(word), word->start);
            return;
        }
    }
    const char *minus = memchr(word->start, '-', word->length);
    struct token first = *word;
    first.length = minus != NULL ? (size_t)(minus - word->start) : 0;
    if (minus != NULL && find_constant(parser, &first) != NULL) {
        (void)scene_fail(parser->reader, word->at,
                         "'%.*s' is one name, for a name may have '-' in it: write '%.*s - %.*s'",
                         token_shown(word), word->start, token_shown(&first), word->start,
                         token_shown(word) - token_shown(&first) - 1, minus + 1);
        return;
    }
    if (parser->scanner.text[parser->scanner.at] == '(') {
        (void)scene_fail(parser->reader, word->at,
                         "'%.*s(' begins a function, and there are none: numbers are made by + - * "
                         "/ and parentheses alone",
                         token_shown(word), word->start);
        return;
    }
    (void)scene_fail(parser->reader, word->at,
                     "'%.*s' is no value: strings stand in quotes, as in \"%.*s\", and a number "
                     "gets a name by 'let %.*s = ...;' before",
                     token_shown(word), word->start, token_shown(word), word->start,
                     token_shown(word), word->start);
}

/* Reads a number, the name of one, or a sum in parentheses, with signs before it. *is_good becomes
 * false where that was refused. */
static double parse_factor(struct parser *parser, bool *is_good) {
    bool is_negative = false;
    double factor = 0;
    while (parser_is_next(parser, '-') || parser_is_next(parser, '+')) {
        is_negative = is_negative != parser_is_next(parser, '-');
        parser_advance(parser);
    }
    const struct token *next = &parser->next;
    if (token_is(next, '(')) {
        if (!parser_enter(parser)) {
            *is_good = false;
            return 0;
        }
        parser_advance(parser);
        factor = parser_read_sum(parser, is_good);
        parser->depth--;
        if (token_is(next, ',') && parser->bracket->open == '[') {
            (void)scene_fail(parser->reader, next->at,
                             "an array [ ] holds plain values only: use a list ( ) here");
            parser->is_astray = true;
        } else if (!token_is(next, ')')) {
            parser_unexpected(parser, "')'");
        }
        if (parser->is_astray) {
            *is_good = false;
            parser_pass_over(parser, ";");
            parser->is_astray = !token_is(next, ')');
        }
    } else if (next->kind == TOKEN_NUMBER) {
        factor = next->number;
    } else if (next->kind == TOKEN_NAME) {
        const struct constant *constant = find_constant(parser, next);
        if (constant == NULL) {
            refuse_word(parser);
        }
        *is_good = *is_good && constant != NULL;
        factor = constant == NULL ? 0 : constant->value;
    } else if (next->kind == TOKEN_REFUSED) {
        *is_good = false;
    } else {
        parser_unexpected(parser, "a number");
    }
    *is_good = *is_good && !parser->is_astray;
    parser_advance(parser);
    return is_negative ? -factor : factor;
}

/* Takes the result of a mark, which has to be finite. */
static double check_finite(struct parser *parser, struct scene_place at, const char *what,
                           double result, bool *is_good) {
    if (!isfinite(result) && *is_good) {
        *is_good = scene_fail(parser->reader, at, "%s no finite number", what);
    }
    return *is_good ? result : 0;
}

/* Goes on with a product whose first factor has been read. */
static double go_on_with_product(struct parser *parser, double product, bool *is_good) {
    while (parser_is_next(parser, '*') || parser_is_next(parser, '/')) {
        const struct token mark = parser->next;
        const bool is_product = token_is(&mark, '*');
        parser_advance(parser);
        double factor = parse_factor(parser, is_good);
        product = check_finite(parser, mark.at,
                               is_product ? "what '*' gives here is" : "what '/' gives here is",
                               is_product ? product * factor : product / factor, is_good);
    }
    return product;
}

bool parser_goes_on(const struct parser *parser) {
    return parser_is_next(parser, '+') || parser_is_next(parser, '-') ||
           parser_is_next(parser, '*') || parser_is_next(parser, '/') ||
           (!parser->is_astray && token_is_signed_onward(&parser->scanner, &parser->next));
}

double parser_go_on_with_sum(struct parser *parser, double first, bool *is_good) {
    double sum = go_on_with_product(parser, first, is_good);
    while (parser_goes_on(parser)) {
        const struct token mark = parser->next;
        if (mark.kind == TOKEN_MARK) {
            parser_advance(parser);
        }
        double product = go_on_with_product(parser, parse_factor(parser, is_good), is_good);
        sum = check_finite(parser, mark.at, "this sum is",
                           token_is(&mark, '-') ? sum - product : sum + product, is_good);
    }
    return sum;
}

double parser_read_sum(struct parser *parser, bool *is_good) {
    return parser_go_on_with_sum(parser, parse_factor(parser, is_good), is_good);
}

void parser_read_constant(struct parser *parser) {
    const struct constant *other = find_constant(parser, &parser->next);
    struct constant *constant = parser_take_memory(parser, sizeof *constant);
    bool is_good = true;
    if (other != NULL) {
        (void)scene_fail(parser->reader, parser->next.at, "'%.*s' has its 'let' on line %u already",
                         token_shown(&parser->next), parser->next.start, other->name.at.line);
    }
    if (constant == NULL) {
        return;
    }
    constant->name = parser->next;
    constant->before = parser->constants;
    parser_advance(parser);
    if (!token_is(&parser->next, '=')) {
        parser_unexpected(parser, "'='");
    }
    parser_advance(parser);
    constant->value = parser->is_astray ? 0 : parser_read_sum(parser, &is_good);
    parser->constants = constant;
}
