# SPDX-License-Identifier: MIT
# A PC-9801 with a 386, which boots from a floppy. A target sets mode (flat or real), cpu,
# optimisation and load_address.
packages='m32|stdio.h|gcc-multilib'
fx=fx_32
sections='.text .rodata .data .bss'
entry=pc98_main
calls='pc98_main>firmware/image.c:image_draw
firmware/image.c:image_draw>firmware/targets/pc98/main.c:next_row
firmware/targets/pc98/main.c:next_row>firmware/image.c:image_row'
screen=yes

# pc98_disk ARGUMENT...: the image of more options and sources, the boot sector, the disk.
pc98_disk() {
    # -Wa,-march: the assembler refuses what a 386 without 387 does not have.
    $CC $cpu $optimisation -march=i386 -mno-80387 -Wa,-march=i386+no87 -fno-pic -fno-pie -no-pie \
        -static -fno-stack-protector -fno-asynchronous-unwind-tables -fcf-protection=none \
        -mpreferred-stack-boundary=2 -Wl,--build-id=none -I$targets/pc98 -I$targets/common \
        -Wl,--defsym=load_address="$load_address",--defsym=room="$memory" \
        -Wl,-T,$targets/pc98/link.ld -o "$folder/image.elf" "$@" $targets/pc98/machine.c \
        $targets/pc98/ports.c $targets/common/memory.c "$targets/pc98/start_$mode.S"
    objcopy -O binary "$folder/image.elf" "$folder/image.bin"
    bytes=$(wc -c < "$folder/image.bin")
    $CC -m16 -DIMAGE_SECTORS=$(((bytes + 1023) / 1024)) -nostdlib -static -no-pie \
        -Wl,--build-id=none -Wl,-T,$targets/pc98/boot.ld -Wl,--oformat=binary \
        -o "$folder/boot.bin" $targets/pc98/boot.S
    cat "$folder/boot.bin" "$folder/image.bin" > "$folder/disk.hdm"
    truncate -s 1261568 "$folder/disk.hdm"
}

# The renderer's disk.
pc98_floppy() {
    pc98_disk $flags $gnu "-DTARGET_TITLE=\"$name\"" $firmware $targets/pc98/main.c
}

build() {
    pc98_floppy
}

run() {
    $limit "$SUPERFRAME" boot disk.hdm --quiet --trace ports.trace --stats boot.json
    sed -n 's/.*"instructions": \([0-9]*\).*/\1/p' boot.json > instructions.txt
}
