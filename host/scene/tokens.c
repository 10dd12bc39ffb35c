/* SPDX-License-Identifier: MIT */
/* Cuts a scene's text into tokens. */
#include "scene/tokens.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { SHOWN_MOST = 40, NUMBER_LENGTH_MOST = 100, STRING_MOST = 200 };

/* Tells whether a letter is a digit. This test and the next ones are our own: the library's depend
 * on the locale. */
static bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

static bool is_letter(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
}

static bool is_hex_digit(char letter) {
    return is_digit(letter) || (letter >= 'a' && letter <= 'f') || (letter >= 'A' && letter <= 'F');
}

/* Tells whether a byte is of ASCII and not a control character. */
static bool is_printable(char letter) {
    return (unsigned char)letter >= 0x20 && (unsigned char)letter < 0x7F;
}

bool token_is(const struct token *token, char mark) {
    return token->kind == TOKEN_MARK && *token->start == mark;
}

bool token_closes(const struct token *token) {
    return token_is(token, '}') || token_is(token, ')') || token_is(token, ']');
}

bool token_spells(const struct token *token, const char *word) {
    return strlen(word) == token->length && memcmp(word, token->start, token->length) == 0;
}

bool token_is_signed_onward(const struct scanner *scanner, const struct token *token) {
    return token->kind == TOKEN_NUMBER && (*token->start == '-' || *token->start == '+') &&
           token->start > scanner->text && strchr(" \t\r\f\n/", token->start[-1]) == NULL;
}

int token_shown(const struct token *token) {
    return token->length < SHOWN_MOST ? (int)token->length : SHOWN_MOST;
}

bool token_is_infinite_or_nan(const struct token *token) {
    static const char *const words[] = {"nan", "inf", "infinity"};
    const bool is_signed = token->length > 0 && (*token->start == '-' || *token->start == '+');
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strlen(words[i]) == token->length - is_signed &&
            strncasecmp(words[i], token->start + is_signed, strlen(words[i])) == 0) {
            return true;
        }
    }
    return false;
}

/* Passes over a comment whose begin stands here, to its end. */
static void skip_block(struct scanner *scanner) {
    const struct scene_place begin = {scanner->line,
                                      (unsigned)(scanner->at - scanner->line_start) + 1};
    for (scanner->at += 2; scanner->at < scanner->length; scanner->at++) {
        const char *here = scanner->text + scanner->at;
        if (here[0] == '*' && here[1] == '/') {
            scanner->at += 2;
            return;
        }
        if (*here == '\n') {
            scanner->line++;
            scanner->line_start = scanner->at + 1;
        }
    }
    scanner->is_cut = true;
    (void)scene_fail(scanner->reader, begin,
                     "the comment that begins here with /* is never ended: it needs */");
}

/* Goes on to the next token's first byte. */
static void skip_blanks(struct scanner *scanner) {
    while (scanner->at < scanner->length) {
        const char *here = scanner->text + scanner->at;
        if (*here == '\n') {
            scanner->line++;
            scanner->line_start = ++scanner->at;
        } else if (*here == ' ' || *here == '\t' || *here == '\r' || *here == '\f') {
            scanner->at++;
        } else if (*here == '#' || (here[0] == '/' && here[1] == '/')) {
            scanner->at += strcspn(here, "\n");
        } else if (here[0] == '/' && here[1] == '*') {
            skip_block(scanner);
        } else {
            return;
        }
    }
}

