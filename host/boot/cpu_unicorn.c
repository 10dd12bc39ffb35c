/* SPDX-License-Identifier: MIT */
/* The processor, emulated by Unicorn, a library made of QEMU's CPU. */
#include "boot/cpu.h"

#include <inttypes.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boot/unicorn_run_internal.h"

enum {
    BOOT_SEGMENT = 0x1FC0,
    BOOT_STACK_SEGMENT = 0x30,
    BOOT_STACK = 0x00F0,
    EXTENDED_SIZE_BYTE = 0x401, /* in 128 KiB */
    EXTENDED_1_MIB = 8,
    MEMORY_SIZE_BYTE = 0x501,
    MEMORY_640_KIB = 0x04,
    DRIVE_BYTE = 0x584,
    TEXT_BASE = 0xA0000
};

/* The regions of memory: begin and length. */
static const struct {
    uint32_t begin, length;
} regions[] = {
    {0, 0xA0000}, {TEXT_BASE, 0x4000}, {0xA8000, 0x18000}, {0xE0000, 0x8000}, {0xFD000, 0x1000}};

/* ---- Hooks ----------------------------------------------------------------------------------- */

/* Counts the instructions of a block of code before the block runs, and sees to what the block
 * needs. */
static void enter_block(uc_engine *engine, uint64_t address, uint32_t size, void *context) {
    struct run *run = context;
    (void)engine;
    if (run->is_in_rom) {
        return;
    }
    if (address - ROM_BASE < VECTORS) {
        unicorn_pause(run, PAUSE_ROM, (uint32_t)(address - ROM_BASE));
        return;
    }
    if (run->control_is_written) {
        run->control_is_written = false;
        unicorn_check_paging(run);
    }
    const struct block *block = unicorn_find_block(run, (uint32_t)address, size);
    if (block == NULL || run->pause != PAUSE_NONE) {
        return;
    }
    if (block->has_387 && (unicorn_get(run, UC_X86_REG_CR0) & CONTROL_NO_387) == 0) {
        if (unicorn_is_protected(run)) {
            unicorn_lack_387(run);
        } else {
            unicorn_pause(run, PAUSE_387, 0);
        }
        return;
    }
    run->control_is_written = block->writes_control;
    run->report->instructions += block->instructions;
    if (run->report->instructions > run->job->instructions_most) {
        unicorn_end(run, PROCESSOR_LIMIT, "no end within %" PRIu64 " instructions",
                    run->job->instructions_most);
    } else if (run->job->stop != NULL && *run->job->stop != 0) {
        unicorn_end(run, PROCESSOR_STOPPED, "stopped");
    }
}

/* Maps bytes of the machine's memory at an address; false if Unicorn fails. */
static bool map(struct run *run, uint32_t address, uint32_t begin, uint32_t length) {
    return run->unicorn.mem_map_ptr(run->engine, address, length, UC_PROT_ALL,
                                    run->memory + begin) == UC_ERR_OK;
}

/* Maps what lies below 1 MiB, `above` bytes above its own place. */
static bool map_regions(struct run *run, uint32_t above) {
    bool is_right = true;
    for (size_t i = 0; is_right && i < sizeof regions / sizeof regions[0]; i++) {
        is_right = map(run, above + regions[i].begin, regions[i].begin, regions[i].length);
    }
    return is_right;
}

/* Maps what lies above 1 MiB: with address line 20 the extended memory, without it what lies below
 * 1 MiB once more. */
static bool map_above(struct run *run) {
    run->is_line_20_followed = run->ports.is_line_20_on;
    return run->is_line_20_followed ? map(run, LINE_20, LINE_20, LINE_20)
                                    : map_regions(run, LINE_20);
}

/* Maps what lies above 1 MiB anew, after address line 20 was switched. */
static bool follow_line_20(struct run *run) {
    bool was_on = run->is_line_20_followed;
    bool is_right = !was_on || run->unicorn.mem_unmap(run->engine, LINE_20, LINE_20) == UC_ERR_OK;
    for (size_t i = 0; !was_on && is_right && i < sizeof regions / sizeof regions[0]; i++) {
        is_right = run->unicorn.mem_unmap(run->engine, LINE_20 + regions[i].begin,
                                          regions[i].length) == UC_ERR_OK;
    }
    return is_right && map_above(run);
}

/* Sees to what a port access has led to. */
static void check_ports(struct run *run) {
    if (run->ports.bus->status != BUS_OK) {
        unicorn_end(run, PROCESSOR_BUS_FAILED, "%s", bus_status_text(run->ports.bus->status));
    } else if (run->ports.is_reset) {
        unicorn_end(run, PROCESSOR_RESET, "the program has reset the machine (OUT F0h)");
    } else if (pc98_ports_wait_in_vain(&run->ports)) {
        run->report->instructions = run->instructions_before_wait;
        unicorn_end(run, PROCESSOR_WAITING, "waits for a key");
    } else if (run->ports.polls == 1) {
        run->instructions_before_wait = run->report->instructions;
    } else if (run->ports.is_line_20_on != run->is_line_20_followed && !follow_line_20(run)) {
        unicorn_end(run, PROCESSOR_LOST, "Unicorn cannot follow address line 20");
    }
}

