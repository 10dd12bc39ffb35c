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

static bool unclosed(struct checker *checker) {
    const struct bracket *bracket = &checker->stack[checker->depth];
    return scene_fail(checker->reader, bracket->line, "this '%c' is never closed: '%c' is missing",
                      bracket->open, closing(bracket->open));
}

/* ---- The tree ------------------------------------------------------------------------------- */

/* Returns a value of a kind in the innermost open bracket: with its key there, or of this line. */
static struct scene_value value_at(const struct checker *checker, enum value_kind kind,
                                   unsigned line) {
    struct scene_value value = {.kind = kind, .line = line};
    if (is_group(&checker->stack[checker->depth])) {
        value.name = checker->key_name;
        value.line = checker->key.line;
    }
    return value;
}

static bool push_value(struct checker *checker, const struct scene_value *value) {
    if (checker->value_count == checker->value_room) {
        size_t room = checker->value_room == 0 ? 64 : 2 * checker->value_room;
        struct scene_value *larger = realloc(checker->values, room * sizeof *larger);
        if (larger == NULL) {
            return scene_fail(checker->reader, 1, "not enough memory to read the scene");
        }
        checker->values = larger;
        checker->value_room = room;
    }
    checker->values[checker->value_count++] = *value;
    return true;
}

/* Puts what the innermost bracket holds into a value of its own. */
static bool gather(struct checker *checker, struct scene_value *value) {
    const size_t first = checker->stack[checker->depth].first_value;
    value->count = checker->value_count - first;
    if (value->count > 0) {
        struct scene_value *members = take_memory(checker, value->count * sizeof *members);
        if (members == NULL) {
            return false;
        }
        memcpy(members, checker->values + first, value->count * sizeof *members);
        value->members = members;
    }
    checker->value_count = first;
    return true;
}

/* Takes the number that begins with this token. */
static bool take_number(struct checker *checker, const struct token *token) {
    struct scene_value value = value_at(checker, VALUE_NUMBER, token->line);
    return read_number(checker, token, &value.number) && push_value(checker, &value);
}

/* ---- Keys and brackets ---------------------------------------------------------------------- */

static bool take_key(struct checker *checker, const struct token *token) {
    struct bracket *group = &checker->stack[checker->depth];
    struct token next;
    if (!peek(checker, &next)) {
        return false;
    }
    if (next.kind == TOKEN_NAME && token->length == 3 && memcmp(token->start, "let", 3) == 0) {
        checker->has_next = false;
        checker->value.kind = TOKEN_END;
        checker->expectation = AFTER_VALUE;
        return read_constant(checker, &next);
    }
    for (size_t i = group->first_key; i < checker->key_count; i++) {
        const struct token *other = &checker->keys[i];
        if (other->length == token->length &&
            memcmp(other->start, token->start, token->length) == 0) {
            return scene_fail(checker->reader, token->line,
                              "duplicate key '%.*s': it is already given on line %u, and each key "
                              "is allowed once",
                              token_shown(token), token->start, other->line);
        }
    }
    if (++group->count > SCENE_KEYS_MOST) {
        return scene_fail(checker->reader, token->line,
                          "too many keys in one group: at most %d are allowed", SCENE_KEYS_MOST);
    }
    checker->keys[checker->key_count++] = *token;
    checker->key = *token;
    checker->key_name = copy_text(checker, token);
    checker->expectation = WANT_EQUALS;
    return checker->key_name != NULL;
}

