/* SPDX-License-Identifier: MIT */
/* A run on Unicorn, as its source files share it. */
#ifndef SUPERFRAME_UNICORN_RUN_INTERNAL_H
#define SUPERFRAME_UNICORN_RUN_INTERNAL_H

#include "boot/cpu.h"
#include "boot/pc98_ports.h"
#include "boot/unicorn_library.h"

enum {
    LINE_20 = 0x100000,          /* what address line 20 counts for: 1 MiB */
    MACHINE_BYTES = 2 * LINE_20, /* with 1 MiB of extended memory */
    VECTORS = 256,
    VECTOR_OPCODE = 0x06,
    CONTROL_NO_387 = 0x00000004, /* a bit of CR0 */
    FLAG_INTERRUPTS = 0x0200,    /* a bit of EFLAGS */
    BLOCKS = 4096                /* entries of the table of code blocks; a power of two */
};

/* The ROM has a byte for each vector. Such a byte is never run: the run stops there, and does what
 * the ROM would do. Behind these bytes is code that writes CR0. */
enum { ROM_SEGMENT = 0xFD80, ROM_BASE = 16 * ROM_SEGMENT, ROM_CODE = VECTORS };

/* What is known of the block of code that begins at an address. */
struct block {
    uint32_t address, instructions; /* 0 instructions: nothing is known */
    bool has_387, writes_control;
};

/* Why Unicorn stopped while the run goes on. */
enum pause {
    PAUSE_NONE,
    PAUSE_INTERRUPT, /* `vector` is to be called */
    PAUSE_ROM,       /* the ROM's code for `vector` is to be run */
    PAUSE_387,       /* CR0 is to say that there is no 387 */
    PAUSE_CODE       /* the opcode at `vector` is one that no 386 has, and is to be made so */
};

struct run {
    const struct processor_job *job;
    struct processor_report *report;
    struct unicorn_library unicorn;
    uc_engine *engine;
    struct pc98_ports ports;
    uint64_t instructions_before_wait; /* when the keyboard was first asked in a row */
    bool is_over;                      /* report->end and reason say why */
    enum pause pause;
    uint32_t vector;          /* of the pause: a vector, or an address */
    bool is_in_rom;           /* the ROM's own code runs */
    bool control_is_written;  /* the block before may have written CR0 or CR3 */
    bool is_line_20_followed; /* the memory is mapped as address line 20 is on */
    struct block blocks[BLOCKS];
    struct pc98_disk_call call;
    uint8_t memory[MACHINE_BYTES];
};

#if defined(__GNUC__)
#define UNICORN_END_FORMAT __attribute__((format(printf, 3, 4)))
#else
#define UNICORN_END_FORMAT
#endif

/* Ends the run, with one English sentence. The first end counts. */
void unicorn_end(struct run *run, enum processor_end end, const char *format,
                 ...) UNICORN_END_FORMAT;

/* Ends the run at an instruction that the machine does not have. */
void unicorn_lack_387(struct run *run);
void unicorn_lack_opcode(struct run *run);

/* Lets Unicorn return, for something that is done before the CPU goes on. */
void unicorn_pause(struct run *run, enum pause pause, uint32_t vector);

/* Reads and writes a register by its number of Unicorn's. */
uint32_t unicorn_get(struct run *run, int number);
void unicorn_set(struct run *run, int number, uint32_t value);

/* Returns the linear address of an offset in a segment of real mode. */
uint32_t unicorn_address(struct run *run, int segment, uint32_t offset);

/* Reads and writes all registers, by enum processor_register. */
void unicorn_get_all(struct run *run, uint32_t registers[PROCESSOR_REGISTERS]);
void unicorn_set_all(struct run *run, const uint32_t registers[PROCESSOR_REGISTERS]);

/* Writes to the machine's memory while the CPU stands, and forgets what was known of code there.
 * False if no memory is there. */
bool unicorn_write(struct run *run, uint32_t address, const uint8_t *bytes, uint32_t count);

/* Tells whether the CPU is in protected mode. */
bool unicorn_is_protected(struct run *run);

/* Ends the run if the program has switched on paging that moves an address: Unicorn does not follow
 * it (unicorn_code.c). */
void unicorn_check_paging(struct run *run);

/* Finds what is known of a block, in which the CPU stands. Unicorn has translated the block by
 * then. NULL ends the run. */
const struct block *unicorn_find_block(struct run *run, uint32_t address, uint32_t bytes);

/* Makes the opcode at an address one that no CPU has. */
void unicorn_make_undefined(struct run *run, uint32_t address);

/* Puts the ROM and the table of vectors into memory (unicorn_rom.c). */
void unicorn_fill_rom(struct run *run);

/* Calls run->vector as the CPU does in real mode. */
void unicorn_call_vector(struct run *run);

/* Does what the ROM does for run->vector, where the CPU stands, and returns as IRET does. */
void unicorn_run_rom(struct run *run);

#endif
