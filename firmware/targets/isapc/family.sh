# SPDX-License-Identifier: MIT
# The floppy of the PC-9801's target that was read before, in a ROM for a PC without a BIOS: QEMU's
# isapc with a 486.
packages="$packages
tool|qemu-system-i386|qemu-system-x86"
sizes=''

build() {
    pc98_floppy
    $CC -m16 "-DDISK=\"$folder/disk.hdm\"" -nostdlib -static -no-pie -Wl,--build-id=none \
        "-Wl,-T,$targets/isapc/link.ld" -Wl,--oformat=binary -o "$folder/rom.bin" "$targets/isapc/rom.S"
}

run() {
    sh "$targets/isapc/run.sh"
}
