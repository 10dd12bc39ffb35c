/* SPDX-License-Identifier: MIT */
#include "operators.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_any(const struct source *source, size_t i, const char *const *words) {
    for (; *words != NULL; words++) {
        if (source_is(source, i, *words)) {
            return true;
        }
    }
    return false;
}

/* ---- Enumerations ---------------------------------------------------------------------------- */

static void copy_token(char *to, size_t room, const struct source *source, size_t i) {
    const struct token *token = &source->tokens[i];

    (void)snprintf(to, room, "%.*s", (int)(token->end - token->start), source->text + token->start);
}

/* Appends the constants between the braces of one enumeration; a constant alone has no sibling. */
static void collect_members(struct siblings *siblings, const struct source *source, size_t brace) {
    size_t first = siblings->count, end = source->tokens[brace].partner;

    for (size_t i = brace + 1; i < end; i++) {
        if (source->tokens[i].kind != TOKEN_WORD ||
            (!source_is(source, i - 1, "{") && !source_is(source, i - 1, ","))) {
            continue;
        }
        if (siblings->count == siblings->room) {
            siblings->room = siblings->room * 2 + 64;
            siblings->list =
                source_memory(realloc(siblings->list, siblings->room * sizeof *siblings->list));
        }
        copy_token(siblings->list[siblings->count++].name, 64, source, i);
    }
    for (size_t i = first; i < siblings->count; i++) {
        size_t next = i + 1 < siblings->count ? i + 1 : first;

        memcpy(siblings->list[i].other, siblings->list[next].name, 64);
    }
    siblings->count = siblings->count == first + 1 ? first : siblings->count;
}

void siblings_collect(struct siblings *siblings, const struct source *source) {
    for (size_t i = 0; i < source->count; i++) {
        size_t brace = source_is(source, i + 1, "{") ? i + 1 : i + 2;

        if (source_is(source, i, "enum") && source_is(source, brace, "{")) {
            collect_members(siblings, source, brace);
        }
    }
}

static int by_name(const void *a, const void *b) {
    return strcmp(((const struct sibling *)a)->name, ((const struct sibling *)b)->name);
}

void siblings_sort(struct siblings *siblings) {
    if (siblings->count > 0) {
        qsort(siblings->list, siblings->count, sizeof *siblings->list, by_name);
    }
}

/* ---- Adding mutations ------------------------------------------------------------------------ */

/* Appends a mutation of tokens first to last, which `text` replaces. */
static struct mutation *add(struct mutations *mutations, const struct source *source, size_t first,
                            size_t last, const char *text) {
    const struct token *token = &source->tokens[first];
    struct mutation *mutation;

    if (mutations->count == mutations->room) {
        mutations->room = mutations->room * 2 + 1024;
        mutations->list =
            source_memory(realloc(mutations->list, mutations->room * sizeof *mutations->list));
    }
    mutation = &mutations->list[mutations->count++];
    *mutation = (struct mutation){.source = source,
                                  .start = token->start,
                                  .end = source->tokens[last].end,
                                  .line = token->line,
                                  .function = token->function};
    (void)snprintf(mutation->text, sizeof mutation->text, "%s", text);
    return mutation;
}

/* ---- Signs ----------------------------------------------------------------------------------- */

enum operands { ANY_OPERANDS, ONE_OPERAND, TWO_OPERANDS };

static const struct replacement {
    const char *from, *to;
    enum operands operands;
} replacements[] = {
    {"<", "<=", ANY_OPERANDS},      {"<", ">", ANY_OPERANDS},     {"<=", "<", ANY_OPERANDS},
    {"<=", ">", ANY_OPERANDS},      {">", ">=", ANY_OPERANDS},    {">", "<", ANY_OPERANDS},
    {">=", ">", ANY_OPERANDS},      {">=", "<", ANY_OPERANDS},    {"==", "!=", ANY_OPERANDS},
    {"!=", "==", ANY_OPERANDS},     {"&&", "||", ANY_OPERANDS},   {"||", "&&", ANY_OPERANDS},
    {"&", "|", TWO_OPERANDS},       {"|", "&", ANY_OPERANDS},     {"^", "|", ANY_OPERANDS},
    {"<<", ">>", ANY_OPERANDS},     {">>", "<<", ANY_OPERANDS},   {"+", "-", TWO_OPERANDS},
    {"-", "+", TWO_OPERANDS},       {"-", "", ONE_OPERAND},       {"!", "", ANY_OPERANDS},
    {"~", "", ANY_OPERANDS},        {"*", "/", TWO_OPERANDS},     {"/", "*", ANY_OPERANDS},
    {"%", "*", ANY_OPERANDS},       {"+=", "-=", ANY_OPERANDS},   {"+=", "=", ANY_OPERANDS},
    {"-=", "+=", ANY_OPERANDS},     {"-=", "=", ANY_OPERANDS},    {"*=", "/=", ANY_OPERANDS},
    {"*=", "=", ANY_OPERANDS},      {"/=", "*=", ANY_OPERANDS},   {"|=", "&=", ANY_OPERANDS},
    {"|=", "=", ANY_OPERANDS},      {"&=", "|=", ANY_OPERANDS},   {"&=", "=", ANY_OPERANDS},
    {"^=", "|=", ANY_OPERANDS},     {"<<=", ">>=", ANY_OPERANDS}, {">>=", "<<=", ANY_OPERANDS},
    {"++", "--", ANY_OPERANDS},     {"--", "++", ANY_OPERANDS},   {"true", "false", ANY_OPERANDS},
    {"false", "true", ANY_OPERANDS}};