static uint32_t take_in(uc_engine *engine, uint32_t port, int width, void *context) {
    struct run *run = context;
    uint32_t value = pc98_port_read(&run->ports, (uint16_t)port, (unsigned)width);
    (void)engine;
    check_ports(run);
    return value;
}

static void take_out(uc_engine *engine, uint32_t port, int width, uint32_t value, void *context) {
    struct run *run = context;
    (void)engine;
    pc98_port_write(&run->ports, (uint16_t)port, value, (unsigned)width);
    check_ports(run);
}

/* Takes INT n and the CPU's own exceptions. */
static void take_interrupt(uc_engine *engine, uint32_t number, void *context) {
    struct run *run = context;
    (void)engine;
    if (unicorn_is_protected(run)) {
        unicorn_end(
            run, PROCESSOR_LOST,
            "interrupt or exception %02" PRIX32
            "h in protected mode; a table of interrupts of the program's own is not emulated",
            number);
    } else {
        unicorn_pause(run, PAUSE_INTERRUPT, number & 0xFF);
    }
}

static bool refuse_opcode(uc_engine *engine, void *context) {
    struct run *run = context;
    (void)engine;
    if (unicorn_is_protected(run)) {
        unicorn_lack_opcode(run);
    } else {
        unicorn_pause(run, PAUSE_INTERRUPT, VECTOR_OPCODE);
    }
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
    unicorn_end(run, PROCESSOR_LOST, "%08" PRIX64 "h was %s; nothing is there", address, access);
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

/* Puts into memory what the machine's start leaves there, and the boot sector. */
static void fill_memory(struct run *run) {
    uint8_t *memory = run->memory;
    memory[EXTENDED_SIZE_BYTE] = EXTENDED_1_MIB;
    memory[MEMORY_SIZE_BYTE] = MEMORY_640_KIB;
    memory[DRIVE_BYTE] = PC98_DRIVE;
    memcpy(memory + 16 * BOOT_SEGMENT, run->job->disk->bytes, PC98_SECTOR_BYTES);
    pc98_text_clear(memory + TEXT_BASE);
    unicorn_fill_rom(run);
}

/* Opens Unicorn with the machine's memory; false if Unicorn fails. */
static bool open_engine(struct run *run) {
    return run->unicorn.open(UC_ARCH_X86, UC_MODE_16, &run->engine) == UC_ERR_OK &&
           map_regions(run, 0) && map_above(run) && add_hooks(run);
}

/* Sets the machine up as its ROM leaves it for the jump to the boot sector; false if Unicorn
 * fails. */
static bool prepare(struct run *run) {
    const uc_x86_mmr vectors = {.base = 0, .limit = 4 * VECTORS - 1};
    fill_memory(run);
    if (!open_engine(run)) {
        return false;
    }
    unicorn_set(run, UC_X86_REG_CS, BOOT_SEGMENT);
    unicorn_set(run, UC_X86_REG_SS, BOOT_STACK_SEGMENT);
    unicorn_set(run, UC_X86_REG_ESP, BOOT_STACK);
    return run->unicorn.reg_write(run->engine, UC_X86_REG_IDTR, &vectors) == UC_ERR_OK;
}

/* Reports the registers, where the CPU stands, and the text screen. In protected mode the base of
 * the code segment is taken as 0. */
static void describe_place(struct run *run) {
    struct processor_report *report = run->report;
    unicorn_get_all(run, report->registers);
    report->is_protected = unicorn_is_protected(run);
    report->address = report->registers[REGISTER_EIP];
    if (!report->is_protected) {
        report->address += 16 * (report->registers[REGISTER_CS] & 0xFFFF);
    }
    pc98_text_read(run->memory + TEXT_BASE, &report->text);
}

/* The place that abort() leads to while Unicorn runs; global, as a signal handler takes no argument
 * of ours. */
static sigjmp_buf way_out;

static void leave_unicorn(int signal_number) {
    (void)signal_number;
    siglongjmp(way_out, 1);
}

/* Runs the CPU from CS:IP on; false if Unicorn aborted. Version 2.0.1 aborts the program on opcodes
 * that its translator gets wrong, such as FF DF. */
static bool start(struct run *run, uc_err *error) {
    struct sigaction action, before;
    const uint32_t from = unicorn_address(run, UC_X86_REG_CS, unicorn_get(run, UC_X86_REG_EIP));
    memset(&action, 0, sizeof action);
    action.sa_handler = leave_unicorn;
    (void)sigemptyset(&action.sa_mask);
    (void)sigaction(SIGABRT, &action, &before);
    bool has_returned = sigsetjmp(way_out, 1) == 0;
    if (has_returned) {
        *error = run->unicorn.emu_start(run->engine, from, UINT32_MAX, 0, 0);
    }
    (void)sigaction(SIGABRT, &before, NULL);
    return has_returned;
}

/* Writes CR0 in real mode, by code in the ROM: Unicorn heeds no other way. */
static void set_control(struct run *run, uint32_t control) {
    const uint32_t eax = unicorn_get(run, UC_X86_REG_EAX), cs = unicorn_get(run, UC_X86_REG_CS);
    const uint32_t eip = unicorn_get(run, UC_X86_REG_EIP);
    const uint32_t flags = unicorn_get(run, UC_X86_REG_EFLAGS);
    uc_err error = UC_ERR_OK;
    unicorn_set(run, UC_X86_REG_EAX, control);
    unicorn_set(run, UC_X86_REG_CS, ROM_SEGMENT);
    unicorn_set(run, UC_X86_REG_EIP, ROM_CODE);
    unicorn_set(run, UC_X86_REG_EFLAGS, 0);
    run->is_in_rom = true;
    if (!start(run, &error) || error != UC_ERR_OK) {
        unicorn_end(run, PROCESSOR_LOST, "Unicorn cannot write CR0");
    }
    run->is_in_rom = false;
    unicorn_set(run, UC_X86_REG_EAX, eax);
    unicorn_set(run, UC_X86_REG_CS, cs);
    unicorn_set(run, UC_X86_REG_EIP, eip);
    unicorn_set(run, UC_X86_REG_EFLAGS, flags);
}

/* Goes on in a new engine, in real mode, after an exception. Unicorn never learns that the
 * exception was served, and makes a double fault of the next one. */
static void renew_engine(struct run *run) {
    uint32_t registers[PROCESSOR_REGISTERS];
    const uint32_t control = unicorn_get(run, UC_X86_REG_CR0);
    uc_x86_mmr vectors, segments;
    unicorn_get_all(run, registers);
    (void)run->unicorn.reg_read(run->engine, UC_X86_REG_IDTR, &vectors);
    (void)run->unicorn.reg_read(run->engine, UC_X86_REG_GDTR, &segments);
    (void)run->unicorn.close(run->engine);
    if (!open_engine(run)) {
        unicorn_end(run, PROCESSOR_LOST, "Unicorn could not be set up again");
        return;
    }
    unicorn_set_all(run, registers);
    (void)run->unicorn.reg_write(run->engine, UC_X86_REG_IDTR, &vectors);
    (void)run->unicorn.reg_write(run->engine, UC_X86_REG_GDTR, &segments);
    set_control(run, control);
}

/* Runs the CPU until the program ends, or until something is to be done before the CPU goes on.
 * Returns what is to be done, PAUSE_NONE if the run is over. */
static enum pause run_on(struct run *run) {
    uc_err error = UC_ERR_OK;
    run->pause = PAUSE_NONE;
    if (!start(run, &error)) {
        unicorn_end(run, PROCESSOR_LOST, "Unicorn cannot translate the code there");
    }
    if (run->is_over) {
        return PAUSE_NONE;
    }
    if (run->pause != PAUSE_NONE) {
        return run->pause;
    }
    unicorn_check_paging(run); /* the program may have changed its page tables since */
    if (error != UC_ERR_OK) {
        unicorn_end(run, PROCESSOR_LOST, "%s", run->unicorn.strerror(error));
    } else if ((unicorn_get(run, UC_X86_REG_EFLAGS) & FLAG_INTERRUPTS) != 0) {
        unicorn_end(run, PROCESSOR_LOST, "waits for an interrupt; there are none");
    } else {
        unicorn_end(run, PROCESSOR_HALTED, "halted");
    }
    return PAUSE_NONE;
}

/* Tells whether two exceptions of such vectors make a double fault. */
static bool counts_as_fault(uint32_t vector) {
    return vector == 0x00 || (vector >= 0x0A && vector <= 0x0D);
}

/* Runs the CPU to the run's end, and reports why the run ended. */
static void run_to_the_end(struct run *run) {
    while (!run->is_over) {
        switch (run_on(run)) {
        case PAUSE_INTERRUPT:
            if (counts_as_fault(run->vector)) {
                renew_engine(run);
            }
            unicorn_call_vector(run);
            break;
        case PAUSE_ROM:
            unicorn_run_rom(run);
            break;
        case PAUSE_387:
            set_control(run, unicorn_get(run, UC_X86_REG_CR0) | CONTROL_NO_387);
            break;
        case PAUSE_CODE:
            unicorn_make_undefined(run, run->vector);
            break;
        case PAUSE_NONE: /* the run is over */
            break;
        }
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
        run_to_the_end(run);
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
