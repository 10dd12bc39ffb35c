# SPDX-License-Identifier: MIT
# Makes a PC-98 floppy of C sources; read by build.sh and build_probe.sh with here, folder and CC set.
#
# pc98_disk MODE OPTIONS LOAD_ADDRESS ROOM ARGUMENT...: the image, the boot sector, the disk, in
# $folder. MODE is flat or real; the arguments are options and sources for the compiler.
pc98_disk() {
    mode=$1 options=$2 load_address=$3 room=$4
    shift 4
    # -Wa,-march: the assembler refuses what a 386 without 387 does not have.
    # shellcheck disable=SC2086 # a list of words
    $CC $options -march=i386 -mno-80387 -Wa,-march=i386+no87 -fno-pic -fno-pie -no-pie \
        -static -fno-stack-protector -fno-asynchronous-unwind-tables -fcf-protection=none \
        -mpreferred-stack-boundary=2 -Wl,--build-id=none -I$here/pc98 -I$here/common \
        -Wl,--defsym=load_address="$load_address",--defsym=room="$room" \
        -Wl,-T,$here/pc98/link.ld -o "$folder/image.elf" "$@" $here/pc98/machine.c \
        $here/pc98/ports.c $here/common/memory.c "$here/pc98/start_$mode.S"
    objcopy -O binary "$folder/image.elf" "$folder/image.bin"
    bytes=$(wc -c < "$folder/image.bin")
    $CC -m16 -DIMAGE_SECTORS=$(((bytes + 1023) / 1024)) -nostdlib -static -no-pie \
        -Wl,--build-id=none -Wl,-T,$here/pc98/boot.ld -Wl,--oformat=binary \
        -o "$folder/boot.bin" $here/pc98/boot.S
    cat "$folder/boot.bin" "$folder/image.bin" > "$folder/disk.hdm"
    truncate -s 1261568 "$folder/disk.hdm"
}
