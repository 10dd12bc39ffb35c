/* SPDX-License-Identifier: MIT */
/* A C file as tokens: as much of the language as drawing a mutant takes. */
#ifndef SUPERFRAME_TESTS_MUTANTS_SOURCE_H
#define SUPERFRAME_TESTS_MUTANTS_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

enum token_kind { TOKEN_WORD, TOKEN_NUMBER, TOKEN_TEXT, TOKEN_SIGN };

struct token {
    enum token_kind kind;
    size_t start, end; /* bytes of the text */
    int line;          /* from 1 */
    int braces;        /* that are open before the token */
    int parentheses;   /* and brackets that are open before the token */
    size_t partner;  /* of a bracket of any kind: the other's index, or its own if there is none */
    size_t function; /* index of the enclosing function's name, or NO_FUNCTION */
};

#define NO_FUNCTION ((size_t)-1)

struct source {
    const char *path;
    char *text;
    size_t length;
    struct token *tokens;
    size_t count;
};

/* Reads a file and splits the file into tokens. Ends the program with status 2 if that fails. */
struct source source_read(const char *path);

/* Tells if token i of a source is there and is exactly these characters. */
bool source_is(const struct source *source, size_t i, const char *characters);

/* Ends the program with status 2 if memory could not be had. Returns the memory. */
void *source_memory(void *memory);

#endif
