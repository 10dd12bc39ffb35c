/* SPDX-License-Identifier: MIT */
/* Unicorn, loaded when it is first needed. */
#include "boot/unicorn_library.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

/* The library's names on Linux and macOS, of version 2, whose interface <unicorn/unicorn.h>
 * declares. */
static const char *const names[] = {"libunicorn.so.2", "libunicorn.2.dylib"};

static const struct {
    const char *name;
    size_t offset;
} functions[] = {
    {"uc_open", offsetof(struct unicorn_library, open)},
    {"uc_close", offsetof(struct unicorn_library, close)},
    {"uc_ctl", offsetof(struct unicorn_library, ctl)},
    {"uc_mem_map_ptr", offsetof(struct unicorn_library, mem_map_ptr)},
    {"uc_mem_unmap", offsetof(struct unicorn_library, mem_unmap)},
    {"uc_mem_read", offsetof(struct unicorn_library, mem_read)},
    {"uc_mem_write", offsetof(struct unicorn_library, mem_write)},
    {"uc_reg_read", offsetof(struct unicorn_library, reg_read)},
    {"uc_reg_write", offsetof(struct unicorn_library, reg_write)},
    {"uc_emu_start", offsetof(struct unicorn_library, emu_start)},
    {"uc_emu_stop", offsetof(struct unicorn_library, emu_stop)},
    {"uc_hook_add", offsetof(struct unicorn_library, hook_add)},
    {"uc_strerror", offsetof(struct unicorn_library, strerror)},
};

bool unicorn_library_load(struct unicorn_library *library, char *message, size_t size) {
    void *handle = NULL;
    for (size_t i = 0; handle == NULL && i < sizeof names / sizeof names[0]; i++) {
        handle = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    }
    if (handle == NULL) {
        (void)snprintf(message, size,
                       "there is no CPU: %s is not there; install libunicorn2 (Debian)", names[0]);
        return false;
    }
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        void *function = dlsym(handle, functions[i].name);
        if (function == NULL) {
            (void)snprintf(message, size, "Unicorn has no %s; version 2 is needed",
                           functions[i].name);
            return false;
        }
        /* POSIX gives a function as void *, a conversion that C99 does not have. */
        memcpy((char *)library + functions[i].offset, &function, sizeof function);
    }
    return true;
}
