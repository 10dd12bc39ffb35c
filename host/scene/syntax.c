/* SPDX-License-Identifier: MIT */
/* Reads a scene's text into a tree: brackets, separators, keys, values and small arithmetic. */
#include <stdlib.h>
#include <string.h>

#include "scene/parser_internal.h"

static bool is_group(const struct bracket *bracket) {
    return bracket->open == '{' || bracket->open == '\0';
}

static char closing(char open) {
    return open == '{' ? '}' : open == '(' ? ')' : ']';
}

static bool is_closing(const struct token *token) {
    return token_is(token, '}') || token_is(token, ')') || token_is(token, ']');
}

static bool unclosed(struct parser *parser) {
    const struct bracket *bracket = &parser->stack[parser->depth];
    return scene_fail(parser->reader, bracket->line, "this '%c' is never closed: '%c' is missing",
                      bracket->open, closing(bracket->open));
}

/* ---- The tree ------------------------------------------------------------------------------- */

/* Returns a value of a kind in the innermost open bracket: with its key there, or of this line. */
static struct scene_value value_at(const struct parser *parser, enum value_kind kind,
                                   unsigned line) {
    struct scene_value value = {.kind = kind, .line = line};
    if (is_group(&parser->stack[parser->depth])) {
        value.name = parser->key_name;
        value.line = parser->key.line;
    }
    return value;
}

static bool push_value(struct parser *parser, const struct scene_value *value) {
    if (parser->value_count == parser->value_room) {
        size_t room = parser->value_room == 0 ? 64 : 2 * parser->value_room;
        struct scene_value *larger = realloc(parser->values, room * sizeof *larger);
        if (larger == NULL) {
            return scene_fail(parser->reader, 1, "not enough memory to read the scene");
        }
        parser->values = larger;
        parser->value_room = room;
    }
    parser->values[parser->value_count++] = *value;
    return true;
}

/* Puts what the innermost bracket holds into a value of its own. */
static bool gather(struct parser *parser, struct scene_value *value) {
    const size_t first = parser->stack[parser->depth].first_value;
    value->count = parser->value_count - first;
    if (value->count > 0) {
        struct scene_value *members = take_memory(parser, value->count * sizeof *members);
        if (members == NULL) {
            return false;
        }
        memcpy(members, parser->values + first, value->count * sizeof *members);
        value->members = members;
    }
    parser->value_count = first;
    return true;
}

/* Takes the number that begins with this token. */
static bool take_number(struct parser *parser, const struct token *token) {
    struct scene_value value = value_at(parser, VALUE_NUMBER, token->line);
    return read_number(parser, token, &value.number) && push_value(parser, &value);
}

/* ---- Keys and brackets ---------------------------------------------------------------------- */

static bool take_key(struct parser *parser, const struct token *token) {
    struct bracket *group = &parser->stack[parser->depth];
    struct token next;
    if (!peek(parser, &next)) {
        return false;
    }
    if (next.kind == TOKEN_NAME && token->length == 3 && memcmp(token->start, "let", 3) == 0) {
        parser->has_next = false;
        parser->value.kind = TOKEN_END;
        parser->expectation = AFTER_VALUE;
        return read_constant(parser, &next);
    }
    for (size_t i = group->first_key; i < parser->key_count; i++) {
        const struct token *other = &parser->keys[i];
        if (other->length == token->length &&
            memcmp(other->start, token->start, token->length) == 0) {
            return scene_fail(parser->reader, token->line,
                              "duplicate key '%.*s': it is already given on line %u, and each key "
                              "is allowed once",
                              token_shown(token), token->start, other->line);
        }
    }
    if (++group->count > SCENE_KEYS_MOST) {
        return scene_fail(parser->reader, token->line,
                          "too many keys in one group: at most %d are allowed", SCENE_KEYS_MOST);
    }
    parser->keys[parser->key_count++] = *token;
    parser->key = *token;
    parser->key_name = copy_text(parser, token);
    parser->expectation = WANT_EQUALS;
    return parser->key_name != NULL;
}

/* Makes a number of a list of one number behind which arithmetic goes on: `(a + b) / 2`. */
static bool end_parentheses(struct parser *parser, struct scene_value *value) {
    struct token next;
    if (value->kind != VALUE_LIST || value->count != 1 || value->members[0].kind != VALUE_NUMBER) {
        return true;
    }
    if (!peek(parser, &next)) {
        return false;
    }
    if (!token_is(&next, '*') && !token_is(&next, '/') && !token_is(&next, '+') &&
        !token_is(&next, '-')) {
        return true;
    }
    const double first = value->members[0].number;
    value->kind = VALUE_NUMBER;
    value->members = NULL;
    value->count = 0;
    return go_on_with_sum(parser, first, &value->number);
}

