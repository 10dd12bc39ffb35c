/* SPDX-License-Identifier: MIT */
/* A ROM for a PC without a BIOS that boots the beginning of a PC-98 floppy image, unchanged. */

/* The ROM is 128 KiB at E0000h: the image's first sectors (the build names the file, DISK), this
 * code, and the reset vector. It gives the boot sector what a PC-9801 would: itself at 1FC0:0000,
 * the drive at 0:0584h, and a read by INT 1Bh. */

#define ROM_SEGMENT  0xE000
#define CODE_SEGMENT 0xFF00 /* linear FF000h */
#define CODE_OFFSET  0x1F000
#define BOOT_SEGMENT 0x1FC0
#define DISK_VECTOR  (4 * 0x1B)
#define DRIVE        0x0584
#define DRIVE_2HD    0x90
#define SECTOR       1024
#define STACK        0x0600

    .code16
    .section .disk, "a"
    .incbin DISK, 0, CODE_OFFSET

    .section .text, "ax"
    .globl  start
start:
    cli
    cld
    movb    $0xFF, %al                  /* The boot sector allows interrupts, as its disk BIOS */
    outb    %al, $0x21                  /* needs them. Nothing here serves them: a tick of the */
    outb    %al, $0xA1                  /* timer before the sector's end led to address 0. */
    xorw    %ax, %ax
    movw    %ax, %ss
    movw    $STACK, %sp
    movw    %ax, %es
    movw    $(read_disk - start), %es:DISK_VECTOR
    movw    $CODE_SEGMENT, %es:(DISK_VECTOR + 2)
    movb    $DRIVE_2HD, %es:DRIVE
    movw    $BOOT_SEGMENT, %ax
    movw    %ax, %es
    movw    $ROM_SEGMENT, %ax
    movw    %ax, %ds
    xorw    %si, %si
    xorw    %di, %di
    movw    $(SECTOR / 2), %cx
    rep movsw
    ljmp    $BOOT_SEGMENT, $0

/* CL cylinder, DH head, DL sector from 1, BX bytes, ES:BP where to; no carry: it is read. */
read_disk:
    pushw   %ax
    pushw   %cx
    pushw   %si
    pushw   %di
    pushw   %ds
    movb    $0, %ch
    movw    %cx, %ax                    /* ((cylinder * 2 + head) * 8 + sector - 1) * 64 */
    shlw    $1, %ax
    addb    %dh, %al
    shlw    $3, %ax
    addb    %dl, %al
    decw    %ax
    shlw    $6, %ax
    addw    $ROM_SEGMENT, %ax
    movw    %ax, %ds
    xorw    %si, %si
    movw    %bp, %di
    movw    %bx, %cx
    rep movsb
    popw    %ds
    popw    %di
    popw    %si
    popw    %cx
    popw    %ax
    movb    $0, %ah
    pushw   %bp
    movw    %sp, %bp
    andw    $0xFFFE, 6(%bp)             /* the carry of the caller's flags */
    popw    %bp
    iret

    .section .reset, "ax"
    ljmp    $CODE_SEGMENT, $0

    .section .note.GNU-stack, "", @progbits
