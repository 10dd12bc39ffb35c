/* SPDX-License-Identifier: MIT */
/* The start of the real-mode 386 image: one segment of 64 KiB for everything, then C. */

#define SEGMENT      0x2000
#define TEXT_SEGMENT 0xA000
#define STACK_TOP    0xFFFC

    .section .start, "ax"
    .code16
    .globl  start
start:
    cli
    movw    $SEGMENT, %ax
    movw    %ax, %ds
    movw    %ax, %es
    movw    %ax, %ss
    movl    $STACK_TOP, %esp            /* the upper half counts: the compiler addresses by esp */
    movw    $TEXT_SEGMENT, %ax
    movw    %ax, %fs
    cld
    movl    $bss_start, %edi
    movl    $bss_end, %ecx
    subl    %edi, %ecx
    xorl    %eax, %eax
    rep stosb
    calll   pc98_main
stop:
    cli
    hlt
    jmp     stop

    .section .note.GNU-stack, "", @progbits