/* Reads a string: no line breaks, no escapes but \" and \\. What is wrong in it is said once. */
static bool scan_string(struct scanner *scanner, struct token *token) {
    struct scene_reader *reader = scanner->reader;
    const char *text = token->start;
    bool is_good = true;
    size_t length = 1;
    for (; text[length] != '"'; length++) {
        const unsigned char byte = (unsigned char)text[length];
        if (scanner->at + length >= scanner->length || byte == '\n' || byte == '\r') {
            token->length = length;
            return is_good &&
                   scene_fail(reader, token->at,
                              "the string that begins here has no closing \" on its line");
        }
        if (is_good && (byte < 0x20 || byte == 0x7F)) {
            is_good = scene_fail(reader, token->at,
                                 "byte %02Xh in a string: control characters are not allowed there",
                                 byte);
        }
        if (byte == '\\' && text[++length] != '"' && text[length] != '\\') {
            length--;
            is_good =
                is_good && scene_fail(reader, token->at,
                                      "unknown escape in a string: only \\\" and \\\\ are allowed");
        }
    }
    token->length = length + 1;
    if (is_good && length - 1 > STRING_MOST) {
        return scene_fail(reader, token->at,
                          "a string of %zu bytes is too long: at most %d are allowed", length - 1,
                          STRING_MOST);
    }
    return is_good;
}

static bool scan_name(struct scanner *scanner, struct token *token) {
    const char *start = token->start;
    size_t length = 1;
    while (is_letter(start[length]) || is_digit(start[length]) || start[length] == '_' ||
           start[length] == '-') {
        length++;
    }
    token->length = length;
    if ((length == 4 && strncasecmp(start, "true", 4) == 0) ||
        (length == 5 && strncasecmp(start, "false", 5) == 0)) {
        token->kind = TOKEN_BOOLEAN;
    }
    if (length > STRING_MOST) {
        return scene_fail(scanner->reader, token->at,
                          "a name of %zu bytes is too long: at most %d are allowed", length,
                          STRING_MOST);
    }
    return true;
}

/* Returns the length of all that sticks together as one number, well-formed or not. */
static size_t number_length(const char *start) {
    bool hex = start[0] == '0' && (start[1] == 'x' || start[1] == 'X');
    size_t length = 1;
    for (;; length++) {
        char letter = start[length], before = start[length - 1];
        bool sign = letter == '+' || letter == '-';
        if (is_letter(letter) || is_digit(letter) || letter == '.' || letter == '_') {
            continue;
        }
        if (sign && ((!hex && (before == 'e' || before == 'E')) || length == 1) &&
            !is_digit(before)) {
            continue;
        }
        return length;
    }
}

static size_t count_digits(const char *text, bool (*belongs)(char)) {
    size_t count = 0;
    while (belongs(text[count])) {
        count++;
    }
    return count;
}

enum number_form { FORM_NONE, FORM_DECIMAL, FORM_HEX, FORM_FLOAT };

/* Tells what kind of number a text is by its form alone. */
static enum number_form form_of(const char *text) {
    bool is_hex = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    text += is_hex ? 2 : *text == '+' || *text == '-';
    size_t digits = count_digits(text, is_hex ? is_hex_digit : is_digit);
    text += digits;
    if (digits > 0 && (*text == '\0' || strcmp(text, "L") == 0 || strcmp(text, "LL") == 0)) {
        return is_hex ? FORM_HEX : FORM_DECIMAL;
    }
    if (is_hex) {
        return FORM_NONE;
    }
    if (*text == '.') {
        size_t decimals = count_digits(++text, is_digit);
        text += decimals;
        digits += decimals;
    }
    if (digits > 0 && (*text == 'e' || *text == 'E')) {
        text += text[1] == '+' || text[1] == '-' ? 2 : 1;
        digits = count_digits(text, is_digit);
        text += digits;
    }
    return digits > 0 && *text == '\0' ? FORM_FLOAT : FORM_NONE;
}

