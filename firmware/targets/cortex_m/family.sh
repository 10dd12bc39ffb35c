# SPDX-License-Identifier: MIT
# A Cortex-M in QEMU. A target sets cpu, optimisation, machine, and coprocessor, the source that switches a
# floating-point unit on.
packages='tool|arm-none-eabi-gcc|gcc-arm-none-eabi
tool|qemu-system-arm|qemu-system-arm'
memory=65536
entry=reset
sizes='fx/minimal/count fx/full f32/minimal/count f32/full'
optimisation=-O2
coprocessor=coprocessor_none

build() {
    arm-none-eabi-gcc $cpu $optimisation -mthumb $flags $gnu -I$targets/cortex_m \
        -Wl,--defsym=ram_bytes="$memory" -Wl,-T,$targets/cortex_m/link.ld -o "$folder/image.elf" \
        $firmware $semihosting $targets/cortex_m/start.c $targets/cortex_m/semihosting_call.c \
        "$targets/cortex_m/$coprocessor.c" $root -lgcc
}

run() {
    $limit qemu-system-arm -M "$machine" $semihosted $plugin -kernel image.elf
}
