/* SPDX-License-Identifier: MIT */
/* Lines of shell in the current folder, and what they leave in files. */
#ifndef SUPERFRAME_TESTS_SHELL_FIXTURE_H
#define SUPERFRAME_TESTS_SHELL_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum { TEXT_SIZE = 65536, PATH_SIZE = 4096 };

/* All of a file as text; "" if it is not there. */
static inline const char *text_of(const char *path) {
    static char text[TEXT_SIZE];
    FILE *file = fopen(path, "rb");
    size_t length = 0;
    if (file != NULL) {
        length = fread(text, 1, sizeof text - 1, file);
        (void)fclose(file);
    }
    text[length] = '\0';
    return text;
}

/* Runs a line of shell with a limit of time; its output goes to the files out and err. */
static inline int run(const char *line) {
    FILE *script = fopen("line", "w");
    assert_non_null(script);
    (void)fprintf(script, "%s\n", line);
    (void)fclose(script);
    int status = system("timeout -k 5 250 sh ./line > out 2> err < /dev/null");
    (void)unlink("line");
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static inline void assert_status(const char *line, int expected) {
    int status = run(line);
    if (status != expected) {
        fail_msg("\"%s\": status %d instead of %d: %s", line, status, expected, text_of("err"));
    }
}

static inline bool is_there(const char *path) {
    return access(path, F_OK) == 0;
}

#endif
