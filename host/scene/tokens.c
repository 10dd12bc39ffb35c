/* SPDX-License-Identifier: MIT */
/* Cuts a scene's text into tokens. */
#include "scene/tokens.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { SHOWN_MOST = 40, NUMBER_LENGTH_MOST = 100 };

/* Tells whether a letter is a digit. This test and the next two are our own: the library's depend
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

bool token_is(const struct token *token, char mark) {
    return token->kind == TOKEN_MARK && *token->start == mark;
}

bool token_is_number(const struct token *token) {
    return token->kind == TOKEN_INTEGER || token->kind == TOKEN_FLOAT;
}

double token_number(const struct token *token) {
    const bool is_hex = token->kind != TOKEN_FLOAT && token->length > 2 &&
                        (token->start[1] == 'x' || token->start[1] == 'X');
    return token->kind == TOKEN_FLOAT ? strtod(token->start, NULL)
                                      : (double)strtoll(token->start, NULL, is_hex ? 16 : 10);
}

int token_shown(const struct token *token) {
    return token->length < SHOWN_MOST ? (int)token->length : SHOWN_MOST;
}

bool token_is_infinite_or_nan(const struct token *token) {
    static const char *const words[] = {"nan", "inf", "infinity"};
    const char *start = token->start;
    size_t length = token->length;
    if (length > 0 && (*start == '-' || *start == '+')) {
        start++;
        length--;
    }
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strlen(words[i]) == length && strncasecmp(words[i], start, length) == 0) {
            return true;
        }
    }
    return false;
}

/* Passes over a comment whose begin has been passed, to its end. */
static bool skip_block(struct scanner *scanner) {
    const unsigned first_line = scanner->line;
    for (; scanner->at + 1 < scanner->length; scanner->at++) {
        const char *here = scanner->text + scanner->at;
        if (here[0] == '*' && here[1] == '/') {
            scanner->at += 2;
            return true;
        }
        scanner->line += here[0] == '\n';
    }
    return scene_fail(scanner->reader, first_line,
                      "the comment that begins here with /* is never ended: it needs */");
}

/* Goes on to the next token's first byte. */
static bool skip_blanks(struct scanner *scanner) {
    while (scanner->at < scanner->length) {
        const char *here = scanner->text + scanner->at;
        if (*here == '\n') {
            scanner->line++;
            scanner->at++;
        } else if (*here == ' ' || *here == '\t' || *here == '\r' || *here == '\f') {
            scanner->at++;
        } else if (*here == '#' || (here[0] == '/' && here[1] == '/')) {
            scanner->at += strcspn(here, "\n");
        } else if (here[0] == '/' && here[1] == '*') {
            scanner->at += 2;
            if (!skip_block(scanner)) {
                return false;
            }
        } else {
            return true;
        }
    }
    return true;
}

/* Reads a string: no line breaks, no escapes but \" and \\. */
static bool scan_string(struct scanner *scanner, struct token *token) {
    size_t at = scanner->at + 1;
    for (;; at++) {
        unsigned char byte = (unsigned char)scanner->text[at];
        if (byte == '"') {
            break;
        }
        if (at >= scanner->length || byte == '\n' || byte == '\r') {
            return scene_fail(scanner->reader, scanner->line,
                              "the string that begins here has no closing \" on its line");
        }
        if (byte < 0x20 || byte == 0x7F) {
            return scene_fail(scanner->reader, scanner->line,
                              "byte %02Xh in a string: control characters are not allowed there",
                              byte);
        }
        if (byte == '\\') {
            char escaped = scanner->text[++at];
            if (escaped != '"' && escaped != '\\') {
                return scene_fail(scanner->reader, scanner->line,
                                  "unknown escape in a string: only \\\" and \\\\ are allowed");
            }
        }
    }
    token->kind = TOKEN_STRING;
    token->length = at + 1 - scanner->at;
    scanner->at = at + 1;
    if (token->length - 2 > SCENE_STRING_MOST) {
        return scene_fail(scanner->reader, scanner->line,
                          "a string of %zu bytes is too long: at most %d are allowed",
                          token->length - 2, SCENE_STRING_MOST);
    }
    return true;
}

