/* SPDX-License-Identifier: MIT */
/* Error messages, all in one form: "superframe: ..." on standard error. */
#include "base/complain.h"

#include <stdarg.h>
#include <stdio.h>

/* Prints a message by one call of fprintf, so that the messages of two processes don't mix within a
 * line. */
static void print_message(const char *format, va_list arguments) {
    char text[1024];
    (void)vsnprintf(text, sizeof text, format, arguments);
    (void)fprintf(stderr, "superframe: %s\n", text);
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
