/* SPDX-License-Identifier: MIT */
/* Error messages, all in one form: "superframe: ..." on standard error. */
#include "base/complain.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MESSAGE_BYTES = 20000 };

/* Prints a message, each line by one call of fprintf, so that the messages of two processes don't
 * mix within a line. */
static void print_message(const char *format, va_list arguments) {
    char text[MESSAGE_BYTES];
    const bool is_terminal = isatty(STDERR_FILENO) == 1;
    (void)vsnprintf(text, sizeof text, format, arguments);
    for (const char *line = text, *end; line != NULL; line = end) {
        const int length = (int)strcspn(line, "\n");
        if (*line != ' ') {
            (void)fprintf(stderr, "superframe: %.*s\n", length, line);
        } else if (is_terminal) {
            (void)fprintf(stderr, "%.*s\n", length, line);
        }
        end = line[length] == '\n' ? line + length + 1 : NULL;
    }
}

void complain(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_message(format, arguments);
    va_end(arguments);
}

int failure(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_message(format, arguments);
    va_end(arguments);
    return STATUS_FAILED;
}

int bad_input(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    print_message(format, arguments);
    va_end(arguments);
    return STATUS_BAD_INPUT;
}
