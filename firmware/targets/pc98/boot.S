/* SPDX-License-Identifier: MIT */
/* The boot sector of the PC-98 floppy: reads the image behind it and starts it. */

/* The machine loads this sector to 1FC0:0000 and jumps there. IMAGE_SECTORS sectors of 1024 bytes
 * follow it on the disk; they go to 2000:0000, one at a time, so that no transfer crosses a border
 * of 64 KiB, where the DMA controller would wrap. The build passes IMAGE_SECTORS. */

#define IMAGE_SEGMENT  0x2000
#define STACK_SEGMENT  0x1000
#define STACK_OFFSET   0xF000 /* linear 1F000h, below this sector */
#define TEXT_SEGMENT   0xA000
#define ATTRIBUTES     0x2000
#define WHITE          0xE1
#define DRIVE          0x0584 /* the drive that was booted from: DA/UA */
#define READ_SEEK_MFM  0x56
#define TRIES          5
#define SECTORS        8  /* on a track */
#define TRACKS         2  /* on a cylinder: one a side */

    .code16
    .text
    .globl  boot
boot:
    movw    $STACK_SEGMENT, %ax
    movw    %ax, %ss
    movw    $STACK_OFFSET, %sp
    sti
    cld
    pushw   %cs
    popw    %ds
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
    pushw   %ds
    xorw    %ax, %ax
    movw    %ax, %ds
    movb    DRIVE, %al
    popw    %ds
    movb    $READ_SEEK_MFM, %ah
    movw    $1024, %bx
    xorw    %bp, %bp
    pushw   %es
    int     $0x1B
    popw    %es
    popw    %bx
    popw    %si
    jnc     sector_is_read
    decb    %bl
    jnz     try
    movw    $disk_error, %si
    jmp     say
sector_is_read:
    movw    %es, %ax
    addw    $(1024 / 16), %ax
    movw    %ax, %es
    incw    %si
    cmpw    $(IMAGE_SECTORS + 1), %si
    jne     next_sector
    ljmp    $IMAGE_SEGMENT, $0

/* Shows the text at si in the first line and stops. */
say:
    movw    $TEXT_SEGMENT, %ax
    movw    %ax, %es
    xorw    %di, %di
letter:
    lodsb
    testb   %al, %al
    jz      stop
    movb    $0, %ah
    movw    %ax, %es:(%di)
    movw    $WHITE, %es:ATTRIBUTES(%di)
    addw    $2, %di
    jmp     letter
stop:
    cli
    hlt
    jmp     stop

disk_error:
    .asciz  "superframe: the disk cannot be read"

    .section .note.GNU-stack, "", @progbits