/* Makes a number of a list of one number behind which arithmetic goes on: `(a + b) / 2`. */
static bool end_parentheses(struct checker *checker, struct scene_value *value) {
    struct token next;
    if (value->kind != VALUE_LIST || value->count != 1 || value->members[0].kind != VALUE_NUMBER) {
        return true;
    }
    if (!peek(checker, &next)) {
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
    return go_on_with_sum(checker, first, &value->number);
}

static bool close_bracket(struct checker *checker, const struct token *token) {
    struct bracket *bracket = &checker->stack[checker->depth];
    if (bracket->open == '\0') {
        return scene_fail(checker->reader, token->line, "'%c' closes nothing: no bracket is open",
                          *token->start);
    }
    if (*token->start != closing(bracket->open)) {
        return scene_fail(checker->reader, token->line,
                          "'%c' cannot close the '%c' of line %u: '%c' is wanted first",
                          *token->start, bracket->open, bracket->line, closing(bracket->open));
    }
    if (is_group(bracket)) {
        checker->key_count = bracket->first_key;
    }
    struct scene_value value = bracket->itself;
    if (!gather(checker, &value)) {
        return false;
    }
    checker->depth--;
    checker->value.kind = TOKEN_END;
    checker->expectation = AFTER_VALUE;
    return end_parentheses(checker, &value) && push_value(checker, &value);
}

static bool open_bracket(struct checker *checker, const struct token *token) {
    if (checker->stack[checker->depth].open == '[') {
        return only_plain(checker, token);
    }
    if (checker->depth == SCENE_BRACKETS_MOST) {
        return scene_fail(checker->reader, token->line,
                          "brackets nest too deep: at most %d levels are allowed; named parts "
                          "make a scene flatter",
                          SCENE_BRACKETS_MOST);
    }
    const enum value_kind kind = *token->start == '{'   ? VALUE_GROUP
                                 : *token->start == '(' ? VALUE_LIST
                                                        : VALUE_ARRAY;
    const struct bracket opened = {.open = *token->start,
                                   .line = token->line,
                                   .first_key = checker->key_count,
                                   .element = TOKEN_END,
                                   .first_value = checker->value_count,
                                   .itself = value_at(checker, kind, token->line)};
    checker->stack[++checker->depth] = opened;
    checker->expectation = *token->start == '{' ? WANT_KEY : WANT_FIRST_VALUE;
    return true;
}

/* Checks that an array holds values of one type only: numbers, strings or truths. */
static bool fits_array(struct checker *checker, struct bracket *array, const struct token *token) {
    const bool is_plain = token->kind == TOKEN_STRING || token->kind == TOKEN_BOOLEAN;
    const enum token_kind kind = is_plain ? token->kind : TOKEN_FLOAT;
    if (array->element == TOKEN_END) {
        array->element = kind;
    }
    return array->element == kind ||
           scene_fail(checker->reader, token->line,
                      "an array [ ] holds values of one type only: '%.*s' is of another",
                      token_shown(token), token->start);
}

/* Takes a string, or true or false. */
static bool take_plain(struct checker *checker, const struct token *token) {
    const bool is_string = token->kind == TOKEN_STRING;
    struct scene_value value =
        value_at(checker, is_string ? VALUE_STRING : VALUE_BOOLEAN, token->line);
    value.truth = token->length == 4;
    if (is_string && (value.text = copy_text(checker, token)) == NULL) {
        return false;
    }
    return push_value(checker, &value);
}

static bool take_value(struct checker *checker, const struct token *token) {
    struct bracket *bracket = &checker->stack[checker->depth];
    if (is_closing(token) && checker->expectation == WANT_FIRST_VALUE) {
        return close_bracket(checker, token);
    }
    if (!is_group(bracket) && token_is(token, closing(bracket->open))) {
        return scene_fail(checker->reader, token->line,
                          "a ',' too many before '%c': the last element has none", *token->start);
    }
    if (!is_group(bracket) && ++bracket->count > SCENE_ELEMENTS_MOST) {
        return scene_fail(checker->reader, token->line,
                          "too many elements in one list: at most %d are allowed",
                          SCENE_ELEMENTS_MOST);
    }
    bool is_number = bracket->open == '[' && token_is(token, '('); /* in parentheses */
    if (!is_number && (token_is(token, '{') || token_is(token, '(') || token_is(token, '['))) {
        return open_bracket(checker, token);
    }
    if (token->kind == TOKEN_NAME && find_constant(checker, token) == NULL) {
        return refuse_word(checker, token);
    }
    if (token->kind == TOKEN_END && !is_group(bracket)) {
        return unclosed(checker);
    }
    bool is_sign = token_is(token, '+') || token_is(token, '-');
    if ((token->kind == TOKEN_MARK && !is_sign && !is_number) || token->kind == TOKEN_END) {
        return unexpected(checker, token, "a value");
    }
    if (bracket->open == '[' && !fits_array(checker, bracket, token)) {
        return false;
    }
    checker->value = *token;
    checker->expectation = AFTER_VALUE;
    return token->kind == TOKEN_STRING || token->kind == TOKEN_BOOLEAN
               ? take_plain(checker, token)
               : take_number(checker, token);
}

/* Refuses a token that stands where a key or a separator is wanted. */
static bool missing_separator(struct checker *checker, const struct token *token) {
    const struct token *value = &checker->value;
    bool after_comma = checker->expectation == WANT_KEY && token_is(&checker->separator, ',');
    if (token_is_number(token) && after_comma && token_is_number(value)) {
        return scene_fail(checker->reader, token->line,
                          "'%.*s,%.*s' is no number: the decimal point is a dot, as in %.*s.%.*s",
                          token_shown(value), value->start, token_shown(token), token->start,
                          token_shown(value), value->start, token_shown(token), token->start);
    }
    if (checker->expectation == AFTER_VALUE) {
        char open = checker->stack[checker->depth].open;
        return unexpected(checker, token,
                          open == '('   ? "',' or ')'"
                          : open == '[' ? "',' or ']'"
                                        : "';'");
    }
    return unexpected(checker, token, "a key");
}

static bool take_key_or_end(struct checker *checker, const struct token *token) {
    const struct bracket *bracket = &checker->stack[checker->depth];
    if (token->kind == TOKEN_NAME) {
        return take_key(checker, token);
    }
    if (token->kind == TOKEN_BOOLEAN) {
        return scene_fail(checker->reader, token->line, "'%.*s' is a value: it can be no key",
                          token_shown(token), token->start);
    }
    if (is_closing(token)) {
        return close_bracket(checker, token);
    }
    if (token->kind == TOKEN_END) {
        if (bracket->open == '\0') {
            return true;
        }
        return unclosed(checker);
    }
    return missing_separator(checker, token);
}

static bool take_after_value(struct checker *checker, const struct token *token) {
    const struct bracket *bracket = &checker->stack[checker->depth];
    if (is_group(bracket)) {
        if (token_is(token, ';') || token_is(token, ',')) {
            checker->separator = *token;
            checker->expectation = WANT_KEY;
            return true;
        }
        return take_key_or_end(checker, token);
    }
    if (token_is(token, ',')) {
        checker->expectation = WANT_VALUE;
        return true;
    }
    if (token->kind == TOKEN_NAME || token->kind == TOKEN_BOOLEAN) {
        return missing_separator(checker, token);
    }
    return take_key_or_end(checker, token);
}

static bool take(struct checker *checker, const struct token *token) {
    switch (checker->expectation) {
    case WANT_KEY:
        return take_key_or_end(checker, token);
    case WANT_EQUALS:
        if (!token_is(token, '=') && !token_is(token, ':')) {
            return scene_fail(checker->reader, token->line, "'=' is missing after the key '%.*s'",
                              token_shown(&checker->key), checker->key.start);
        }
        checker->expectation = WANT_VALUE;
        return true;
    case WANT_VALUE:
    case WANT_FIRST_VALUE:
        return take_value(checker, token);
    case AFTER_VALUE:
        return take_after_value(checker, token);
    }
    return false;
}

static bool parse_tokens(struct checker *checker) {
    struct token token;
    bool sound = true;
    do {
        sound = next_token(checker, &token) && take(checker, &token);
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
    struct checker checker = {.reader = reader};
    char *copy = take_memory(&checker, length + 1);
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
    checker.scanner = scanner;
    checker.keys = scene_allocate(reader, keys_most, sizeof *checker.keys);
    *root = whole;
    bool sound = checker.keys != NULL && parse_tokens(&checker) && gather(&checker, root);
    free(checker.keys);
    free(checker.values);
    return sound;
}