/* Tells if an operand ends right before token i, so that the sign there stands between two. */
static bool follows_operand(const struct source *source, size_t i) {
    static const char *const no_operands[] = {"return", "case", "else", NULL};

    if (i == 0 || is_any(source, i - 1, no_operands)) {
        return false;
    }
    return source->tokens[i - 1].kind != TOKEN_SIGN || source_is(source, i - 1, ")") ||
           source_is(source, i - 1, "]");
}

/* Tells if the asterisk at token i makes a pointer of a type, as far as the tokens before it say.
 */
static bool is_pointer(const struct source *source, size_t i) {
    static const char *const tags[] = {"struct", "union", "enum", NULL};
    static const char *const types[] = {"void",   "char", "bool",  "int",
                                        "double", "FILE", "const", NULL};

    return source_is(source, i, "*") &&
           (source->tokens[i].function == NO_FUNCTION || (i > 0 && is_any(source, i - 1, types)) ||
            (i > 1 && is_any(source, i - 2, tags)));
}

static void replace_sign(struct mutations *mutations, const struct source *source, size_t i) {
    if (is_pointer(source, i)) {
        return;
    }
    for (size_t k = 0; k < sizeof replacements / sizeof *replacements; k++) {
        if (source_is(source, i, replacements[k].from) &&
            (replacements[k].operands == ANY_OPERANDS ||
             (replacements[k].operands == TWO_OPERANDS) == follows_operand(source, i))) {
            (void)add(mutations, source, i, i, replacements[k].to);
        }
    }
}

static void replace_by_sibling(struct mutations *mutations, const struct source *source, size_t i,
                               const struct siblings *siblings) {
    struct sibling wanted = {{0}, {0}};
    const struct sibling *found;

    copy_token(wanted.name, sizeof wanted.name, source, i);
    found = siblings->count > 0
                ? bsearch(&wanted, siblings->list, siblings->count, sizeof *siblings->list, by_name)
                : NULL;
    if (found != NULL && source->tokens[i].function != NO_FUNCTION) {
        (void)add(mutations, source, i, i, found->other);
    }
}

/* ---- Numbers --------------------------------------------------------------------------------- */

/* Tells if token i is the number of elements of a declared array: one more changes nothing. */
static bool is_array_size(const struct source *source, size_t i) {
    return i >= 3 && source_is(source, i - 1, "[") && source_is(source, i + 1, "]") &&
           source->tokens[i - 2].kind == TOKEN_WORD &&
           (source->tokens[i - 3].kind == TOKEN_WORD || source_is(source, i - 3, ","));
}

static void replace_number(struct mutations *mutations, const struct source *source, size_t i) {
    char digits[64], text[160], *suffix;
    unsigned long long value;
    bool is_hexadecimal;

    copy_token(digits, sizeof digits, source, i);
    is_hexadecimal = digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X');
    errno = 0;
    value = strtoull(digits, &suffix, 0);
    if (strpbrk(digits, is_hexadecimal ? ".pP" : ".eE") != NULL) {
        (void)snprintf(text, sizeof text, "(2 * %s)", digits);
        (void)add(mutations, source, i, i, text);
        (void)snprintf(text, sizeof text, "(%s / 2)", digits);
        (void)add(mutations, source, i, i, text);
    } else if (errno == 0 && value < ~0ULL) {
        const char *format = is_hexadecimal ? "0x%llX%s" : "%llu%s";

        if (!is_array_size(source, i)) {
            (void)snprintf(text, sizeof text, format, value + 1, suffix);
            (void)add(mutations, source, i, i, text);
        }
        if (value > 0) {
            (void)snprintf(text, sizeof text, format, value - 1, suffix);
            (void)add(mutations, source, i, i, text);
        }
    }
}

/* ---- Statements ------------------------------------------------------------------------------ */

