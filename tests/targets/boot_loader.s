# SPDX-License-Identifier: MIT
# Machines that the boot sector of our floppies, firmware/targets/pc98/boot.S, meets; a table as in
# boot_sectors.s. Sector 3 of the disk is that boot sector, built for an image of one sector, and
# sector 2 is such an image: it shows IMAGE in the second line.
#
# Each of these loads the boot sector to 5000:0000 and runs it. What the machine is to be is done
# between the instructions, by the trap flag, or in a disk interrupt of its own.

    .include "tests/targets/boot_macros.s"
# load: the boot sector is read to 5000:0000.
    .macro load
    cli
    cld
    call_disk 0x5690, 0x0300, 0x0003, 1024, 0x5000
    .endm
# trapped: runs the boot sector with the trap flag.
    .macro trapped
    vector  1, trap
    pushw   $0x0102
    pushw   $0x5000
    pushw   $0
    iretw
    .endm
# Between two instructions: the flags that PUSHF pushed become those of the machine, by an AND and an
# OR. POPF keeps the trap flag. An OUT is shown in the third line: port and value.
trap:
    pushaw
    pushw   %ds
    pushw   %es
    movw    %sp, %bp
    movw    20(%bp), %si                /* ip and cs of the next instruction */
    movw    22(%bp), %ds
    cmpb    $1, %cs:was_pushf
    jne     1f
    movw    %cs:flags_and, %ax
    andw    %ax, 26(%bp)
    movw    %cs:flags_or, %ax
    orw     %ax, 26(%bp)
1:  movb    $0, %cs:was_pushf
    cmpb    $0x9C, (%si)
    jne     2f
    movb    $1, %cs:was_pushf
2:  cmpb    $0x9D, (%si)
    jne     3f
    orw     $0x0100, 26(%bp)
3:  movb    1(%si), %dl
    cmpb    $0xE6, (%si)
    je      4f
    movb    14(%bp), %dl                /* dx of the program */
    cmpb    $0xEE, (%si)
    jne     5f
4:  segment es, 0xA000
    movw    %cs:place, %di
    show_byte dl
    movb    18(%bp), %al                /* its ax */
    calll   show_al
    movw    %di, %cs:place
5:  popw    %es
    popw    %ds
    popaw
    iretw
was_pushf:
    .byte   0
flags_and:
    .word   0xFFFF
flags_or:
    .word   0
place:
    .word   2 * 160
# A disk interrupt that fails `failures` times, with status A0h, before the ROM answers. Each
# recalibration is a mark in the fourth line.
disk_interrupt:
    cmpb    $0x07, %ah
    jne     1f
    pushw   %ax
    pushw   %di
    pushw   %es
    segment es, 0xA000
    movw    %cs:mark, %di
    movw    $'*', %es:(%di)
    addw    $2, %cs:mark
    popw    %es
    popw    %di
    popw    %ax
1:  cmpb    $0x56, %ah
    jne     2f
    cmpw    $0, %cs:failures
    je      2f
    decw    %cs:failures
    movb    $0xA0, %ah
    pushw   %bp
    movw    %sp, %bp
    orw     $1, 6(%bp)
    popw    %bp
    iretw
2:  ljmpw   *%cs:rom
mark:
    .word   3 * 160
failures:
    .word   0
rom:
    .long   0
# failing: takes the disk interrupt, and runs the boot sector.
    .macro failing
    disk_vector disk_interrupt, rom
    ljmpw   $0x5000, $0
    .endm
sector:
#= cpu_8086 | 0 | screen: superframe: this floppy needs a 386 or a later CPU
    load
    movw    $0xF000, %cs:flags_or
    trapped
#= cpu_80286 | 0 | screen: superframe: this floppy needs a 386 or a later CPU
    load
    movw    $0x0FFF, %cs:flags_and
    trapped
#= cpu_386 | 0 | screen: IMAGE
    load
    movw    $0x7FFF, %cs:flags_and
    trapped
#= graphics_are_blanked | 0 | screen: A20C6A00A837AA15AC26AE04
    load
    trapped
#= disk_fails_twice | 0 | screen: superframe: a sector is read again: 0001, status A0
    load
    movw    $2, %cs:failures
    failing
#= heads_are_recalibrated | 0 | screen: ****
    load
    movw    $4, %cs:failures
    failing
#= image_runs_after_four_failures | 0 | screen: IMAGE
    load
    movw    $4, %cs:failures
    failing
#= disk_fails_always | 0 | screen: superframe: the disk cannot be read: sector 0001, status A0
    load
    movw    $5, %cs:failures
    failing
