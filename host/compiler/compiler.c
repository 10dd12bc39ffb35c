/* SPDX-License-Identifier: MIT */
/* What every step of the scene compiler may do: fail, show what it did, and note what it made. */
#include "compiler/compiler_internal.h"

#include <stdarg.h>
#include <stdio.h>

bool compile_fail(struct compiler *compiler, unsigned line, const char *format, ...) {
    char what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    const char *path = compiler->description->path;
    if (line > 0) {
        snprintf(compiler->error->text, sizeof compiler->error->text, "%.90s:%u: %s", path, line,
                 what);
    } else {
        snprintf(compiler->error->text, sizeof compiler->error->text, "%.100s: %s", path, what);
    }
    return false;
}

bool compile_fail_memory(struct compiler *compiler) {
    return compile_fail(compiler, 0, "out of memory");
}

uint32_t compile_fail_room(struct compiler *compiler) {
    (void)compile_fail_memory(compiler);
    return COMPILED_NONE;
}

void compile_show(const struct compiler *compiler, enum compile_step step) {
    if (compiler->observer != NULL) {
        compiler->observer->look(compiler->observer->context, step, compiler->scene);
    }
}

uint64_t compile_key(enum known kind) {
    return bucket_key(0, (uint64_t)kind);
}

uint32_t compile_note(struct compiler *compiler, uint64_t key, uint32_t entry) {
    return entry == COMPILED_NONE || buckets_add(&compiler->known, key, entry)
               ? entry
               : compile_fail_room(compiler);
}
