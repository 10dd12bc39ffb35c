# SPDX-License-Identifier: MIT
# Boot sectors, and what a PC-9801 with a 386 makes of them; tests/targets/boot_test.sh reads this.
#
# A line "#= NAME | STATUS | TEXT | OPTIONS" begins a sector: what `superframe boot` ends with, and
# what it says. A TEXT that begins with "screen:" is the whole first line of the screen. The code
# before the first such line belongs to every sector. Sector 1,231 of the disk begins with "LZ",
# cylinder 1 with "A1" on head 0 and "B1" on head 1.

    .include "tests/targets/boot_macros.s"
# begin: es is the text screen, di the place there, ds the sector's own segment.
    .macro begin
    cli
    cld
    segment es, 0xA000
    pushw   %cs
    popw    %ds
    xorw    %di, %di
    .endm
# show LETTER: one letter on the screen.
    .macro show letter
    movw    $\letter, %es:(%di)
    addw    $2, %di
    .endm
    .macro stop
    cli
    hlt
    .endm
# disk AX, CX, DX, BX, SEGMENT, OFFSET: INT 1Bh; shows AH in hexadecimal, and + with the carry flag.
    .macro disk arguments:vararg
    call_disk \arguments
    calll   show_status
    .endm
# key: waits until one is there.
    .macro key
1:  inb     $0x43, %al
    testb   $2, %al
    jz      1b
    .endm
# protect: 32 bits, flat.
    .macro protect
    pushw   %cs
    popw    %ds
    lgdtl   table_register
    movl    %cr0, %eax
    orb     $1, %al
    movl    %eax, %cr0
    ljmpl   $8, $(1f + 0x1FC00)
    .code32
1:  movw    $16, %ax
    movw    %ax, %ds
    movw    %ax, %es
    movw    %ax, %ss
    movl    $0x9F000, %esp
    .endm
# pages: a page table at 60000h that leaves 4 MiB where they are, a directory at 61000h.
    .macro pages
    movl    $0x60000, %edi
    movl    $1024, %ecx
    movl    $3, %eax
1:  movl    %eax, (%edi)
    addl    $0x1000, %eax
    addl    $4, %edi
    loop    1b
    movl    $0x61000, %edi
    movl    $1024, %ecx
    xorl    %eax, %eax
    rep stosl
    movl    $0x60003, 0x61000
    .endm
# page_on: the CPU goes by that table.
    .macro page_on
    movl    $0x61000, %eax
    movl    %eax, %cr3
    movl    %cr0, %eax
    orl     $0x80000000, %eax
    movl    %eax, %cr0
    jmp     1f
1:
    .endm
show_status:
    pushfl
    show_byte ah
    popfl
    jnc     1f
    show    '+'
1:  retl
    .balign 8
table:
    .quad   0, 0x00CF9A000000FFFF, 0x00CF92000000FFFF
table_register:
    .word   23
    .long   table + 0x1FC00
# Show the first two letters of what was read to 3000:0000.
show_read:
    segment fs, 0x3000
    movb    $0, %ah
    movb    %fs:0, %al
    stosw
    movb    %fs:1, %al
    stosw
    retl
sector:
#= last_sector | 0 | screen: 00LZ
    begin
    disk    0x5690, 0x034C, 0x0108, 1024
    calll   show_read
    stop
#= first_of_cylinder_1 | 0 | screen: 00A100B1
    begin
    disk    0x5690, 0x0301, 0x0001, 1024
    calll   show_read
    disk    0x5690, 0x0301, 0x0101, 2
    calll   show_read
    stop
#= a_track_and_both_sides | 0 | screen: 0000
    begin
    disk    0x5690, 0x0301, 0x0001, 8192
    disk    0xD690, 0x0302, 0x0001, 16384
    stop
#= past_the_track | 0 | screen: 30+30+30+
    begin
    disk    0x5690, 0x0302, 0x0001, 16384
    disk    0x5690, 0x0302, 0x0008, 1025
    disk    0xD690, 0x0302, 0x0101, 16384
    stop
#= sector_length | 0 | screen: C0+C0+C0+
    begin
    disk    0x5690, 0x0200, 0x0001, 1024
    disk    0x5690, 0x0000, 0x0001, 128
    disk    0x5690, 0x0400, 0x0001, 1024
    stop
#= density | 0 | screen: E0+E0+
    begin
    disk    0x1690, 0x0300, 0x0001, 1024
    disk    0x1A90, 0x0000, 0x0000, 0
    stop
