/* SPDX-License-Identifier: MIT */
/* Unicorn, loaded when it is first needed. */
#ifndef SUPERFRAME_UNICORN_LIBRARY_H
#define SUPERFRAME_UNICORN_LIBRARY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <unicorn/unicorn.h>

/* The functions of Unicorn that are used here, by their names without uc_. The library has 20 MB
 * and 60,000 relocations. Linked as usual, they would take most of the start of every other
 * command. */
struct unicorn_library {
    uc_err (*open)(uc_arch arch, uc_mode mode, uc_engine **engine);
    uc_err (*close)(uc_engine *engine);
    uc_err (*ctl)(uc_engine *engine, uc_control_type control, ...);
    uc_err (*mem_map_ptr)(uc_engine *engine, uint64_t address, size_t size, uint32_t permissions,
                          void *bytes);
    uc_err (*mem_unmap)(uc_engine *engine, uint64_t address, size_t size);
    uc_err (*mem_read)(uc_engine *engine, uint64_t address, void *bytes, size_t size);
    uc_err (*mem_write)(uc_engine *engine, uint64_t address, const void *bytes, size_t size);
    uc_err (*reg_read)(uc_engine *engine, int number, void *value);
    uc_err (*reg_write)(uc_engine *engine, int number, const void *value);
    uc_err (*emu_start)(uc_engine *engine, uint64_t begin, uint64_t until, uint64_t timeout,
                        size_t count);
    uc_err (*emu_stop)(uc_engine *engine);
    uc_err (*hook_add)(uc_engine *engine, uc_hook *hook, int type, void *function, void *context,
                       uint64_t begin, uint64_t end, ...);
    const char *(*strerror)(uc_err error);
};

/* Loads Unicorn, which stays loaded. Returns false, with one English sentence in `message`, if the
 * library is missing or lacks a function. */
bool unicorn_library_load(struct unicorn_library *library, char *message, size_t size);

#endif
