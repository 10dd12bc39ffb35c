/* SPDX-License-Identifier: MIT */
/* Reads a scene's text into a tree: keys, values, brackets, and sums of numbers.
 *
 * An error is recorded, and the parser goes on. A refused value is VALUE_REFUSED. Where a token
 * stands in a wrong place, reading goes on behind the next separator of the same bracket. */
#include <stdlib.h>
#include <string.h>

#include "scene/parser_internal.h"

static void parse_value(struct parser *parser, struct scene_value *value);

/* Copies what a token spells; of a string, what stands in its quotes. */
static const char *copy_text(struct parser *parser, const struct token *token) {
    const bool is_string = token->kind == TOKEN_STRING;
    char *copy = parser_take_memory(parser, token->length + 1);
    size_t used = 0;
    for (size_t i = is_string; copy != NULL && i + is_string < token->length; i++) {
        i += is_string && token->start[i] == '\\';
        copy[used++] = token->start[i];
    }
    return copy;
}

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
    value->members = parser_take_memory(parser, (value->count + 1) * sizeof *value->members);
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
    parser_pass_over(parser, value->kind == VALUE_GROUP ? ";" : ";,");
}

/* Ends the innermost bracket by the next token. Where that is a wrong bracket, an outer bracket may
 * wait for it, and takes it. Otherwise it is taken for the right one. Returns false where no
 * bracket is open. */
static bool close_bracket(struct parser *parser, struct scene_value *value) {
    const struct bracket *bracket = parser->bracket, *waiting = bracket->outer;
    const struct token *next = &parser->next;
    if (token_is(next, bracket->close)) {
        parser_advance(parser);
        return true;
    }
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
    value->is_partial = true;
    if (bracket->open == '\0') {
        (void)scene_fail(parser->reader, next->at, "'%c' closes nothing: no bracket is open",
                         *next->start);
        parser_advance(parser);
        return false;
    }
    (void)scene_fail(parser->reader, next->at,
                     "'%c' cannot close the '%c' of line %u: '%c' is wanted first", *next->start,
                     bracket->open, bracket->at.line, bracket->close);
    while (waiting != NULL && waiting->close != *next->start) {
        waiting = waiting->outer;
    }
    if (waiting == NULL) {
        parser_advance(parser);
    }
    return true;
}

/* Tells whether the next token ends a bracket, this one or an outer one. */
static bool is_at_end(const struct parser *parser) {
    return token_closes(&parser->next) || parser->next.kind == TOKEN_END;
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
        parser_unexpected(parser, "a key");
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
    if (!parser_is_next(parser, ';') && !parser_is_next(parser, ',') && !is_at_end(parser) &&
        parser->next.kind != TOKEN_NAME && parser->next.kind != TOKEN_BOOLEAN) {
        if (value->kind != VALUE_REFUSED) {
            parser_unexpected(parser, "';'");
        }
        parser->is_astray = true;
    }
    if (parser->is_astray && value->count > 0) {
        value->is_partial = true;
    } else if (parser->is_astray) {
        value->kind = VALUE_REFUSED;
    }
}

/* Reads `KEY = VALUE` and the separator behind it. *before becomes the value's token, where that is
 * one number with a ',' behind it. */
static void parse_member(struct parser *parser, struct token *before) {
    const struct token key = parser->next;
    struct scene_value value = {.kind = VALUE_REFUSED};
    parser_advance(parser);
    if (token_spells(&key, "let") && parser->next.kind == TOKEN_NAME) {
        parser_read_constant(parser);
        value.kind = VALUE_NUMBER;
        check_member_end(parser, &value);
    } else if (!token_is(&parser->next, '=') && !token_is(&parser->next, ':')) {
        (void)scene_fail(parser->reader, parser->next.at, "'=' is missing after the key '%.*s'",
                         token_shown(&key), key.start);
        parser->is_astray = true;
    } else {
        parser_advance(parser);
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
    if (parser_is_next(parser, ';') || parser_is_next(parser, ',')) {
        parser_advance(parser);
    }
}

/* Reads the members of a group up to its end. */
static void parse_members(struct parser *parser, struct scene_value *group) {
    struct token before = {.kind = TOKEN_END};
    for (;;) {
        if (parser->is_astray) {
            find_way(parser, group);
            while (token_is(&parser->next, ';')) {
                parser_advance(parser);
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
    size_t first = parser->bracket->first_value;
    while (first < parser->value_count && parser->values[first].kind == VALUE_REFUSED) {
        first++;
    }
    if (first < parser->value_count && element->kind != VALUE_REFUSED &&
        element->kind != parser->values[first].kind) {
        (void)scene_fail(parser->reader, token->at,
                         "an array [ ] holds values of one type only: '%.*s' is of another",
                         token_shown(token), token->start);
        element->kind = VALUE_REFUSED;
    }
}

/* Reads the elements of a list or an array up to its end. */
static void parse_elements(struct parser *parser, struct scene_value *list) {
    const char close = parser->bracket->close;
    struct scene_value element = {.kind = VALUE_REFUSED};
    bool is_first = true;
    for (;; is_first = false) {
        if (!is_at_end(parser)) {
            const struct token token = parser->next;
            element = (struct scene_value){.kind = VALUE_REFUSED};
            parse_value(parser, &element);
            element.at = token.at;
            if (list->kind == VALUE_ARRAY) {
                check_type(parser, &token, &element);
            }
            (void)push_value(parser, &element);
            list->is_partial = list->is_partial || element.kind == VALUE_REFUSED;
            if (!token_is(&parser->next, ',') && !is_at_end(parser)) {
                if (element.kind != VALUE_REFUSED) {
                    parser_unexpected(parser, close == ')' ? "',' or ')'" : "',' or ']'");
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
            parser_advance(parser);
        } else if (token_is(&parser->next, ';')) {
            if (element.kind != VALUE_GROUP) {
                parser->is_astray = true; /* the list was never closed */
                return;
            }
            parser_advance(parser); /* meant as ',' */
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
    if (!parser_enter(parser)) {
        return;
    }
    value->kind = open == '{' ? VALUE_GROUP : open == '(' ? VALUE_LIST : VALUE_ARRAY;
    parser->bracket = &bracket;
    parser_advance(parser);
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
    if (sole != value && parser_goes_on(parser) &&
        (sole->kind == VALUE_NUMBER || sole->kind == VALUE_REFUSED)) {
        bool is_good = sole->kind == VALUE_NUMBER;
        value->number = parser_go_on_with_sum(parser, sole->number, &is_good);
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
        parser_advance(parser);
    } else if (next->kind == TOKEN_NUMBER || next->kind == TOKEN_NAME || token_is(next, '+') ||
               token_is(next, '-') || token_is(next, '(')) {
        value->number = parser_read_sum(parser, &is_good);
        value->kind = is_good ? VALUE_NUMBER : VALUE_REFUSED;
    } else if (next->kind == TOKEN_REFUSED) {
        parser_advance(parser);
    } else {
        parser_unexpected(parser, "a value");
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
