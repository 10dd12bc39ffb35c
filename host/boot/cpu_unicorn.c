/* SPDX-License-Identifier: MIT */
/* The processor, emulated by Unicorn, a library made of QEMU's CPU. */
#include "boot/cpu.h"

#include <inttypes.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boot/unicorn_library.h"

enum {
    BOOT_SEGMENT = 0x1FC0,
    DRIVE_BYTE = 0x584,
    DRIVE_2HD = 0x90,
    MEMORY_BYTES = 0xA0000,
    TEXT_BASE = 0xA0000,
    INTERRUPT_DISK = 0x1B,
    DISK_READ = 0x06, /* the low four bits of AH */
    STATUS_NO_SECTOR = 0xE0,
    FLAG_CARRY = 0x0001,
    FLAG_INTERRUPTS = 0x0200,
    BLOCKS = 4096 /* entries of the table of block lengths; a power of two */
};

/* The regions of memory: begin and length. */
static const struct {
    uint32_t begin, length;
} regions[] = {{0, MEMORY_BYTES}, {TEXT_BASE, 0x4000}, {0xA8000, 0x18000}, {0xE0000, 0x8000}};

static const int register_numbers[PROCESSOR_REGISTERS] = {
    UC_X86_REG_EAX, UC_X86_REG_EBX,    UC_X86_REG_ECX, UC_X86_REG_EDX,
    UC_X86_REG_ESI, UC_X86_REG_EDI,    UC_X86_REG_EBP, UC_X86_REG_ESP,
    UC_X86_REG_EIP, UC_X86_REG_EFLAGS, UC_X86_REG_CS,  UC_X86_REG_DS,
    UC_X86_REG_ES,  UC_X86_REG_FS,     UC_X86_REG_GS,  UC_X86_REG_SS};

/* The number of instructions of the block of code that begins at an address. */
struct block_length {
    uint32_t address, instructions;
};

