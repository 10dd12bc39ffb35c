/* SPDX-License-Identifier: MIT */
/* RISC-V: the way from reset to the frame; a trap ends the run as failed. */
    .section .start, "ax"
    .globl reset
reset:
    la      sp, stack_top
    la      t0, trap
    .option arch, +zicsr
    csrw    mtvec, t0
    la      t0, bss_start
    la      t1, bss_end
1:  beq     t0, t1, 2f
    sw      x0, 0(t0)
    addi    t0, t0, 4
    j       1b
2:  call    sink_open
    call    frame_draw
    li      a0, 0
    call    sink_exit
    .balign 4
trap:
    li      a0, 1
    call    sink_exit
