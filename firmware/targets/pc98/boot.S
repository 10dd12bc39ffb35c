/* SPDX-License-Identifier: MIT */
/* The boot sector of the PC-98 floppy: reads the image behind it and starts it. */

/* The machine loads this sector to 1FC0:0000 and jumps there. IMAGE_SECTORS sectors of 1024 bytes
 * follow it on the disk; they go to 2000:0000, one at a time, so that no transfer crosses a border
 * of 64 KiB, where the DMA controller would wrap. The build passes IMAGE_SECTORS.
 *
 * What stands before has_386 runs on every CPU of a PC-98, from the 8086 on: the assembler refuses
 * other opcodes there. */

#define IMAGE_SEGMENT  0x2000
#define STACK_SEGMENT  0x1000
#define STACK_OFFSET   0xF000 /* linear 1F000h, below this sector */
#define TEXT_SEGMENT   0xA000
#define ATTRIBUTES     0x2000
#define WHITE          0xE1
#define COLUMNS        80
#define DRIVE          0x0584 /* the drive that was booted from: DA/UA */
#define READ_SEEK_MFM  0x56
#define RECALIBRATE    0x07
#define TRIES          5
#define SECTORS        8  /* on a track */
#define TRACKS         2  /* on a cylinder: one a side */
#define GRAPHICS       0xA2 /* commands of the controller of the PC's own graphics */
#define GRAPHICS_STOP  0x0C
#define COLOURS        0x6A
#define EIGHT_COLOURS  0x00

#undef i386 /* gcc's name for the CPU that it compiles for: here it is the assembler's */

    .code16
    .arch   i8086
    .text
    .globl  boot
boot:
    cli
    movw    $STACK_SEGMENT, %ax
    movw    %ax, %ss
    movw    $STACK_OFFSET, %sp
    cld
    pushw   %cs
    popw    %ds
/* Bits 15 to 12 of FLAGS: 1 whatever is written on an 8086, 80186 and V30, and 0 in real mode on an
 * 80286. On a 386, bits 14 to 12 are what is written. */
    movw    $0x0002, %ax
    pushw   %ax
    popfw
    pushfw
    popw    %ax
    andb    $0xF0, %ah
    cmpb    $0xF0, %ah
    je      no_386
    movw    $0x7002, %ax
    pushw   %ax
    popfw
    pushfw
    popw    %ax
    andb    $0x70, %ah
    jnz     has_386
no_386:
    movw    $needs_386, %si
    call    say
stop:
    cli
    hlt
    jmp     stop

/* Shows the text at si in the first line, and blanks the rest of the line. */
say:
    pushw   %es
    movw    $TEXT_SEGMENT, %ax
    movw    %ax, %es
    xorw    %di, %di
letter:
    movb    (%si), %al
    testb   %al, %al
    jz      blank
    incw    %si
    jmp     put
blank:
    movb    $' ', %al
put:
    movb    $0, %ah
    movw    $WHITE, %es:ATTRIBUTES(%di)
    stosw
    cmpw    $(2 * COLUMNS), %di
    jne     letter
    popw    %es
    ret

needs_386:
    .asciz  "superframe: this floppy needs a 386 or a later CPU"

    .arch   i386
    .globl  has_386
has_386:
    movw    $0x0002, %ax                /* no nested task, no privilege level */
    pushw   %ax
    popfw
    sti
    call    blank_graphics
    movw    $IMAGE_SEGMENT, %ax
    movw    %ax, %es
    movw    $1, %si                     /* the sector, counted from 0 over the whole disk */
next_sector:
    movb    $TRIES, %bl
try:
    pushw   %si
    pushw   %bx
    movw    %si, %ax
    xorw    %dx, %dx
    movw    $(SECTORS * TRACKS), %bx
    divw    %bx                         /* ax cylinder, dx sector on both sides of it */
    movb    %al, %cl
    movb    $3, %ch                     /* sectors of 128 << 3 bytes */
    movb    %dl, %dh
    shrb    $3, %dh                     /* the side */
    andb    $(SECTORS - 1), %dl
    incb    %dl                         /* counted from 1 */
    movb    $READ_SEEK_MFM, %ah
    movw    $1024, %bx
    xorw    %bp, %bp
    call    disk
    popw    %bx
    popw    %si
    jnc     sector_is_read
    pushw   %si
    call    report
    popw    %si
    decb    %bl
    jz      give_up
    movb    $RECALIBRATE, %ah           /* the heads may have lost their way */
    pushw   %si
    pushw   %bx
    call    disk
    popw    %bx
    popw    %si
    jmp     try
give_up:
    movw    $disk_error, %si
    call    say
    jmp     stop
sector_is_read:
    movw    %es, %ax
    addw    $(1024 / 16), %ax
    movw    %ax, %es
    incw    %si
    cmpw    $(IMAGE_SECTORS + 1), %si
    jne     next_sector
    ljmp    $IMAGE_SEGMENT, $0

/* Calls the disk BIOS for the drive that was booted from; ah says what for. */
disk:
    pushw   %ds
    pushw   %es
    pushw   %ax
    xorw    %ax, %ax
    movw    %ax, %ds
    popw    %ax
    movb    DRIVE, %al
    int     $0x1B
    popw    %es
    popw    %ds
    ret

/* Says that the sector si is read again, and puts its number and the status in ah into both
 * messages. */
report:
    movw    %si, %dx
    movw    $retry_sector, %di
    call    put_report
    movw    $error_sector, %di
    call    put_report
    movw    $retry, %si
    jmp     say

/* Puts dx, four digits, and ah, two digits behind the words, at di. */
put_report:
    movb    %dh, %al
    call    put_byte
    movb    %dl, %al
    call    put_byte
    addw    $(retry_status - retry_sector - 4), %di
    movb    %ah, %al
put_byte:
    pushw   %ax
    shrb    $4, %al
    call    put_digit
    popw    %ax
    pushw   %ax
    andb    $15, %al
    call    put_digit
    popw    %ax
    ret
put_digit:
    addb    $'0', %al
    cmpb    $'9', %al
    jbe     is_digit
    addb    $('A' - '9' - 1), %al
is_digit:
    movb    %al, (%di)
    incw    %di
    ret

/* Stops the display of the PC's own graphics, which would stand over the picture, and makes its
 * eight colours those of the machine's start. */
blank_graphics:
    movb    $GRAPHICS_STOP, %al
    outb    %al, $GRAPHICS
    movb    $EIGHT_COLOURS, %al
    outb    %al, $COLOURS
    movw    $palette, %si
    movw    $4, %cx
    movw    $0xA8, %dx
colour:
    lodsb
    outb    %al, %dx
    addw    $2, %dx
    loop    colour
    ret
palette:
    .byte   0x37, 0x15, 0x26, 0x04      /* colours 3 and 7, 1 and 5, 2 and 6, 0 and 4 */

retry:
    .ascii  "superframe: a sector is read again: "
retry_sector:
    .ascii  "0000, status "
retry_status:
    .asciz  "00"
disk_error:
    .ascii  "superframe: the disk cannot be read: sector "
error_sector:
    .ascii  "0000, status "
    .asciz  "00"

    .section .note.GNU-stack, "", @progbits