struct run {
    const struct processor_job *job;
    struct processor_report *report;
    struct unicorn_library unicorn;
    uc_engine *engine;
    struct pc98_ports ports;
    bool is_over; /* report->end and reason say why */
    struct block_length blocks[BLOCKS];
};

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static void
end_run(struct run *run, enum processor_end end, const char *format, ...) {
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

static uint32_t get_register(struct run *run, int number) {
    uint32_t value = 0;
    (void)run->unicorn.reg_read(run->engine, number, &value);
    return value;
}

static void set_register(struct run *run, int number, uint32_t value) {
    (void)run->unicorn.reg_write(run->engine, number, &value);
}

/* ---- Hooks ----------------------------------------------------------------------------------- */

/* Counts the instructions of a block of code before the block runs. Unicorn has translated the
 * block by then and knows its length, which is asked for once and kept. */
static void enter_block(uc_engine *engine, uint64_t address, uint32_t size, void *context) {
    /* As unsigned: UC_CTL_READ_WRITE() shifts a bit into the sign. */
    const uc_control_type request =
        (uc_control_type)UC_CTL(UC_CTL_TB_REQUEST_CACHE, 2, (unsigned)UC_CTL_IO_READ_WRITE);
    struct run *run = context;
    struct block_length *block = &run->blocks[(address ^ address >> 12) & (BLOCKS - 1)];
    (void)size;
    if (block->address != (uint32_t)address || block->instructions == 0) {
        uc_tb translated;
        if (run->unicorn.ctl(engine, request, address, &translated) != UC_ERR_OK) {
            end_run(run, PROCESSOR_LOST, "the code there cannot be read");
            return;
        }
        block->address = (uint32_t)address;
        block->instructions = translated.icount;
    }
    run->report->instructions += block->instructions;
    if (run->report->instructions > run->job->instructions_most) {
        end_run(run, PROCESSOR_LIMIT, "no end within %" PRIu64 " instructions",
                run->job->instructions_most);
    } else if (run->job->stop != NULL && *run->job->stop != 0) {
        end_run(run, PROCESSOR_STOPPED, "stopped");
    }
}

static void check_bus(struct run *run) {
    if (run->ports.bus->status != BUS_OK) {
        end_run(run, PROCESSOR_BUS_FAILED, "%s", bus_status_text(run->ports.bus->status));
    }
}

static uint32_t take_in(uc_engine *engine, uint32_t port, int width, void *context) {
    struct run *run = context;
    uint32_t value = pc98_port_read(&run->ports, (uint16_t)port, (unsigned)width);
    (void)engine;
    check_bus(run);
    return value;
}

static void take_out(uc_engine *engine, uint32_t port, int width, uint32_t value, void *context) {
    struct run *run = context;
    (void)engine;
    pc98_port_write(&run->ports, (uint16_t)port, value, (unsigned)width);
    check_bus(run);
}

/* Answers a read of the disk BIOS. AH is 56h or a variant of it, AL the drive, BX the number of
 * bytes. CL is the cylinder, DH the head, DL the sector, ES:BP the destination. Carry and AH say
 * what went wrong. */
static void read_disk(struct run *run) {
    uint32_t eax = get_register(run, UC_X86_REG_EAX), flags = get_register(run, UC_X86_REG_EFLAGS);
    uint32_t ecx = get_register(run, UC_X86_REG_ECX), edx = get_register(run, UC_X86_REG_EDX);
    uint32_t bytes = get_register(run, UC_X86_REG_EBX) & 0xFFFF;
    uint32_t to = 16 * (get_register(run, UC_X86_REG_ES) & 0xFFFF) +
                  (get_register(run, UC_X86_REG_EBP) & 0xFFFF);
    uint8_t status = STATUS_NO_SECTOR;
    size_t offset;
    if ((eax & 0xFF) == DRIVE_2HD && (eax >> 8 & 0x0F) == DISK_READ &&
        pc98_disk_place(ecx & 0xFF, edx >> 8 & 0xFF, edx & 0xFF, bytes, &offset) &&
        to + bytes <= MEMORY_BYTES &&
        run->unicorn.mem_write(run->engine, to, run->job->disk + offset, bytes) == UC_ERR_OK) {
        status = 0;
        memset(run->blocks, 0, sizeof run->blocks); /* there may be other code now */
    }
    set_register(run, UC_X86_REG_EAX, (eax & ~UINT32_C(0xFF00)) | (uint32_t)status << 8);
    set_register(run, UC_X86_REG_EFLAGS,
                 status == 0 ? flags & ~(uint32_t)FLAG_CARRY : flags | FLAG_CARRY);
}

/* Handles INT n and the CPU's own exceptions. */
static void take_interrupt(uc_engine *engine, uint32_t number, void *context) {
    struct run *run = context;
    uint32_t control = 0;
    (void)run->unicorn.reg_read(engine, UC_X86_REG_CR0, &control);
    if (number == INTERRUPT_DISK && (control & 1) == 0) {
        read_disk(run);
        return;
    }
    end_run(run, PROCESSOR_LOST,
            "interrupt or exception %02" PRIX32 "h; of the ROM there is INT 1Bh only", number);
}

static bool refuse_opcode(uc_engine *engine, void *context) {
    struct run *run = context;
    (void)engine;
    end_run(run, PROCESSOR_LOST, "an opcode that the CPU does not have");
    return false;
}

static bool refuse_address(uc_engine *engine, uc_mem_type type, uint64_t address, int size,
                           int64_t value, void *context) {
    struct run *run = context;
    const char *access = type == UC_MEM_WRITE_UNMAPPED  ? "written to"
                         : type == UC_MEM_READ_UNMAPPED ? "read"
                                                        : "run";
    (void)engine;
    (void)size;
    (void)value;
    end_run(run, PROCESSOR_LOST, "%08" PRIX64 "h was %s; nothing is there", address, access);
    return false;
}

/* ---- The run --------------------------------------------------------------------------------- */

static bool add_hooks(struct run *run) {
    const struct {
        int type, instruction;
        void (*function)(void);
    } hooks[] = {
        {UC_HOOK_BLOCK, 0, (void (*)(void))enter_block},
        {UC_HOOK_INSN, UC_X86_INS_IN, (void (*)(void))take_in},
        {UC_HOOK_INSN, UC_X86_INS_OUT, (void (*)(void))take_out},
        {UC_HOOK_INTR, 0, (void (*)(void))take_interrupt},
        {UC_HOOK_INSN_INVALID, 0, (void (*)(void))refuse_opcode},
        {UC_HOOK_MEM_UNMAPPED, 0, (void (*)(void))refuse_address},
    };
    for (size_t i = 0; i < sizeof hooks / sizeof hooks[0]; i++) {
        uc_hook handle;
        void *function;
        /* Unicorn takes a function as void *, a conversion that C99 does not have. */
        memcpy(&function, &hooks[i].function, sizeof function);
        if (run->unicorn.hook_add(run->engine, &handle, hooks[i].type, function, run, (uint64_t)1,
                                  (uint64_t)0, hooks[i].instruction) != UC_ERR_OK) {
            return false;
        }
    }
    return true;
}

/* Sets the machine up as its ROM leaves it for the jump to the boot sector; false if Unicorn
 * fails. */
static bool prepare(struct run *run) {
    const uint8_t drive = DRIVE_2HD;
    const uint16_t segment = BOOT_SEGMENT;
    const uint16_t stack_segment = 0x30, stack = 0x00F0;
    if (run->unicorn.open(UC_ARCH_X86, UC_MODE_16, &run->engine) != UC_ERR_OK) {
        return false;
    }
    for (size_t i = 0; i < sizeof regions / sizeof regions[0]; i++) {
        if (run->unicorn.mem_map(run->engine, regions[i].begin, regions[i].length, UC_PROT_ALL) !=
            UC_ERR_OK) {
            return false;
        }
    }
    return run->unicorn.mem_write(run->engine, DRIVE_BYTE, &drive, 1) == UC_ERR_OK &&
           run->unicorn.mem_write(run->engine, 16 * BOOT_SEGMENT, run->job->disk,
                                  PC98_SECTOR_BYTES) == UC_ERR_OK &&
           run->unicorn.reg_write(run->engine, UC_X86_REG_CS, &segment) == UC_ERR_OK &&
           run->unicorn.reg_write(run->engine, UC_X86_REG_SS, &stack_segment) == UC_ERR_OK &&
           run->unicorn.reg_write(run->engine, UC_X86_REG_SP, &stack) == UC_ERR_OK &&
           add_hooks(run);
}

/* Reports the registers, where the CPU stands, and the text screen. In protected mode the base of
 * the code segment is taken as 0. */
static void describe_place(struct run *run) {
    struct processor_report *report = run->report;
    uint32_t control = 0;
    uint8_t vram[PC98_TEXT_BYTES];
    for (int i = 0; i < PROCESSOR_REGISTERS; i++) {
        report->registers[i] = get_register(run, register_numbers[i]);
    }
    (void)run->unicorn.reg_read(run->engine, UC_X86_REG_CR0, &control);
    report->is_protected = (control & 1) != 0;
    report->address = report->registers[REGISTER_EIP];
    if (!report->is_protected) {
        report->address += 16 * (report->registers[REGISTER_CS] & 0xFFFF);
    }
    if (run->unicorn.mem_read(run->engine, TEXT_BASE, vram, sizeof vram) == UC_ERR_OK) {
        pc98_text_read(vram, &report->text);
    }
}

/* The place that abort() leads to while Unicorn runs; global, as a signal handler takes no argument
 * of ours. */
static sigjmp_buf way_out;

static void leave_unicorn(int signal_number) {
    (void)signal_number;
    siglongjmp(way_out, 1);
}

/* Runs the CPU; false if Unicorn aborted. Version 2.0.1 aborts the program on opcodes that its
 * translator gets wrong, such as FF DF. */
static bool start(struct run *run, uc_err *error) {
    struct sigaction action, before;
    memset(&action, 0, sizeof action);
    action.sa_handler = leave_unicorn;
    (void)sigemptyset(&action.sa_mask);
    (void)sigaction(SIGABRT, &action, &before);
    bool has_returned = sigsetjmp(way_out, 1) == 0;
    if (has_returned) {
        *error = run->unicorn.emu_start(run->engine, 16 * BOOT_SEGMENT, UINT32_MAX, 0, 0);
    }
    (void)sigaction(SIGABRT, &before, NULL);
    return has_returned;
}

/* Runs the CPU to the run's end, and reports why the run ended. */
static void run_and_judge(struct run *run) {
    uc_err error = UC_ERR_OK;
    if (!start(run, &error)) {
        end_run(run, PROCESSOR_LOST, "Unicorn cannot translate the code there");
    } else if (error != UC_ERR_OK) {
        end_run(run, PROCESSOR_LOST, "%s", run->unicorn.strerror(error));
    } else if ((get_register(run, UC_X86_REG_EFLAGS) & FLAG_INTERRUPTS) != 0) {
        end_run(run, PROCESSOR_LOST, "waits for an interrupt; there are none");
    } else {
        end_run(run, PROCESSOR_HALTED, "halted");
    }
}

static void run_unicorn(const struct processor_job *job, struct processor_report *report) {
    struct run *run = calloc(1, sizeof *run);
    if (run == NULL) {
        (void)snprintf(report->reason, sizeof report->reason, "out of memory");
        return;
    }
    run->job = job;
    run->report = report;
    run->ports.bus = job->bus;
    run->ports.escape_after = job->escape_after;
    if (!unicorn_library_load(&run->unicorn, report->reason, sizeof report->reason)) {
        free(run);
        return;
    }
    if (prepare(run)) {
        run_and_judge(run);
        describe_place(run);
    } else {
        (void)snprintf(report->reason, sizeof report->reason, "Unicorn could not be set up");
    }
    if (run->engine != NULL) {
        (void)run->unicorn.close(run->engine);
    }
    free(run);
}

extern const struct processor processor_unicorn;

const struct processor processor_unicorn = {run_unicorn};