#= border_of_64_kib | 0 | screen: 20+20+0000
    begin
    disk    0x5690, 0x0301, 0x0001, 4096, 0x3F80, 0
    disk    0x5690, 0x0301, 0x0001, 2049, 0x3000, 0xF800
    disk    0x5690, 0x0301, 0x0001, 2048, 0x3F80, 0
    disk    0x5690, 0x0301, 0x0001, 2048, 0x4000, 0
    stop
#= no_such_sector | 0 | screen: C0+C0+C0+E0+
    begin
    disk    0x5690, 0x0301, 0x0009, 1024
    disk    0x5690, 0x0301, 0x0000, 1024
    disk    0x5690, 0x0301, 0x0201, 1024
    disk    0x5690, 0x034D, 0x0001, 1024
    stop
#= heads_stay_without_seek | 0 | screen: C0+0000C0+
    begin
    disk    0x4690, 0x0301, 0x0001, 1024
    disk    0x1090, 0x0001, 0x0000, 0
    disk    0x4690, 0x0301, 0x0001, 1024
    disk    0x4690, 0x0300, 0x0001, 1024
    stop
#= recalibrate_goes_to_cylinder_0 | 0 | screen: 00C0+0000
    begin
    disk    0x1090, 0x0005, 0x0000, 0
    disk    0x4690, 0x0300, 0x0001, 1024
    disk    0x0790
    disk    0x4690, 0x0300, 0x0001, 1024
    stop
#= sense_and_initialise | 0 | screen: 010900
    begin
    disk    0x0490
    disk    0x8490
    disk    0x0390
    stop
#= read_id | 0 | screen: 0005010103
    begin
    disk    0x5A90, 0x0005, 0x0100, 0
    show_byte cl
    show_byte dh
    show_byte dl
    show_byte ch
    stop
#= written_data_is_read_back | 0 | screen: 0000LZ00
    begin
    disk    0x5690, 0x034C, 0x0108, 1024
    disk    0x5590, 0x0302, 0x0001, 1024
    segment fs, 0x3000
    movw    $0, %fs:0
    call_disk 0x5690, 0x0302, 0x0001, 1024
    calll   show_read
    disk    0x5190, 0x0302, 0x0001, 8192
    stop
#= code_loaded_over_code_that_ran | 0 | screen: O00N
    begin
    segment fs, 0x3000
    movw    $2f, %bx
    movb    $0xAB, %fs:(%bx)
    movb    $0xCB, %fs:1(%bx)
    movw    $'O', %ax
    lcallw  $0x3000, $2f
    disk    0x5690, 0x0300, 0x0001, 1024
    movw    $'O', %ax
    lcallw  $0x3000, $2f
    stop
2:  movb    $'N', %al
    stosw
    lretw
#= write_protected | 0 | screen: 70+11 | protected
    begin
    disk    0x5590, 0x0302, 0x0001, 1024
    disk    0x0490
    stop
#= other_drives | 0 | screen: 60+40+40+00
    begin
    disk    0x5691, 0x0301, 0x0001, 1024
    disk    0x5670, 0x0301, 0x0001, 1024
    disk    0x5680, 0x0301, 0x0001, 1024
    disk    0x0391
    stop
#= format_is_refused | 1 | INT 1Bh with AH = 5Dh is not emulated; at 0001FC
    begin
    disk    0x5D90, 0x0301, 0x0001, 32
    stop
#= own_divide_error | 0 | screen: D
    begin
    vector  0, 2f
    xorw    %cx, %cx
    divw    %cx
    stop
2:  show    'D'
    stop
#= own_divide_error_again_and_again | 0 | screen: DDDD
    begin
    vector  0, 2f
    movw    $4, %cx
1:  xorw    %bx, %bx
    divw    %bx
    loop    1b
    stop
2:  show    'D'
    movw    %sp, %bp
    addw    $2, (%bp)                   /* behind the division */
    iretw
#= own_divide_error_with_line_20_on | 0 | screen: D
    begin
    outb    %al, $0xF2
    vector  0, 2f
    xorw    %cx, %cx
    divw    %cx
    stop
2:  show    'D'
    stop
#= vectors_that_repeat | 1 | no end within 200000 instructions | --instructions 200000
    begin
    vector  6, 2f
2:  cpuid
#= own_interrupt_returns | 0 | screen: IR
    begin
    vector  0x60, 2f
    int     $0x60
    show    'R'
    stop
2:  show    'I'
    iretw
#= own_opcode_exception | 0 | screen: BU
    begin
    vector  6, 2f
    show    'B'
    bswapl  %eax
    show    'X'
    stop
2:  show    'U'
    stop
