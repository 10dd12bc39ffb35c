/* SPDX-License-Identifier: MIT */
/* Interrupts in real mode: the program's own vectors, and what of the ROM is there. */
#include <inttypes.h>
#include <string.h>

#include "boot/absent_387.h"
#include "boot/instruction.h"
#include "boot/unicorn_run_internal.h"

enum {
    VECTOR_387 = 0x07,
    VECTOR_DISK = 0x1B,
    FLAG_CARRY = 0x0001,
    FLAG_TRAP = 0x0100,
    HALT = 0xF4
};

static const uint8_t rom_code[] = {0x0F, 0x22, 0xC0, 0xF4}; /* mov cr0, eax; hlt */

void unicorn_fill_rom(struct run *run) {
    uint8_t *memory = run->memory;
    for (unsigned i = 0; i < VECTORS; i++) {
        memory[4 * i] = (uint8_t)i;
        memory[4 * i + 2] = ROM_SEGMENT & 0xFF;
        memory[4 * i + 3] = ROM_SEGMENT >> 8;
    }
    memset(memory + ROM_BASE, HALT, VECTORS);
    memcpy(memory + ROM_BASE + ROM_CODE, rom_code, sizeof rom_code);
}

/* Returns a word of the machine's memory; FFFFh, as a floating bus, where there is none. */
static uint32_t word_at(struct run *run, uint32_t address) {
    uint8_t bytes[2] = {0xFF, 0xFF};
    (void)run->unicorn.mem_read(run->engine, address, bytes, sizeof bytes);
    return bytes[0] | (uint32_t)bytes[1] << 8;
}

static bool set_word(struct run *run, uint32_t address, uint32_t word) {
    const uint8_t bytes[] = {(uint8_t)word, (uint8_t)(word >> 8)};
    return run->unicorn.mem_write(run->engine, address, bytes, sizeof bytes) == UC_ERR_OK;
}

/* Returns the linear address of a place in the stack, `above` bytes above SP. */
static uint32_t stack_address(struct run *run, uint32_t above) {
    return unicorn_address(run, UC_X86_REG_SS, unicorn_get(run, UC_X86_REG_ESP) + above);
}

static void move_stack(struct run *run, uint32_t by) {
    uint32_t esp = unicorn_get(run, UC_X86_REG_ESP);
    unicorn_set(run, UC_X86_REG_ESP, (esp & 0xFFFF0000U) | ((esp + by) & 0xFFFF));
}

static bool push(struct run *run, uint32_t word) {
    move_stack(run, 0U - 2);
    return set_word(run, stack_address(run, 0), word);
}

void unicorn_call_vector(struct run *run) {
    uc_x86_mmr table = {.limit = 0};
    uint32_t flags = unicorn_get(run, UC_X86_REG_EFLAGS);
    uint32_t entry = 4 * run->vector;
    (void)run->unicorn.reg_read(run->engine, UC_X86_REG_IDTR, &table);
    if (entry + 3 > table.limit) {
        unicorn_end(run, PROCESSOR_RESET,
                    "interrupt %02" PRIX32
                    "h is past the end of the table of vectors: the CPU resets",
                    run->vector);
        return;
    }
    entry += (uint32_t)table.base;
    uint32_t offset = word_at(run, entry), segment = word_at(run, entry + 2);
    if (!push(run, flags) || !push(run, unicorn_get(run, UC_X86_REG_CS)) ||
        !push(run, unicorn_get(run, UC_X86_REG_EIP))) {
        unicorn_end(run, PROCESSOR_LOST, "the stack is where no memory is");
        return;
    }
    unicorn_set(run, UC_X86_REG_EFLAGS, flags & ~(uint32_t)(FLAG_TRAP | FLAG_INTERRUPTS));
    unicorn_set(run, UC_X86_REG_CS, segment);
    unicorn_set(run, UC_X86_REG_EIP, offset);
}