static bool close_bracket(struct parser *parser, const struct token *token) {
    struct bracket *bracket = &parser->stack[parser->depth];
    if (bracket->open == '\0') {
        return scene_fail(parser->reader, token->line, "'%c' closes nothing: no bracket is open",
                          *token->start);
    }
    if (*token->start != closing(bracket->open)) {
        return scene_fail(parser->reader, token->line,
                          "'%c' cannot close the '%c' of line %u: '%c' is wanted first",
                          *token->start, bracket->open, bracket->line, closing(bracket->open));
    }
    if (is_group(bracket)) {
        parser->key_count = bracket->first_key;
    }
    struct scene_value value = bracket->itself;
    if (!gather(parser, &value)) {
        return false;
    }
    parser->depth--;
    parser->value.kind = TOKEN_END;
    parser->expectation = AFTER_VALUE;
    return end_parentheses(parser, &value) && push_value(parser, &value);
}

static bool open_bracket(struct parser *parser, const struct token *token) {
    if (parser->stack[parser->depth].open == '[') {
        return only_plain(parser, token);
    }
    if (parser->depth == SCENE_BRACKETS_MOST) {
        return scene_fail(parser->reader, token->line,
                          "brackets nest too deep: at most %d levels are allowed; named parts "
                          "make a scene flatter",
                          SCENE_BRACKETS_MOST);
    }
    const enum value_kind kind = *token->start == '{'   ? VALUE_GROUP
                                 : *token->start == '(' ? VALUE_LIST
                                                        : VALUE_ARRAY;
    const struct bracket opened = {.open = *token->start,
                                   .line = token->line,
                                   .first_key = parser->key_count,
                                   .element = TOKEN_END,
                                   .first_value = parser->value_count,
                                   .itself = value_at(parser, kind, token->line)};
    parser->stack[++parser->depth] = opened;
    parser->expectation = *token->start == '{' ? WANT_KEY : WANT_FIRST_VALUE;
    return true;
}

/* Checks that an array holds values of one type only: numbers, strings or truths. */
static bool fits_array(struct parser *parser, struct bracket *array, const struct token *token) {
    const bool is_plain = token->kind == TOKEN_STRING || token->kind == TOKEN_BOOLEAN;
    const enum token_kind kind = is_plain ? token->kind : TOKEN_FLOAT;
    if (array->element == TOKEN_END) {
        array->element = kind;
    }
    return array->element == kind ||
           scene_fail(parser->reader, token->line,
                      "an array [ ] holds values of one type only: '%.*s' is of another",
                      token_shown(token), token->start);
}

/* Takes a string, or true or false. */
static bool take_plain(struct parser *parser, const struct token *token) {
    const bool is_string = token->kind == TOKEN_STRING;
    struct scene_value value =
        value_at(parser, is_string ? VALUE_STRING : VALUE_BOOLEAN, token->line);
    value.truth = token->length == 4;
    if (is_string && (value.text = copy_text(parser, token)) == NULL) {
        return false;
    }
    return push_value(parser, &value);
}

static bool take_value(struct parser *parser, const struct token *token) {
    struct bracket *bracket = &parser->stack[parser->depth];
    if (is_closing(token) && parser->expectation == WANT_FIRST_VALUE) {
        return close_bracket(parser, token);
    }
    if (!is_group(bracket) && token_is(token, closing(bracket->open))) {
        return scene_fail(parser->reader, token->line,
                          "a ',' too many before '%c': the last element has none", *token->start);
    }
    if (!is_group(bracket) && ++bracket->count > SCENE_ELEMENTS_MOST) {
        return scene_fail(parser->reader, token->line,
                          "too many elements in one list: at most %d are allowed",
                          SCENE_ELEMENTS_MOST);
    }
    bool is_number = bracket->open == '[' && token_is(token, '('); /* in parentheses */
    if (!is_number && (token_is(token, '{') || token_is(token, '(') || token_is(token, '['))) {
        return open_bracket(parser, token);
    }
    if (token->kind == TOKEN_NAME && find_constant(parser, token) == NULL) {
        return refuse_word(parser, token);
    }
    if (token->kind == TOKEN_END && !is_group(bracket)) {
        return unclosed(parser);
    }
    bool is_sign = token_is(token, '+') || token_is(token, '-');
    if ((token->kind == TOKEN_MARK && !is_sign && !is_number) || token->kind == TOKEN_END) {
        return unexpected(parser, token, "a value");
    }
    if (bracket->open == '[' && !fits_array(parser, bracket, token)) {
        return false;
    }
    parser->value = *token;
    parser->expectation = AFTER_VALUE;
    return token->kind == TOKEN_STRING || token->kind == TOKEN_BOOLEAN ? take_plain(parser, token)
                                                                       : take_number(parser, token);
}