#= own_breakpoint_and_overflow | 0 | screen: 3O
    begin
    vector  3, 2f
    vector  4, 3f
    int3
    movb    $0x7F, %al
    incb    %al
    into
    stop
2:  show    '3'
    iretw
3:  show    'O'
    iretw
#= own_single_step | 0 | screen: 111
    begin
    vector  1, 2f
    pushfw
    popw    %ax
    orw     $0x100, %ax
    pushw   %ax
    popfw
    nop
    nop
    jmp     3f
3:  cli
    hlt
2:  show    '1'
    cmpw    $6, %di
    jne     4f
    movw    %sp, %bp
    andw    $0xFEFF, 4(%bp)
4:  iretw
#= own_disk_interrupt_goes_on_in_the_rom | 0 | screen: N00
    begin
    disk_vector 2f, old
    disk    0x5690, 0x0301, 0x0001, 1024
    stop
2:  pushw   %es
    pushw   %ax
    segment es, 0xA000
    show    'N'
    popw    %ax
    popw    %es
    ljmpw   *%cs:old
old:
    .long   0
#= interrupts_are_off_in_a_handler | 0 | screen: 00
    begin
    vector  0x60, 2f
    sti
    int     $0x60
    stop
2:  pushfw
    popw    %ax
    andb    $2, %ah
    calll   show_status
    iretw
#= moved_table_of_vectors | 0 | screen: M
    begin
    segment ds, 0x4000
    movw    $2f, 0x60 * 4
    movw    %cs, 0x60 * 4 + 2
    lidtl   %cs:moved
    int     $0x60
    stop
2:  show    'M'
    stop
moved:
    .word   0x3FF
    .long   0x40000
#= table_of_vectors_without_vectors | 1 | the CPU resets
    begin
    lidtl   nothing
    int     $0x60
    stop
nothing:
    .word   0
    .long   0
#= dos | 1 | interrupt or exception 21h; of the ROM there is INT 1Bh only; at 0001FC
    begin
    int     $0x21
#= divide_error_of_the_rom | 1 | interrupt or exception 00h; of the ROM there is INT 1Bh only; at 0001FC
    begin
    xorw    %cx, %cx
    divw    %cx
#= no_387_is_found | 0 | screen: AFFFF
    begin
    fninit
    movw    $0x5A5A, word
    fnstsw  word
    cmpw    $0xFFFF, word
    jne     1f
    show    'A'
1:  fninit
    fnstsw  %ax
    pushw   %ax
    calll   show_status
    popw    %ax
    show_byte al
    stop
word:
    .word   0
#= no_387_is_found_by_any_address | 0 | screen: FFFFFFFF
    begin
    segment ss, 0x3000
    segment fs, 0x3000
    segment es, 0x2000
    movw    $0x1000, %sp
    movw    $0x100, %bp
    movw    $0x200, %bx
    movw    $0x30, %si
    movw    $0x40, %di
    fnstcw  (%bp, %si)                  /* 3000:0130 */
    fnstsw  0x7F(%bp)                   /* 3000:017F */
    fnstcw  %es:-2(%bx, %di)            /* 2000:023E */
    fnstsw  %es:0x1234(%di)             /* 2000:1274 */
    segment gs, 0x2000
    segment es, 0xA000
    xorw    %di, %di
    show_byte fs:0x130
    show_byte fs:0x17F
    show_byte gs:0x23E
    show_byte gs:0x1275
    stop
#= no_387_whatever_cr0_says | 0 | screen: FF
    begin
    movl    %cr0, %eax
    andb    $0xFB, %al
    movl    %eax, %cr0
    movw    $0, %ax
    fninit
    fnstsw  %ax
    calll   show_status
    stop
#= calculation_of_a_387 | 1 | an instruction of a 387, which this machine lacks; at 0001FC
    begin
    show    'F'
    fld1
    stop
#= a_387_in_protected_mode | 1 | an instruction of a 387, which this machine lacks; at 0001FC
    begin
    protect
    fninit
    hlt
#= own_387_exception | 0 | screen: 7
    begin
    vector  7, 2f
    fld1
    stop
2:  show    '7'
    stop
#= opcode_of_a_pentium | 1 | an opcode that the CPU does not have; at 0001FC
    begin
    cpuid
    stop
#= opcode_of_a_486_in_protected_mode | 1 | is no opcode of a 386
    begin
    protect
    bswapl  %eax
    hlt
#= opcode_of_a_pentium_pro | 1 | an opcode that the CPU does not have; at 0001FC
    begin
    cmovnel %eax, %ebx
    stop