/* Appends what makes a condition its opposite. Token i is the word before the parenthesis. */
static void negate_condition(struct mutations *mutations, const struct source *source, size_t i) {
    size_t open = i + 1;

    if (source_is(source, open, "(") && source->tokens[open].partner > open + 1) {
        add(mutations, source, open, source->tokens[open].partner, "(!")->is_wrapped = true;
    }
}

/* Appends what ends a loop one earlier or later. Token i is `for`. */
static void move_loop_bound(struct mutations *mutations, const struct source *source, size_t i) {
    static const char *const comparisons[] = {"<", "<=", ">", ">=", "!=", NULL};
    size_t end = source_is(source, i + 1, "(") ? source->tokens[i + 1].partner : 0;
    bool is_compared = false;
    int semicolons = 0;

    for (size_t k = i + 2; k < end; k++) {
        if (source->tokens[k].parentheses != source->tokens[i].parentheses + 1) {
            continue;
        }
        is_compared = is_compared || is_any(source, k, comparisons);
        semicolons += source_is(source, k, ";");
        if (semicolons == 2 && source_is(source, k, ";")) {
            if (is_compared) {
                (void)add(mutations, source, k, k, " - 1;");
                (void)add(mutations, source, k, k, " + 1;");
            }
            return;
        }
    }
}

/* Returns the index of the semicolon that ends the statement from token i on, or i. */
static size_t end_of_statement(const struct source *source, size_t i) {
    for (size_t k = i; k < source->count && source->tokens[k].braces >= source->tokens[i].braces;
         k++) {
        if (source->tokens[k].braces == source->tokens[i].braces &&
            source->tokens[k].parentheses == 0 && source_is(source, k, ";")) {
            return k;
        }
    }
    return i;
}

static bool begins_statement(const struct source *source, size_t i) {
    static const char *const before[] = {"{", "}", ";", "else", ":", NULL};
    static const char *const headers[] = {"if", "for", "while", "switch", NULL};

    if (i == 0 || source->tokens[i].function == NO_FUNCTION || source->tokens[i].parentheses != 0) {
        return false;
    }
    if (source_is(source, i - 1, ")")) {
        size_t open = source->tokens[i - 1].partner;

        return open > 0 && is_any(source, open - 1, headers);
    }
    return is_any(source, i - 1, before);
}

/* Tells if the statement from token i on to `end` can go: an assignment, a call, a jump. */
static bool is_droppable(const struct source *source, size_t i, size_t end) {
    static const char *const jumps[] = {"break", "continue", NULL};
    static const char *const others[] = {
        "return", "if",     "for",    "while", "do",    "switch",  "case",    "else", "goto",
        "const",  "static", "struct", "enum",  "union", "default", "typedef", NULL};
    bool is_word = source->tokens[i].kind == TOKEN_WORD;

    if (is_any(source, i, jumps)) {
        return true;
    }
    if (end <= i + 1 || is_any(source, i, others) || source_is(source, i, "{") ||
        source_is(source, i, "}")) {
        return false;
    }
    return !is_word || (source->tokens[i + 1].kind == TOKEN_SIGN &&
                        !source_is(source, i + 1, "*") && !source_is(source, i + 1, ":"));
}

static void replace_returned(struct mutations *mutations, const struct source *source, size_t i,
                             size_t end) {
    static const char *const covered[] = {"true", "false", "NULL", NULL};
    bool is_plain = end == i + 2 &&
                    (source->tokens[i + 1].kind == TOKEN_NUMBER || is_any(source, i + 1, covered));

    if (end == i + 1) {
        (void)add(mutations, source, i, end, ";");
    } else if (!is_plain) {
        (void)add(mutations, source, i + 1, end, "0;");
    }
}

static void change_statement(struct mutations *mutations, const struct source *source, size_t i) {
    size_t end;

    if (!begins_statement(source, i)) {
        return;
    }
    end = end_of_statement(source, i);
    if (source_is(source, i, "return")) {
        replace_returned(mutations, source, i, end);
    } else if (is_droppable(source, i, end)) {
        (void)add(mutations, source, i, end, ";");
    }
}

void operators_apply(struct mutations *mutations, const struct source *source,
                     const struct siblings *siblings) {
    for (size_t i = 0; i < source->count; i++) {
        change_statement(mutations, source, i);
        if (source->tokens[i].kind == TOKEN_NUMBER) {
            replace_number(mutations, source, i);
        } else if (source_is(source, i, "if") || source_is(source, i, "while")) {
            negate_condition(mutations, source, i);
        } else if (source_is(source, i, "for")) {
            move_loop_bound(mutations, source, i);
        } else {
            replace_sign(mutations, source, i);
            replace_by_sibling(mutations, source, i, siblings);
        }
    }
}