/* Refuses a token that stands where a key or a separator is wanted. */
static bool missing_separator(struct parser *parser, const struct token *token) {
    const struct token *value = &parser->value;
    bool after_comma = parser->expectation == WANT_KEY && token_is(&parser->separator, ',');
    if (token_is_number(token) && after_comma && token_is_number(value)) {
        return scene_fail(parser->reader, token->line,
                          "'%.*s,%.*s' is no number: the decimal point is a dot, as in %.*s.%.*s",
                          token_shown(value), value->start, token_shown(token), token->start,
                          token_shown(value), value->start, token_shown(token), token->start);
    }
    if (parser->expectation == AFTER_VALUE) {
        char open = parser->stack[parser->depth].open;
        return unexpected(parser, token,
                          open == '('   ? "',' or ')'"
                          : open == '[' ? "',' or ']'"
                                        : "';'");
    }
    return unexpected(parser, token, "a key");
}

static bool take_key_or_end(struct parser *parser, const struct token *token) {
    const struct bracket *bracket = &parser->stack[parser->depth];
    if (token->kind == TOKEN_NAME) {
        return take_key(parser, token);
    }
    if (token->kind == TOKEN_BOOLEAN) {
        return scene_fail(parser->reader, token->line, "'%.*s' is a value: it can be no key",
                          token_shown(token), token->start);
    }
    if (is_closing(token)) {
        return close_bracket(parser, token);
    }
    if (token->kind == TOKEN_END) {
        if (bracket->open == '\0') {
            return true;
        }
        return unclosed(parser);
    }
    return missing_separator(parser, token);
}

static bool take_after_value(struct parser *parser, const struct token *token) {
    const struct bracket *bracket = &parser->stack[parser->depth];
    if (is_group(bracket)) {
        if (token_is(token, ';') || token_is(token, ',')) {
            parser->separator = *token;
            parser->expectation = WANT_KEY;
            return true;
        }
        return take_key_or_end(parser, token);
    }
    if (token_is(token, ',')) {
        parser->expectation = WANT_VALUE;
        return true;
    }
    if (token->kind == TOKEN_NAME || token->kind == TOKEN_BOOLEAN) {
        return missing_separator(parser, token);
    }
    return take_key_or_end(parser, token);
}

static bool take(struct parser *parser, const struct token *token) {
    switch (parser->expectation) {
    case WANT_KEY:
        return take_key_or_end(parser, token);
    case WANT_EQUALS:
        if (!token_is(token, '=') && !token_is(token, ':')) {
            return scene_fail(parser->reader, token->line, "'=' is missing after the key '%.*s'",
                              token_shown(&parser->key), parser->key.start);
        }
        parser->expectation = WANT_VALUE;
        return true;
    case WANT_VALUE:
    case WANT_FIRST_VALUE:
        return take_value(parser, token);
    case AFTER_VALUE:
        return take_after_value(parser, token);
    }
    return false;
}

static bool parse_tokens(struct parser *parser) {
    struct token token;
    bool sound = true;
    do {
        sound = next_token(parser, &token) && take(parser, &token);
    } while (sound && token.kind != TOKEN_END);
    return sound;
}

/* Checks what no token can hold. */
static bool check_bytes(struct scene_reader *reader, const char *text, size_t length) {
    if (length > SCENE_TEXT_MOST) {
        return scene_fail(reader, 1, "a scene of %zu bytes is too large: at most %d are allowed",
                          length, SCENE_TEXT_MOST);
    }
    unsigned line = 1;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '\0') {
            return scene_fail(reader, line, "a NUL byte: a scene is plain text");
        }
        line += text[i] == '\n';
    }
    return true;
}

bool scene_parse(struct scene_reader *reader, const char *text, size_t length,
                 struct scene_value *root) {
    if (!check_bytes(reader, text, length)) {
        return false;
    }
    struct parser parser = {.reader = reader};
    char *copy = take_memory(&parser, length + 1);
    if (copy == NULL) {
        return false;
    }
    memcpy(copy, text, length);
    if (length >= 3 && memcmp(copy, "\xEF\xBB\xBF", 3) == 0) {
        memset(copy, ' ', 3); /* some editors' byte order mark */
    }
    const struct scanner scanner = {reader, copy, length, 0, 1};
    const size_t keys_most = (size_t)(SCENE_BRACKETS_MOST + 1) * SCENE_KEYS_MOST;
    const struct scene_value whole = {.kind = VALUE_GROUP, .line = 1};
    parser.scanner = scanner;
    parser.keys = scene_allocate(reader, keys_most, sizeof *parser.keys);
    *root = whole;
    bool sound = parser.keys != NULL && parse_tokens(&parser) && gather(&parser, root);
    free(parser.keys);
    free(parser.values);
    return sound;
}
