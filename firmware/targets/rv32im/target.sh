# SPDX-License-Identifier: MIT
# A RISC-V of 32 bits with products and quotients, and nothing else.
title='RV32IM (QEMU virt)'
place=90
packages='tool|riscv64-unknown-elf-gcc|gcc-riscv64-unknown-elf
tool|qemu-system-riscv32|qemu-system-misc'
fx=fx_32
memory=65536
entry=frame_draw
sizes='fx/minimal/count fx/full'

build() {
    riscv64-unknown-elf-gcc -march=rv32im -mabi=ilp32 -mcmodel=medany -O2 $flags $gnu \
        -Wl,--defsym=ram_bytes="$memory" -Wl,-T,$targets/rv32im/link.ld -o "$folder/image.elf" \
        $firmware $semihosting $targets/rv32im/start.S $targets/rv32im/semihosting_call.c $root -lgcc
}

run() {
    $limit qemu-system-riscv32 -M virt -cpu rv32,c=off,a=off,f=off,d=off -bios none $semihosted \
        $plugin -kernel image.elf
}
