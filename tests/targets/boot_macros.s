# SPDX-License-Identifier: MIT
# What every boot sector of boot_sectors.s and boot_loader.s begins with. es is the text screen where
# something is shown, and di the place there.

    .code16
# segment REGISTER, VALUE: by way of ax.
    .macro segment register, value
    movw    $\value, %ax
    movw    %ax, %\register
    .endm
# vector NUMBER, HANDLER: takes a vector.
    .macro vector number, handler
    pushw   %ds
    segment ds, 0
    movw    $\handler, \number * 4
    movw    %cs, \number * 4 + 2
    popw    %ds
    .endm
# disk_vector HANDLER, ROM: takes the vector of the disk, and keeps at ROM where that led.
    .macro disk_vector handler, rom
    segment fs, 0
    movl    %fs:0x1B * 4, %eax
    movl    %eax, %cs:\rom
    vector  0x1B, \handler
    .endm
# call_disk AX, CX, DX, BX, SEGMENT, OFFSET: INT 1Bh.
    .macro call_disk ax, cx=0, dx=0, bx=0, segment=0x3000, offset=0
    pushw   %es
    segment es, \segment
    movw    $\offset, %bp
    movw    $\ax, %ax
    movw    $\cx, %cx
    movw    $\dx, %dx
    movw    $\bx, %bx
    int     $0x1B
    popw    %es
    .endm
# show_byte REGISTER or SEGMENT:OFFSET: two digits in hexadecimal.
    .macro show_byte place
    movb    %\place, %al
    calll   show_al
    .endm
    jmp     sector
show_al:
    movb    %al, %bl
    shrb    $4, %al
    calll   show_digit
    movb    %bl, %al
    andb    $15, %al
show_digit:
    addb    $'0', %al
    cmpb    $'9', %al
    jbe     1f
    addb    $7, %al
1:  movb    $0, %ah
    stosw
    retl
