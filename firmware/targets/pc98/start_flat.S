/* SPDX-License-Identifier: MIT */
/* The start of the flat 386 image: from real mode at 2000:0000 to 32 bits, then to C. */

/* Everything lies below 1 MiB: address line 20 does not matter. Interrupts stay off from here on,
 * and there is no interrupt table: nothing below raises one. */

#define SEGMENT      0x2000
#define LOADED_AT    0x20000
#define CODE         0x08
#define DATA         0x10
#define TEXT         0x18
#define STACK_TOP    0x50000 /* 128 KiB for image and stack together, and then some */

    .section .start, "ax"
    .code16
    .globl  start
start:
    cli
    movw    $SEGMENT, %ax
    movw    %ax, %ds
    movl    $(table_register - LOADED_AT), %ebx
    lgdtl   (%bx)
    movl    %cr0, %eax
    orb     $1, %al
    movl    %eax, %cr0
    ljmpl   $CODE, $flat

    .code32
flat:
    movl    $DATA, %eax
    movl    %eax, %ds
    movl    %eax, %es
    movl    %eax, %ss
    movl    %eax, %gs
    movl    $TEXT, %eax
    movl    %eax, %fs
    movl    $STACK_TOP, %esp
    cld
    movl    $bss_start, %edi
    movl    $bss_end, %ecx
    subl    %edi, %ecx
    xorl    %eax, %eax
    rep stosb
    call    pc98_main
stop:
    cli
    hlt
    jmp     stop

    .balign 8
table:
    .quad   0
    .quad   0x00CF9A000000FFFF          /* code: base 0, 4 GiB */
    .quad   0x00CF92000000FFFF          /* data: the same */
    .quad   0x0040920A00003FFF          /* the text VRAM: base A0000h, 16 KiB */
table_register:
    .word   . - table - 1
    .long   table

    .section .note.GNU-stack, "", @progbits
