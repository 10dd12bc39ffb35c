/* SPDX-License-Identifier: MIT */
/* A 386 in a PC-9801 that has booted from a floppy. It runs the firmware's machine code, with its
 * ports on a bus. */
#ifndef SUPERFRAME_PROCESSOR_H
#define SUPERFRAME_PROCESSOR_H

#include "boot/pc98_disk.h"
#include "boot/pc98_text.h"
#include "bus.h"

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>

/* The machine has 640 KiB of memory, 1 MiB of extended memory, and text VRAM at A0000h. Its
 * graphics planes at A8000h, B0000h, B8000h and E0000h are plain memory. Address bit 20 is off
 * until the program switches it on. The machine has a keyboard, and a floppy by INT 1Bh. A
 * program's own real-mode vectors are called; nothing else of the ROM is there. There is no 387,
 * and no device raises an interrupt. The run ends at an address where nothing is, and at an opcode
 * of a later CPU. Nor is there paging that moves an address, or an interrupt in protected mode. */

enum processor_end {
    PROCESSOR_HALTED,     /* HLT with interrupts off: the program has stopped by itself */
    PROCESSOR_WAITING,    /* the program waits for a key that nobody will press */
    PROCESSOR_LOST,       /* a bad opcode, an exception, an address where nothing is */
    PROCESSOR_RESET,      /* the program has reset the machine */
    PROCESSOR_LIMIT,      /* too many instructions */
    PROCESSOR_STOPPED,    /* the caller's flag was set */
    PROCESSOR_BUS_FAILED, /* the bus says why */
    PROCESSOR_UNAVAILABLE /* not built in, or not to be set up; `reason` says what is missing */
};

struct processor_job {
    struct pc98_disk *disk; /* the program may write to it */
    struct bus *bus;
    uint64_t instructions_most;
    uint64_t escape_after;             /* Esc is pressed when the keyboard has been asked so often
                                          (0: never) */
    const volatile sig_atomic_t *stop; /* set from outside to end the run; may be NULL */
};

enum { PROCESSOR_REGISTERS = 16 };

/* How a run ended, and where. */
struct processor_report {
    enum processor_end end;
    uint64_t instructions; /* that the CPU has run; PROCESSOR_WAITING: up to the wait */
    char reason[160];      /* one English sentence, no full stop */
    bool is_protected;     /* in protected mode; else the address is 16 * cs + ip */
    uint32_t address;      /* linear, of the instruction where it ended */
    uint32_t registers[PROCESSOR_REGISTERS]; /* by enum processor_register */
    struct pc98_text text;                   /* what stands on the text screen */
};

/* The order of struct processor_report.registers: eax first. */
enum processor_register {
    REGISTER_EAX,
    REGISTER_EBX,
    REGISTER_ECX,
    REGISTER_EDX,
    REGISTER_ESI,
    REGISTER_EDI,
    REGISTER_EBP,
    REGISTER_ESP,
    REGISTER_EIP,
    REGISTER_EFLAGS,
    REGISTER_CS,
    REGISTER_DS,
    REGISTER_ES,
    REGISTER_FS,
    REGISTER_GS,
    REGISTER_SS
};

/* What runs the machine. */
struct processor {
    /* As processor_run(); *report is all zero before, but for PROCESSOR_UNAVAILABLE. */
    void (*run)(const struct processor_job *job, struct processor_report *report);
};

/* The processors of this build, in a list that make writes; NULL ends the list. */
extern const struct processor *const processors_built[];

/* Boots the disk and runs it to its end. Runs at most instructions_most instructions, and what the
 * last block of code has beyond that number. */
void processor_run(const struct processor_job *job, struct processor_report *report);

#endif