#= line_20_wraps | 0 | screen: WFFFEN
    begin
    segment fs, 0xFFFF
    segment gs, 0
    movb    $0, %gs:0x700
    movb    $'W', %fs:0x710
    movb    %gs:0x700, %al
    stosb
    incw    %di
    inb     $0xF2, %al
    show_byte al
    outb    %al, $0xF2
    inb     $0xF2, %al
    show_byte al
    movb    $3, %al
    outb    %al, $0xF6
    movb    $'N', %fs:0x710
    movb    %gs:0x700, %al
    stosb
    stop
#= extended_memory | 0 | screen: EB
    begin
    outb    %al, $0xF2
    segment fs, 0xFFFF
    segment gs, 0
    movb    $'B', %gs:0x700
    movb    $'E', %fs:0x710
    movb    %fs:0x710, %al
    stosb
    incw    %di
    movb    %gs:0x700, %al
    stosb
    stop
#= extended_memory_outlives_the_line | 0 | screen: E
    begin
    outb    %al, $0xF2
    segment fs, 0xFFFF
    movb    $'E', %fs:0x710
    movb    $3, %al
    outb    %al, $0xF6
    movb    $'B', %fs:0x710
    movb    $2, %al
    outb    %al, $0xF6
    movb    %fs:0x710, %al
    stosb
    stop
#= code_of_a_486_in_extended_memory | 1 | an opcode that the CPU does not have; at 001000
    begin
    outb    %al, $0xF2
    segment es, 0xFFFF
    movl    $0xCBC80F66, %es:0x10       /* bswap eax, retf */
    lcallw  $0xFFFF, $0x10
    stop
#= no_memory_above_2_mib | 1 | 00200000h was written to; nothing is there
    begin
    outb    %al, $0xF2
    protect
    movl    $1, 0x1FFFFC
    movl    $1, 0x200000
    hlt
#= reset | 1 | the program has reset the machine (OUT F0h)
    begin
    outb    %al, $0xF0
    stop
#= paging_that_moves_nothing | 0 | screen: P
    begin
    protect
    pages
    page_on
    movw    $'P', 0xA0000
    hlt
#= paging_of_a_low_page | 1 | paging that maps 00050000h to 000A0000h is not emulated
    begin
    protect
    pages
    movl    $0xA0003, 0x60000 + 4 * 0x50
    page_on
    movw    $'P', 0x50000
    hlt
#= paging_of_a_high_page | 1 | paging that maps 00100000h to 000A0000h is not emulated
    begin
    protect
    pages
    movl    $0xA0003, 0x60000 + 4 * 0x100
    page_on
    movw    $'P', 0x100000
    hlt
#= paging_that_is_off_at_the_end | 1 | paging that maps 00050000h to 000A0000h is not emulated
    begin
    protect
    pages
    movl    $0xA0003, 0x60000 + 4 * 0x50
    page_on
    movw    $'P', 0x50000
    movl    %cr0, %eax
    andl    $0x7FFFFFFF, %eax
    movl    %eax, %cr0
    hlt
#= page_that_is_not_there | 1 | paging without a page at 00005000h is not emulated
    begin
    protect
    pages
    movl    $0, 0x60000 + 4 * 5
    page_on
    hlt
#= page_that_moves_later | 1 | paging that maps 00070000h to 00000000h is not emulated
    begin
    protect
    pages
    page_on
    movl    $3, 0x60000 + 4 * 0x70
    hlt
#= interrupt_in_protected_mode | 1 | interrupt or exception 30h in protected mode
    begin
    protect
    int     $0x30
    hlt
#= secret_text | 0 | screen: A C
    begin
    show    'A'
    show    'B'
    show    'C'
    movb    $0xE0, %es:0x2002
    stop
#= colours_stay_letters | 0 | screen: RGB?
    begin
    show    'R'
    show    'G'
    show    'B'
    show    0x4114
    movb    $0x41, %es:0x2000
    movb    $0x85, %es:0x2002
    movb    $0x2B, %es:0x2004
    stop
#= wait_for_a_key | 0 | waits for a key
    begin
    show    'K'
    key
    stop
#= wait_for_a_key_that_comes | 0 | screen: KE | --escape 1000
    begin
    show    'K'
2:  key
    inb     $0x41, %al
    testb   %al, %al
    jnz     2b
    show    'E'
    stop
#= wait_for_an_interrupt | 1 | waits for an interrupt
    begin
    sti
    hlt
#= endless | 1 | no end within 20000000 instructions; at 0001FC
    begin
1:  jmp     1b