static bool scan_name(struct scanner *scanner, struct token *token) {
    const char *start = token->start;
    size_t length = 1;
    while (is_letter(start[length]) || is_digit(start[length]) || start[length] == '_' ||
           start[length] == '-') {
        length++;
    }
    token->length = length;
    bool truth = length == 4 && strncasecmp(start, "true", 4) == 0;
    bool falsehood = length == 5 && strncasecmp(start, "false", 5) == 0;
    token->kind = truth || falsehood ? TOKEN_BOOLEAN : TOKEN_NAME;
    scanner->at += length;
    if (length > SCENE_STRING_MOST) {
        return scene_fail(scanner->reader, token->line,
                          "a name of %zu bytes is too long: at most %d are allowed", length,
                          SCENE_STRING_MOST);
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

/* Tells what kind of number a text is by its form alone; TOKEN_END: no number. */
static enum token_kind number_form(const char *text) {
    if (text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
        size_t digits = count_digits(text + 2, is_hex_digit);
        const char *rest = text + 2 + digits;
        bool suffix = strcmp(rest, "L") == 0 || strcmp(rest, "LL") == 0;
        return digits == 0 || (*rest != '\0' && !suffix) ? TOKEN_END : TOKEN_INTEGER;
    }
    if (*text == '+' || *text == '-') {
        text++;
    }
    size_t digits = count_digits(text, is_digit);
    text += digits;
    if (digits > 0 && (*text == '\0' || strcmp(text, "L") == 0 || strcmp(text, "LL") == 0)) {
        return TOKEN_INTEGER;
    }
    if (*text == '.') {
        size_t decimals = count_digits(++text, is_digit);
        text += decimals;
        digits += decimals;
    }
    if (digits > 0 && (*text == 'e' || *text == 'E')) {
        text++;
        if (*text == '+' || *text == '-') {
            text++;
        }
        size_t exponent = count_digits(text, is_digit);
        text += exponent;
        digits = exponent;
    }
    return digits > 0 && *text == '\0' ? TOKEN_FLOAT : TOKEN_END;
}

/* Checks that a number is not too large for its form. */
static bool check_magnitude(struct scanner *scanner, const struct token *token, const char *text) {
    errno = 0;
    if (token->kind == TOKEN_FLOAT) {
        double value = strtod(text, NULL);
        if (errno == ERANGE && (value > 1 || value < -1)) {
            return scene_fail(scanner->reader, token->line,
                              "'%.*s' is too large: numbers go up to 1.7e308", token_shown(token),
                              token->start);
        }
        return true;
    }
    bool hex = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    (void)strtoll(text, NULL, hex ? 16 : 10);
    if (errno == ERANGE) {
        return scene_fail(scanner->reader, token->line,
                          "integer '%.*s' does not fit 64 bits: write it with a decimal point",
                          token_shown(token), token->start);
    }
    return true;
}

static bool scan_number(struct scanner *scanner, struct token *token) {
    char text[NUMBER_LENGTH_MOST + 1];
    token->length = number_length(token->start);
    scanner->at += token->length;
    if (token->length >= sizeof text) {
        return scene_fail(scanner->reader, token->line,
                          "a number of %zu characters is too long: at most %d are allowed",
                          token->length, NUMBER_LENGTH_MOST);
    }
    memcpy(text, token->start, token->length);
    text[token->length] = '\0';
    token->kind = number_form(text);
    const char *digits = text + (*text == '-' || *text == '+');
    if (token->kind == TOKEN_INTEGER && digits[0] == '0' && is_digit(digits[1])) {
        return scene_fail(scanner->reader, token->line,
                          "'%.*s' may be meant as octal, and is not read so: write it without the "
                          "0 before it",
                          token_shown(token), token->start);
    }
    if (token->kind == TOKEN_END) {
        return scene_fail(scanner->reader, token->line,
                          token_is_infinite_or_nan(token)
                              ? "'%.*s' is invalid: every number must be finite"
                              : "'%.*s' is no number: numbers look like 12, -0.5 or 1.5e-3",
                          token_shown(token), token->start);
    }
    return check_magnitude(scanner, token, text);
}

/* Tells whether a sign belongs to the number behind it, infinity or not-a-number among them. */
static bool is_sign_of_number(const struct scanner *scanner) {
    const char *here = scanner->text + scanner->at;
    const struct token word = {TOKEN_NAME, 0, here, number_length(here)};
    return (*here == '+' || *here == '-') &&
           (is_digit(here[1]) || here[1] == '.' || here[1] == '+' || here[1] == '-' ||
            token_is_infinite_or_nan(&word));
}

bool scanner_next(struct scanner *scanner, struct token *token) {
    if (!skip_blanks(scanner)) {
        return false;
    }
    char first = scanner->text[scanner->at];
    *token = (struct token){TOKEN_END, scanner->line, scanner->text + scanner->at, 0};
    if (scanner->at >= scanner->length) {
        return true;
    }
    if (first == '"') {
        return scan_string(scanner, token);
    }
    if (is_letter(first)) {
        return scan_name(scanner, token);
    }
    if (is_digit(first) || first == '.' || is_sign_of_number(scanner)) {
        return scan_number(scanner, token);
    }
    if (strchr("=:,;{}()[]+-*/", first)) {
        token->kind = TOKEN_MARK;
        token->length = 1;
        scanner->at++;
        return true;
    }
    if (first == '@') {
        return scene_fail(scanner->reader, scanner->line,
                          "'@' begins an include: scene files may not include other files");
    }
    if (first > 0x20 && first < 0x7F) {
        return scene_fail(scanner->reader, scanner->line,
                          "'%c' is invalid here: a scene is made of NAME = VALUE;", first);
    }
    return scene_fail(scanner->reader, scanner->line,
                      "byte %02Xh is invalid outside of strings and comments",
                      (unsigned char)first);
}
