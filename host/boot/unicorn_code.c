/* SPDX-License-Identifier: MIT */
/* What is looked at in a program's code before Unicorn runs it. */
#include <inttypes.h>
#include <string.h>

#include "boot/instruction.h"
#include "boot/paging.h"
#include "boot/unicorn_run_internal.h"

static const uint32_t control_paging = 0x80000000U; /* a bit of CR0 */

void unicorn_check_paging(struct run *run) {
    struct paging_fault fault;
    if ((unicorn_get(run, UC_X86_REG_CR0) & control_paging) == 0 ||
        paging_is_identity(run->memory, MACHINE_BYTES, unicorn_get(run, UC_X86_REG_CR3), &fault)) {
        return;
    }
    if (fault.is_missing) {
        unicorn_end(run, PROCESSOR_LOST, "paging without a page at %08" PRIX32 "h is not emulated",
                    fault.linear);
    } else {
        unicorn_end(run, PROCESSOR_LOST,
                    "paging that maps %08" PRIX32 "h to %08" PRIX32 "h is not emulated",
                    fault.linear, fault.physical);
    }
}

/* Tells whether the code segment is one of 32 bits. */
static bool code_is_32(struct run *run) {
    uc_x86_mmr table = {.limit = 0};
    uint32_t entry = unicorn_get(run, UC_X86_REG_CS) & 0xFFF8;
    if (!unicorn_is_protected(run) ||
        run->unicorn.reg_read(run->engine, UC_X86_REG_GDTR, &table) != UC_ERR_OK ||
        entry + 7 > table.limit || table.base + entry + 7 >= MACHINE_BYTES) {
        return false;
    }
    return (run->memory[table.base + entry + 6] & 0x40) != 0;
}

/* What the CPU has not, whatever its age. */
static const uint8_t undefined[] = {0x0F, 0x0B};

void unicorn_make_undefined(struct run *run, uint32_t address) {
    (void)unicorn_write(run, address, undefined, sizeof undefined);
}

/* Refuses an instruction of a later CPU. In real mode the code before it runs first. So
 * the instruction is made one that no CPU has, and the exception comes from there. */
static void refuse_instruction(struct run *run, uint32_t address) {
    const uint8_t *bytes = run->memory + address;
    if (memcmp(bytes, undefined, sizeof undefined) == 0) {
        return;
    }
    if (unicorn_is_protected(run)) {
        unicorn_end(run, PROCESSOR_LOST, "%02X %02X at %08" PRIX32 "h is no opcode of a 386",
                    bytes[0], bytes[1], address);
        return;
    }
    unicorn_pause(run, PAUSE_CODE, address);
}

/* Looks through a block of code that is met for the first time. */
static void look_through(struct run *run, struct block *block, uint32_t address, uint32_t bytes) {
    uint32_t base = run->is_line_20_followed ? address : address & (LINE_20 - 1);
    bool is_32 = code_is_32(run);
    block->has_387 = false;
    block->writes_control = false;
    for (uint32_t at = 0; at < bytes && base < MACHINE_BYTES - bytes;) {
        struct instruction instruction =
            instruction_decode(run->memory + base + at, bytes - at, is_32);
        if (instruction.length == 0) {
            return;
        }
        if (instruction.kind == INSTRUCTION_NOT_ON_A_386) {
            refuse_instruction(run, base + at + (uint32_t)instruction.opcode);
            return;
        }
        block->has_387 = block->has_387 || instruction.kind == INSTRUCTION_387;
        block->writes_control = block->writes_control || instruction.kind == INSTRUCTION_CONTROL;
        at += (uint32_t)instruction.length;
    }
}

/* Asks for the number of instructions once, and keeps it. */
const struct block *unicorn_find_block(struct run *run, uint32_t address, uint32_t bytes) {
    /* As unsigned: UC_CTL_READ_WRITE() shifts a bit into the sign. */
    const uc_control_type request =
        (uc_control_type)UC_CTL(UC_CTL_TB_REQUEST_CACHE, 2, (unsigned)UC_CTL_IO_READ_WRITE);
    struct block *block = &run->blocks[(address ^ address >> 12) & (BLOCKS - 1)];
    if (block->address != address || block->instructions == 0) {
        uc_tb translated;
        if (run->unicorn.ctl(run->engine, request, (uint64_t)address, &translated) != UC_ERR_OK) {
            unicorn_end(run, PROCESSOR_LOST, "the code there cannot be read");
            return NULL;
        }
        block->address = address;
        block->instructions = translated.icount;
        look_through(run, block, address, bytes);
    }
    return block;
}
