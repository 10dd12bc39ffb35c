/* SPDX-License-Identifier: MIT */
/* Reads a scene's text into a tree: keys, values, brackets, and numbers that are worked out.
 *
 * What is wrong is recorded and passed over. A refused value is VALUE_REFUSED. Where a token stands
 * in a wrong place, reading goes on behind the next separator of the same bracket. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "scene/tokens.h"

enum { BRACKETS_MOST = 64 };

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

static void parse_value(struct parser *parser, struct scene_value *value);
static double parse_sum(struct parser *parser, bool *is_good);

/* Takes the next token; where the parser is astray, that token is not taken. */
static void advance(struct parser *parser) {
    if (!parser->is_astray) {
        parser->next = scanner_next(&parser->scanner);
    }
}

/* Records that the next token is not what is wanted, unless the token was refused already. */
static void unexpected(struct parser *parser, const char *wanted) {
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

static void *take_memory(struct parser *parser, size_t size) {
    static const struct scene_place nowhere = {0, 0};
    void *memory = memory_take(&parser->reader->memory, size);
    if (memory == NULL) {
        (void)scene_fail(parser->reader, nowhere, "not enough memory to read the scene");
    }
    return memory;
}

/* Tells whether the next token is a mark, where the parser is not astray. */
static bool is_next(const struct parser *parser, char mark) {
    return !parser->is_astray && token_is(&parser->next, mark);
}

/* Copies what a token spells; of a string, what stands in its quotes. */
static const char *copy_text(struct parser *parser, const struct token *token) {
    const bool is_string = token->kind == TOKEN_STRING;
    char *copy = take_memory(parser, token->length + 1);
    size_t used = 0;
    for (size_t i = is_string; copy != NULL && i + is_string < token->length; i++) {
        i += is_string && token->start[i] == '\\';
        copy[used++] = token->start[i];
    }
    return copy;
}

static bool is_closing(const struct token *token) {
    return token_is(token, '}') || token_is(token, ')') || token_is(token, ']');
}

/* Passes over tokens up to one of these marks, or to a bracket that closes. Brackets that open here
 * are passed over whole. Then the parser is no longer astray. */
static void pass_over(struct parser *parser, const char *marks) {
    const struct token *next = &parser->next;
    unsigned open = 0;
    parser->is_astray = false;
    while (next->kind != TOKEN_END) {
        const bool is_mark = next->kind == TOKEN_MARK && strchr(marks, *next->start) != NULL;
        if (open == 0 && (is_mark || is_closing(next))) {
            return;
        }
        open += token_is(next, '{') || token_is(next, '(') || token_is(next, '[');
        open -= is_closing(next);
        advance(parser);
    }
}

/* ---- Numbers -------------------------------------------------------------------------------- */

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

/* Counts one bracket or pair of parentheses more, whose first mark is the next token. */
static bool enter(struct parser *parser) {
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

/* Reads a number, the name of one, or a sum in parentheses, with signs before it. *is_good becomes
 * false where that was refused. */
static double parse_factor(struct parser *parser, bool *is_good) {
    bool is_negative = false;
    double factor = 0;
    while (is_next(parser, '-') || is_next(parser, '+')) {
        is_negative = is_negative != is_next(parser, '-');
        advance(parser);
    }
    const struct token *next = &parser->next;
    if (token_is(next, '(')) {
        if (!enter(parser)) {
            *is_good = false;
            return 0;
        }
        advance(parser);
        factor = parse_sum(parser, is_good);
        parser->depth--;
        if (token_is(next, ',') && parser->bracket->open == '[') {
            (void)scene_fail(parser->reader, next->at,
                             "an array [ ] holds plain values only: use a list ( ) here");
            parser->is_astray = true;
        } else if (!token_is(next, ')')) {
            unexpected(parser, "')'");
        }
        if (parser->is_astray) {
            *is_good = false;
            pass_over(parser, ";");
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
        unexpected(parser, "a number");
    }
    *is_good = *is_good && !parser->is_astray;
    advance(parser);
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
    while (is_next(parser, '*') || is_next(parser, '/')) {
        const struct token mark = parser->next;
        const bool is_product = token_is(&mark, '*');
        advance(parser);
        double factor = parse_factor(parser, is_good);
        product = check_finite(parser, mark.at,
                               is_product ? "what '*' gives here is" : "what '/' gives here is",
                               is_product ? product * factor : product / factor, is_good);
    }
    return product;
}

/* Tells whether a sum goes on here. In "2-1" the sign is the number's own. Such a number goes on
 * only without a blank before it: [1 -2] lacks a comma. */
static bool goes_on(const struct parser *parser) {
    return is_next(parser, '+') || is_next(parser, '-') || is_next(parser, '*') ||
           is_next(parser, '/') ||
           (!parser->is_astray && token_is_signed_onward(&parser->scanner, &parser->next));
}

/* Goes on with a sum whose first factor has been read. */
static double go_on_with_sum(struct parser *parser, double first, bool *is_good) {
    double sum = go_on_with_product(parser, first, is_good);
    while (goes_on(parser)) {
        const struct token mark = parser->next;
        if (mark.kind == TOKEN_MARK) {
            advance(parser);
        }
        double product = go_on_with_product(parser, parse_factor(parser, is_good), is_good);
        sum = check_finite(parser, mark.at, "this sum is",
                           token_is(&mark, '-') ? sum - product : sum + product, is_good);
    }
    return sum;
}

static double parse_sum(struct parser *parser, bool *is_good) {
    return go_on_with_sum(parser, parse_factor(parser, is_good), is_good);
}

/* Reads `let NAME = NUMBER`, of which `let` has been taken. A number that is refused has its name
 * all the same, so that its uses are not refused as well. */
static void parse_constant(struct parser *parser) {
    const struct constant *other = find_constant(parser, &parser->next);
    struct constant *constant = take_memory(parser, sizeof *constant);
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
    advance(parser);
    if (!token_is(&parser->next, '=')) {
        unexpected(parser, "'='");
    }
    advance(parser);
    constant->value = parser->is_astray ? 0 : parse_sum(parser, &is_good);
    parser->constants = constant;
}

/* ---- Brackets ------------------------------------------------------------------------------- */

static bool push_value(struct parser *parser, const struct scene_value *value) {
    struct scene_value *values = scene_grow(parser->reader, parser->values, parser->value_count,
                                            &parser->value_room, sizeof *values);
    if (values == NULL) {
        return false;
    }
    parser->values = values;
    parser->values[parser->value_count++] = *value;
    return true;
}

/* Puts what the innermost bracket holds into its value. */
static void gather(struct parser *parser, struct scene_value *value) {
    const size_t first = parser->bracket->first_value;
    value->count = parser->value_count - first;
    value->members = take_memory(parser, (value->count + 1) * sizeof *value->members);
    if (value->members == NULL) {
        value->count = 0;
    } else if (value->count > 0) {
        memcpy(value->members, parser->values + first, value->count * sizeof *value->members);
    }
    parser->value_count = first;
}

/* Goes on to the next separator of what `value` holds. */
static void find_way(struct parser *parser, struct scene_value *value) {
    value->is_partial = true;
    pass_over(parser, value->kind == VALUE_GROUP ? ";" : ";,");
}

/* Ends the innermost bracket by the next token. Where that is a wrong bracket, an outer bracket may
 * wait for it, and takes it. Otherwise it is taken for the right one. Returns false where no
 * bracket is open. */
static bool close_bracket(struct parser *parser, struct scene_value *value) {
    const struct bracket *bracket = parser->bracket, *waiting = bracket;
    const struct token *next = &parser->next;
    if (next->kind == TOKEN_END) {
        if (bracket->open != '\0' && !parser->is_unclosed && !parser->scanner.is_cut) {
            (void)scene_fail(parser->reader, bracket->at,
                             "this '%c' is never closed: '%c' is missing", bracket->open,
                             bracket->close);
            parser->is_unclosed = true; /* which is said of the innermost one alone */
        }
        value->is_partial = value->is_partial || bracket->open != '\0';
        return true;
    }
    while (waiting != NULL && waiting->close != *next->start) {
        waiting = waiting->outer;
    }
    if (bracket->open == '\0') {
        (void)scene_fail(parser->reader, next->at, "'%c' closes nothing: no bracket is open",
                         *next->start);
    } else if (waiting != bracket) {
        (void)scene_fail(parser->reader, next->at,
                         "'%c' cannot close the '%c' of line %u: '%c' is wanted first",
                         *next->start, bracket->open, bracket->at.line, bracket->close);
    }
    value->is_partial = value->is_partial || waiting != bracket;
    if (waiting == bracket || waiting == NULL) {
        advance(parser);
    }
    return bracket->open != '\0';
}

/* Tells whether the next token ends a bracket, this one or an outer one. */
static bool is_at_end(const struct parser *parser) {
    return is_closing(&parser->next) || parser->next.kind == TOKEN_END;
}

/* Reads what stands where a key is wanted, but is none. `before` is the number before it, where
 * that has a ',' behind it. */
static void refuse_key(struct parser *parser, const struct token *before) {
    const struct token *next = &parser->next;
    if (next->kind == TOKEN_NUMBER && before->kind == TOKEN_NUMBER) {
        (void)scene_fail(parser->reader, before->at,
                         "'%.*s,%.*s' is no number: the decimal point is a dot, as in %.*s.%.*s",
                         token_shown(before), before->start, token_shown(next), next->start,
                         token_shown(before), before->start, token_shown(next), next->start);
        parser->is_astray = true;
    } else if (next->kind == TOKEN_BOOLEAN) {
        (void)scene_fail(parser->reader, next->at, "'%.*s' is a value: it can be no key",
                         token_shown(next), next->start);
        parser->is_astray = true;
    } else {
        unexpected(parser, "a key");
    }
}

/* Checks that the innermost group has no other member of this key. */
static bool check_new(struct parser *parser, const struct token *key) {
    for (size_t i = parser->bracket->first_value; i < parser->value_count; i++) {
        const struct scene_value *other = &parser->values[i];
        if (token_spells(key, other->name)) {
            return scene_fail(parser->reader, key->at,
                              "duplicate key '%.*s': it is already given on line %u, and each key "
                              "is allowed once",
                              token_shown(key), key->start, other->at.line);
        }
    }
    return true;
}

/* Checks that a member ends here. Where a refused value stands, that is not said once more. */
static void check_member_end(struct parser *parser, struct scene_value *value) {
    if (!is_next(parser, ';') && !is_next(parser, ',') && !is_at_end(parser) &&
        parser->next.kind != TOKEN_NAME && parser->next.kind != TOKEN_BOOLEAN) {
        if (value->kind != VALUE_REFUSED) {
            unexpected(parser, "';'");
        }
        parser->is_astray = true;
    }
    if (parser->is_astray) {
        value->kind = VALUE_REFUSED;
    }
}

/* Reads `KEY = VALUE` and the separator behind it. *before becomes the value's token, where that is
 * one number with a ',' behind it. */
static void parse_member(struct parser *parser, struct token *before) {
    const struct token key = parser->next;
    struct scene_value value = {.kind = VALUE_REFUSED};
    advance(parser);
    if (token_spells(&key, "let") && parser->next.kind == TOKEN_NAME) {
        parse_constant(parser);
        value.kind = VALUE_NUMBER;
        check_member_end(parser, &value);
    } else if (!token_is(&parser->next, '=') && !token_is(&parser->next, ':')) {
        (void)scene_fail(parser->reader, parser->next.at, "'=' is missing after the key '%.*s'",
                         token_shown(&key), key.start);
        parser->is_astray = true;
    } else {
        advance(parser);
        *before = parser->next;
        parse_value(parser, &value);
        value.at = key.at;
        value.name = copy_text(parser, &key);
        check_member_end(parser, &value);
        if (value.name != NULL && check_new(parser, &key)) {
            (void)push_value(parser, &value);
        }
    }
    if (!token_is(&parser->next, ',')) {
        before->kind = TOKEN_END;
    }
    if (is_next(parser, ';') || is_next(parser, ',')) {
        advance(parser);
    }
}

/* Reads the members of a group up to its end. */
static void parse_members(struct parser *parser, struct scene_value *group) {
    struct token before = {.kind = TOKEN_END};
    for (;;) {
        if (parser->is_astray) {
            find_way(parser, group);
            while (token_is(&parser->next, ';')) {
                advance(parser);
            }
        }
        if (is_at_end(parser)) {
            if (close_bracket(parser, group)) {
                return;
            }
            parser->is_astray = true;
        } else if (parser->next.kind == TOKEN_NAME) {
            parse_member(parser, &before);
        } else {
            refuse_key(parser, &before);
        }
    }
}

/* Checks that an array holds values of one type only: numbers, strings or truths. */
static void check_type(struct parser *parser, const struct token *token,
                       struct scene_value *element) {
    const struct scene_value *other = parser->values + parser->bracket->first_value;
    const struct scene_value *end = parser->values + parser->value_count;
    while (other < end && other->kind == VALUE_REFUSED) {
        other++;
    }
    if (other < end && element->kind != VALUE_REFUSED && element->kind != other->kind) {
        (void)scene_fail(parser->reader, token->at,
                         "an array [ ] holds values of one type only: '%.*s' is of another",
                         token_shown(token), token->start);
        element->kind = VALUE_REFUSED;
    }
}

/* Reads the elements of a list or an array up to its end. */
static void parse_elements(struct parser *parser, struct scene_value *list) {
    const char close = parser->bracket->close;
    bool is_first = true;
    for (;; is_first = false) {
        if (!is_at_end(parser)) {
            const struct token token = parser->next;
            struct scene_value element = {.kind = VALUE_REFUSED};
            parse_value(parser, &element);
            element.at = token.at;
            if (list->kind == VALUE_ARRAY) {
                check_type(parser, &token, &element);
            }
            (void)push_value(parser, &element);
            list->is_partial = list->is_partial || element.kind == VALUE_REFUSED;
            if (!token_is(&parser->next, ',') && !is_at_end(parser)) {
                if (element.kind != VALUE_REFUSED) {
                    unexpected(parser, close == ')' ? "',' or ')'" : "',' or ']'");
                }
                /* A group behind a group is an element, whose ',' is missing. */
                parser->is_astray = element.kind != VALUE_GROUP || !token_is(&parser->next, '{');
                if (!parser->is_astray) {
                    continue;
                }
            }
        } else if (!is_first && token_is(&parser->next, close)) {
            (void)scene_fail(parser->reader, parser->next.at,
                             "a ',' too many before '%c': the last element has none", close);
        }
        if (parser->is_astray) {
            find_way(parser, list);
        }
        if (token_is(&parser->next, ',')) {
            advance(parser);
        } else if (token_is(&parser->next, ';')) {
            if (parser->values[parser->value_count - 1].kind != VALUE_GROUP) {
                parser->is_astray = true; /* the list was never closed */
                return;
            }
            advance(parser); /* meant as ',' */
        } else if (close_bracket(parser, list)) {
            return;
        }
    }
}

/* Reads a group, a list or an array, whose first mark is the next token. */
static void parse_bracket(struct parser *parser, struct scene_value *value) {
    const char open = *parser->next.start;
    const struct bracket bracket = {.outer = parser->bracket,
                                    .at = parser->next.at,
                                    .open = open,
                                    .close = open == '{'   ? '}'
                                             : open == '(' ? ')'
                                                           : ']',
                                    .first_value = parser->value_count};
    if (!enter(parser)) {
        return;
    }
    value->kind = open == '{' ? VALUE_GROUP : open == '(' ? VALUE_LIST : VALUE_ARRAY;
    parser->bracket = &bracket;
    advance(parser);
    if (open == '{') {
        parse_members(parser, value);
    } else {
        parse_elements(parser, value);
    }
    gather(parser, value);
    parser->bracket = bracket.outer;
    parser->depth--;
    const struct scene_value *sole = value; /* `((a + b)) / 2` */
    while (sole->kind == VALUE_LIST && sole->count == 1) {
        sole = sole->members;
    }
    if (sole != value && goes_on(parser) &&
        (sole->kind == VALUE_NUMBER || sole->kind == VALUE_REFUSED)) {
        bool is_good = sole->kind == VALUE_NUMBER;
        value->number = go_on_with_sum(parser, sole->number, &is_good);
        value->kind = is_good ? VALUE_NUMBER : VALUE_REFUSED;
    }
}

/* Reads a value. A refused one stays VALUE_REFUSED. */
static void parse_value(struct parser *parser, struct scene_value *value) {
    const struct token *next = &parser->next;
    const bool is_in_array = parser->bracket->open == '[';
    bool is_good = true;
    if (token_is(next, '{') || token_is(next, '[') || (token_is(next, '(') && !is_in_array)) {
        if (is_in_array) {
            (void)scene_fail(parser->reader, next->at,
                             "an array [ ] holds plain values only: use a list ( ) here");
            parser->is_astray = true;
        } else {
            parse_bracket(parser, value);
        }
    } else if (next->kind == TOKEN_STRING || next->kind == TOKEN_BOOLEAN) {
        value->kind = next->kind == TOKEN_STRING ? VALUE_STRING : VALUE_BOOLEAN;
        value->truth = next->length == 4;
        value->text = next->kind == TOKEN_STRING ? copy_text(parser, next) : NULL;
        advance(parser);
    } else if (next->kind == TOKEN_NUMBER || next->kind == TOKEN_NAME || token_is(next, '+') ||
               token_is(next, '-') || token_is(next, '(')) {
        value->number = parse_sum(parser, &is_good);
        value->kind = is_good ? VALUE_NUMBER : VALUE_REFUSED;
    } else if (next->kind == TOKEN_REFUSED) {
        advance(parser);
    } else {
        unexpected(parser, "a value");
    }
}

void scene_parse(struct scene_reader *reader, const char *text, size_t length,
                 struct scene_value *root) {
    const struct bracket file = {.outer = NULL};
    struct parser parser = {
        .reader = reader,
        .scanner = {.reader = reader, .text = text, .length = length, .line = 1},
        .bracket = &file};
    *root = (struct scene_value){.kind = VALUE_GROUP, .at = {1, 1}};
    parser.next = scanner_next(&parser.scanner);
    parse_members(&parser, root);
    gather(&parser, root);
    root->is_partial = root->is_partial || parser.scanner.is_cut || parser.is_unclosed;
    free(parser.values);
}