static bool scan_number(struct scanner *scanner, struct token *token) {
    struct scene_reader *reader = scanner->reader;
    char text[NUMBER_LENGTH_MOST + 1];
    token->length = number_length(token->start);
    if (token->length >= sizeof text) {
        return scene_fail(reader, token->at,
                          "a number of %zu characters is too long: at most %d are allowed",
                          token->length, NUMBER_LENGTH_MOST);
    }
    memcpy(text, token->start, token->length);
    text[token->length] = '\0';
    const enum number_form form = form_of(text);
    const char *digits = text + (*text == '-' || *text == '+');
    const size_t whole = count_digits(text, is_digit);
    if (form == FORM_NONE && whole > 0 && is_letter(text[whole]) &&
        strchr("eExX", text[whole]) == NULL) {
        return scene_fail(
            reader, token->at,
            "'%.*s' is no number: a product is written with its mark, as in %.*s*%.*s",
            token_shown(token), token->start, (int)whole, text, token_shown(token) - (int)whole,
            text + whole);
    }
    if (form == FORM_NONE) {
        return scene_fail(reader, token->at,
                          token_is_infinite_or_nan(token)
                              ? "'%.*s' is invalid: every number must be finite"
                              : "'%.*s' is no number: numbers look like 12, -0.5 or 1.5e-3",
                          token_shown(token), token->start);
    }
    if (form == FORM_DECIMAL && digits[0] == '0' && is_digit(digits[1])) {
        return scene_fail(reader, token->at,
                          "'%.*s' may be meant as octal, and is not read so: write it without the "
                          "0 before it",
                          token_shown(token), token->start);
    }
    errno = 0;
    token->number = form == FORM_FLOAT ? strtod(text, NULL)
                                       : (double)strtoll(text, NULL, form == FORM_HEX ? 16 : 10);
    if (errno == ERANGE && form != FORM_FLOAT) {
        return scene_fail(reader, token->at,
                          "integer '%.*s' does not fit 64 bits: write it with a decimal point",
                          token_shown(token), token->start);
    }
    if (errno == ERANGE && (token->number > 1 || token->number < -1)) {
        return scene_fail(reader, token->at, "'%.*s' is too large: numbers go up to 1.7e308",
                          token_shown(token), token->start);
    }
    return true;
}

/* Refuses bytes of which no token is made. Those that stand together are refused once. */
static bool scan_other(struct scanner *scanner, struct token *token) {
    const char first = *token->start;
    token->length = 1;
    if (first == '@') {
        return scene_fail(scanner->reader, token->at,
                          "'@' begins an include: scene files may not include other files");
    }
    if (is_printable(first)) {
        return scene_fail(scanner->reader, token->at,
                          "'%c' is invalid here: a scene is made of NAME = VALUE;", first);
    }
    while (!is_printable(token->start[token->length]) &&
           strchr("\t\r\f\n", token->start[token->length]) == NULL) {
        token->length++;
    }
    return scene_fail(scanner->reader, token->at,
                      "byte %02Xh is invalid outside of strings and comments",
                      (unsigned char)first);
}

/* Tells whether a sign belongs to the number behind it, infinity or not-a-number among them. */
static bool is_sign_of_number(const char *here) {
    const struct token word = {.start = here, .length = number_length(here)};
    return (*here == '+' || *here == '-') &&
           (is_digit(here[1]) || here[1] == '.' || here[1] == '+' || here[1] == '-' ||
            token_is_infinite_or_nan(&word));
}

struct token scanner_next(struct scanner *scanner) {
    skip_blanks(scanner);
    struct token token = {.kind = TOKEN_END,
                          .at = {scanner->line, (unsigned)(scanner->at - scanner->line_start) + 1},
                          .start = scanner->text + scanner->at};
    bool is_good = true;
    if (scanner->at >= scanner->length) {
        return token;
    }
    if (*token.start == '"') {
        token.kind = TOKEN_STRING;
        is_good = scan_string(scanner, &token);
    } else if (is_letter(*token.start)) {
        token.kind = TOKEN_NAME;
        is_good = scan_name(scanner, &token);
    } else if (is_digit(*token.start) || *token.start == '.' || is_sign_of_number(token.start)) {
        token.kind = TOKEN_NUMBER;
        is_good = scan_number(scanner, &token);
    } else if (strchr("=:,;{}()[]+-*/", *token.start)) {
        token.kind = TOKEN_MARK;
        token.length = 1;
    } else {
        is_good = scan_other(scanner, &token);
    }
    scanner->at += token.length;
    if (!is_good) {
        token.kind = TOKEN_REFUSED;
    }
    return token;
}
