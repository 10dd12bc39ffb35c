/* SPDX-License-Identifier: MIT */
/* What every part of a run on Unicorn needs: registers, an end, a pause. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "boot/unicorn_run_internal.h"

enum { CONTROL_PROTECTED = 0x00000001 }; /* a bit of CR0 */

static const int register_numbers[PROCESSOR_REGISTERS] = {
    UC_X86_REG_EAX, UC_X86_REG_EBX,    UC_X86_REG_ECX, UC_X86_REG_EDX,
    UC_X86_REG_ESI, UC_X86_REG_EDI,    UC_X86_REG_EBP, UC_X86_REG_ESP,
    UC_X86_REG_EIP, UC_X86_REG_EFLAGS, UC_X86_REG_CS,  UC_X86_REG_DS,
    UC_X86_REG_ES,  UC_X86_REG_FS,     UC_X86_REG_GS,  UC_X86_REG_SS};

void unicorn_end(struct run *run, enum processor_end end, const char *format, ...) {
    va_list arguments;
    if (run->is_over) {
        return; /* the first reason counts */
    }
    run->is_over = true;
    run->report->end = end;
    va_start(arguments, format);
    (void)vsnprintf(run->report->reason, sizeof run->report->reason, format, arguments);
    va_end(arguments);
    (void)run->unicorn.emu_stop(run->engine);
}

void unicorn_lack_387(struct run *run) {
    unicorn_end(run, PROCESSOR_LOST, "an instruction of a 387, which this machine lacks");
}

void unicorn_lack_opcode(struct run *run) {
    unicorn_end(run, PROCESSOR_LOST, "an opcode that the CPU does not have");
}

uint32_t unicorn_get(struct run *run, int number) {
    uint32_t value = 0;
    (void)run->unicorn.reg_read(run->engine, number, &value);
    return value;
}

void unicorn_set(struct run *run, int number, uint32_t value) {
    (void)run->unicorn.reg_write(run->engine, number, &value);
}

uint32_t unicorn_address(struct run *run, int segment, uint32_t offset) {
    return 16 * (unicorn_get(run, segment) & 0xFFFF) + (offset & 0xFFFF);
}

bool unicorn_is_protected(struct run *run) {
    return (unicorn_get(run, UC_X86_REG_CR0) & CONTROL_PROTECTED) != 0;
}

void unicorn_pause(struct run *run, enum pause pause, uint32_t vector) {
    if (run->pause == PAUSE_NONE) {
        run->pause = pause;
        run->vector = vector;
        (void)run->unicorn.emu_stop(run->engine);
    }
}

void unicorn_get_all(struct run *run, uint32_t registers[PROCESSOR_REGISTERS]) {
    for (int i = 0; i < PROCESSOR_REGISTERS; i++) {
        registers[i] = unicorn_get(run, register_numbers[i]);
    }
}

void unicorn_set_all(struct run *run, const uint32_t registers[PROCESSOR_REGISTERS]) {
    for (int i = 0; i < PROCESSOR_REGISTERS; i++) {
        unicorn_set(run, register_numbers[i], registers[i]);
    }
}

bool unicorn_write(struct run *run, uint32_t address, const uint8_t *bytes, uint32_t count) {
    const uc_control_type request =
        (uc_control_type)UC_CTL(UC_CTL_TB_REMOVE_CACHE, 2, (unsigned)UC_CTL_IO_WRITE);
    memset(run->blocks, 0, sizeof run->blocks);
    return run->unicorn.mem_write(run->engine, address, bytes, count) == UC_ERR_OK &&
           run->unicorn.ctl(run->engine, request, (uint64_t)address, (uint64_t)address + count) ==
               UC_ERR_OK;
}