/* Returns from a vector as IRET does, with the carry flag as given. */
static void return_from_vector(struct run *run, bool carry) {
    uint32_t flags = word_at(run, stack_address(run, 4));
    flags = carry ? flags | FLAG_CARRY : flags & ~(uint32_t)FLAG_CARRY;
    unicorn_set(run, UC_X86_REG_EIP, word_at(run, stack_address(run, 0)));
    unicorn_set(run, UC_X86_REG_CS, word_at(run, stack_address(run, 2)));
    unicorn_set(run, UC_X86_REG_EFLAGS,
                (unicorn_get(run, UC_X86_REG_EFLAGS) & 0xFFFF0000U) | flags);
    move_stack(run, 6);
}

/* Does INT 1Bh. Returns what AH is to hold. */
static enum pc98_disk_status serve_disk(struct run *run) {
    struct pc98_disk_call *call = &run->call;
    uint32_t eax = unicorn_get(run, UC_X86_REG_EAX), ecx = unicorn_get(run, UC_X86_REG_ECX);
    uint32_t edx = unicorn_get(run, UC_X86_REG_EDX);
    call->ah = (uint8_t)(eax >> 8);
    call->al = (uint8_t)eax;
    call->ch = (uint8_t)(ecx >> 8);
    call->cl = (uint8_t)ecx;
    call->dh = (uint8_t)(edx >> 8);
    call->dl = (uint8_t)edx;
    call->bx = (uint16_t)unicorn_get(run, UC_X86_REG_EBX);
    call->address = unicorn_address(run, UC_X86_REG_ES, unicorn_get(run, UC_X86_REG_EBP));
    memset(call->buffer, 0xFF, call->bx); /* what a floating bus gives where no memory is */
    (void)run->unicorn.mem_read(run->engine, call->address, call->buffer, call->bx);
    enum pc98_disk_status status = pc98_disk_serve(run->job->disk, call);
    if (call->received > 0) {
        (void)unicorn_write(run, call->address, call->buffer, call->received);
    }
    unicorn_set(run, UC_X86_REG_EAX, (eax & ~UINT32_C(0xFF00)) | (status & 0xFFU) << 8);
    unicorn_set(run, UC_X86_REG_ECX,
                (ecx & ~UINT32_C(0xFFFF)) | (uint32_t)call->ch << 8 | call->cl);
    unicorn_set(run, UC_X86_REG_EDX,
                (edx & ~UINT32_C(0xFFFF)) | (uint32_t)call->dh << 8 | call->dl);
    return status;
}

/* Goes on behind an instruction of a 387 as a machine without one does, or ends the run. */
static void pass_387(struct run *run) {
    uint32_t registers[PROCESSOR_REGISTERS];
    uint8_t code[INSTRUCTION_BYTES_MOST] = {0};
    unicorn_get_all(run, registers);
    uint32_t address = unicorn_address(run, UC_X86_REG_CS, registers[REGISTER_EIP]);
    (void)run->unicorn.mem_read(run->engine, address, code, sizeof code);
    struct absent_387_answer answer = absent_387_answer(code, sizeof code, registers);
    if (!answer.is_known || (answer.is_stored && !set_word(run, answer.address, 0xFFFF))) {
        unicorn_lack_387(run);
        return;
    }
    if (answer.is_ax) {
        unicorn_set(run, UC_X86_REG_EAX, registers[REGISTER_EAX] | 0xFFFF);
    }
    unicorn_set(run, UC_X86_REG_EIP, (registers[REGISTER_EIP] + answer.length) & 0xFFFF);
}

void unicorn_run_rom(struct run *run) {
    enum pc98_disk_status status = DISK_DONE;
    if (run->vector == VECTOR_DISK) {
        status = serve_disk(run);
    }
    return_from_vector(run, status >= DISK_ERRORS);
    if (status == DISK_NOT_EMULATED) {
        unicorn_end(run, PROCESSOR_LOST, "INT 1Bh with AH = %02Xh is not emulated", run->call.ah);
    } else if (run->vector == VECTOR_OPCODE) {
        unicorn_lack_opcode(run);
    } else if (run->vector == VECTOR_387) {
        pass_387(run);
    } else if (run->vector != VECTOR_DISK) {
        unicorn_end(run, PROCESSOR_LOST,
                    "interrupt or exception %02" PRIX32 "h; of the ROM there is INT 1Bh only",
                    run->vector);
    }
}
