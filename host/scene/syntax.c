/* SPDX-License-Identifier: MIT */
/* Checks a scene's brackets, separators and keys, so that libconfig sees well-formed text only. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "scene/tokens.h"

/* An open bracket, or the file itself. */
struct bracket {
    char open; /* { ( [, or NUL: the file */
    unsigned line;
    size_t count;            /* keys or elements so far */
    size_t first_key;        /* of a group, in the keys of all open groups */
    enum token_kind element; /* of an array, once it has one */
};

enum expectation { WANT_KEY, WANT_EQUALS, WANT_VALUE, WANT_FIRST_VALUE, AFTER_VALUE };

struct checker {
    struct scene_reader *reader;
    struct bracket stack[SCENE_BRACKETS_MOST + 1];
    size_t depth; /* the innermost open bracket is stack[depth] */
    struct token *keys;
    size_t key_count;
    enum expectation expectation;
    struct token key;       /* the last one */
    struct token value;     /* the last plain value */
    struct token separator; /* the last one */
};

static bool is_group(const struct bracket *bracket) {
    return bracket->open == '{' || bracket->open == '\0';
}

static char closing(char open) {
    return open == '{' ? '}' : open == '(' ? ')' : ']';
}

static bool is_closing(const struct token *token) {
    return token_is(token, '}') || token_is(token, ')') || token_is(token, ']');
}

static bool unexpected(struct checker *checker, const struct token *token, const char *wanted) {
    if (token->kind == TOKEN_END) {
        return scene_fail(checker->reader, token->line, "the file ends where %s is wanted", wanted);
    }
    return scene_fail(checker->reader, token->line, "'%.*s' stands where %s is wanted",
                      token_shown(token), token->start, wanted);
}

static bool unclosed(struct checker *checker) {
    const struct bracket *bracket = &checker->stack[checker->depth];
    return scene_fail(checker->reader, bracket->line, "this '%c' is never closed: '%c' is missing",
                      bracket->open, closing(bracket->open));
}

static bool take_key(struct checker *checker, const struct token *token) {
    struct bracket *group = &checker->stack[checker->depth];
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
    checker->expectation = WANT_EQUALS;
    return true;
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
    checker->depth--;
    checker->value.kind = TOKEN_END;
    checker->expectation = AFTER_VALUE;
    return true;
}

static bool open_bracket(struct checker *checker, const struct token *token) {
    if (checker->stack[checker->depth].open == '[') {
        return scene_fail(checker->reader, token->line,
                          "an array [ ] holds plain values only: use a list ( ) here");
    }
    if (checker->depth == SCENE_BRACKETS_MOST) {
        return scene_fail(checker->reader, token->line,
                          "brackets nest too deep: at most %d levels are allowed; named parts "
                          "make a scene flatter",
                          SCENE_BRACKETS_MOST);
    }
    checker->stack[++checker->depth] =
        (struct bracket){*token->start, token->line, 0, checker->key_count, TOKEN_END};
    checker->expectation = *token->start == '{' ? WANT_KEY : WANT_FIRST_VALUE;
    return true;
}

static bool fits_array(struct checker *checker, struct bracket *array, const struct token *token) {
    if (array->element == TOKEN_END) {
        array->element = token->kind;
    }
    if (array->element == token->kind) {
        return true;
    }
    struct token first = {array->element, 0, NULL, 0};
    if (token_is_number(token) && token_is_number(&first)) {
        return scene_fail(checker->reader, token->line,
                          "an array [ ] cannot mix whole numbers and others: write '%.*s' and the "
                          "rest all with a decimal point (1.0), or use a list ( )",
                          token_shown(token), token->start);
    }
    return scene_fail(checker->reader, token->line,
                      "an array [ ] holds values of one type only: '%.*s' is of another",
                      token_shown(token), token->start);
}

static bool take_word(struct checker *checker, const struct token *token) {
    static const char *const truths[] = {"yes", "no", "on", "off"};
    if (token_is_infinite_or_nan(token)) {
        return scene_fail(checker->reader, token->line,
                          "'%.*s' is invalid: every number must be finite", token_shown(token),
                          token->start);
    }
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++) {
        if (strlen(truths[i]) == token->length &&
            strncasecmp(truths[i], token->start, token->length) == 0) {
            return scene_fail(checker->reader, token->line,
                              "'%.*s' is invalid: write true or false", token_shown(token),
                              token->start);
        }
    }
    return scene_fail(checker->reader, token->line,
                      "'%.*s' is no value: strings stand in quotes, as in \"%.*s\"",
                      token_shown(token), token->start, token_shown(token), token->start);
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
    if (token_is(token, '{') || token_is(token, '(') || token_is(token, '[')) {
        return open_bracket(checker, token);
    }
    if (token->kind == TOKEN_NAME) {
        return take_word(checker, token);
    }
    if (token->kind == TOKEN_END && !is_group(bracket)) {
        return unclosed(checker);
    }
    if (token->kind == TOKEN_MARK || token->kind == TOKEN_END) {
        return unexpected(checker, token, "a value");
    }
    if (bracket->open == '[' && !fits_array(checker, bracket, token)) {
        return false;
    }
    checker->value = *token;
    checker->expectation = AFTER_VALUE;
    return true;
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

static bool check_tokens(struct scene_reader *reader, char *text, size_t length) {
    struct scanner scanner = {reader, text, length, 0, 1};
    struct checker checker = {.reader = reader};
    bool sound = true;
    struct token token;
    size_t keys_most = (size_t)(SCENE_BRACKETS_MOST + 1) * SCENE_KEYS_MOST;
    checker.keys = scene_allocate(reader, keys_most, sizeof *checker.keys);
    if (!checker.keys) {
        return false;
    }
    do {
        sound = scanner_next(&scanner, &token) && take(&checker, &token);
    } while (sound && token.kind != TOKEN_END);
    free(checker.keys);
    return sound;
}

char *scene_text_check(struct scene_reader *reader, const char *text, size_t length) {
    if (length > SCENE_TEXT_MOST) {
        scene_fail(reader, 1, "a scene of %zu bytes is too large: at most %d are allowed", length,
                   SCENE_TEXT_MOST);
        return NULL;
    }
    unsigned line = 1;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '\0') {
            scene_fail(reader, line, "a NUL byte: a scene is plain text");
            return NULL;
        }
        line += text[i] == '\n';
    }
    char *copy = scene_allocate(reader, length + 1, 1);
    if (!copy) {
        return NULL;
    }
    if (length > 0) {
        memcpy(copy, text, length);
    }
    if (length >= 3 && memcmp(copy, "\xEF\xBB\xBF", 3) == 0) {
        memset(copy, ' ', 3); /* some editors' byte order mark */
    }
    if (!check_tokens(reader, copy, length)) {
        free(copy);
        return NULL;
    }
    return copy;
}
