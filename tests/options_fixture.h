/* SPDX-License-Identifier: MIT */
/* Command lines for tests, as one text each. */
#ifndef SUPERFRAME_OPTIONS_FIXTURE_H
#define SUPERFRAME_OPTIONS_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "command/command.h"

enum { WORDS_MOST = 32, LINE_SIZE = 256 };

/* Parses a line of words with one blank between each two; its first word is dropped. What the
 * options point to stays until the next line. */
static inline bool parse(enum command_id command, const char *line, struct options *options,
                         struct options_error *error) {
    static char text[LINE_SIZE];
    static char *words[WORDS_MOST + 1];
    int count = 0;
    (void)snprintf(text, sizeof text, "%s", line);
    for (char *word = strtok(text, " "); word != NULL && count < WORDS_MOST;
         word = strtok(NULL, " ")) {
        words[count++] = word;
    }
    words[count] = NULL;
    error->text[0] = '\0';
    return options_parse(&commands[command], count, words, options, error);
}

#endif
