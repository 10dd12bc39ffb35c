#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the firmware for a target: build.sh TARGET ARITHMETIC SCENE SIZE DEPTH FEATURES FOLDER
#
# TARGET      a name of the table at the end
# ARITHMETIC  fx or f32
# SCENE       what `superframe compile` takes; SIZE and DEPTH go with it, - is the scene's own
# FEATURES    minimal: what the scene requires; full: everything
# FOLDER      where image.elf (or .wasm, .hdm) is made
# COMPILE     more options of `superframe compile`: --tail estimate
# FIT         any: an image whose stack does not fit the machine's memory is built all the same
# SUPERFRAME  the program (build/superframe); CC the native compiler (gcc)
# TARGET_RAM  bytes of memory of a cortex-m0 (16384; up to 65536, for an image that only QEMU will run)
#
# Exit status: 0 built, 1 not.
set -eu

target=$1 arithmetic=$2 scene=$3 size=$4 depth=$5 features=$6 folder=$7
SUPERFRAME=${SUPERFRAME:-build/superframe}
CC=${CC:-gcc}
here=firmware/targets
name=$(basename "$scene" .scene)
symbol=scene_$(printf %s "$name" | sed 's/[^0-9A-Za-z]/_/g')

rm -rf "$folder"
mkdir -p "$folder/tables"
options=${COMPILE:-}
[ "$size" = - ] || options="$options --size $size"
[ "$depth" = - ] || options="$options --depth $depth"
# shellcheck disable=SC2086 # a list of words
"$SUPERFRAME" compile "$scene" $options -o "$folder/scene.c"
if [ "$features" = minimal ]; then
    # shellcheck disable=SC2086 # a list of words
    "$SUPERFRAME" compile "$scene" $options --minimal -o "$folder/tables/feature_set.h"
else
    cp firmware/features/full/feature_set.h "$folder/tables/feature_set.h"
fi

# A multiple exposure takes a camera whose shutter is opened eight times.
case $target in
386-* | qemu-486* | wasm)
    if grep -q SHOW_EXPOSURES "$folder/scene.c"; then
        echo "build.sh: $target shows one picture, and \"$scene\" is a multiple exposure;" \
            'allowed are colour = "full", "bits:1" to "bits:8" and "dither"' >&2
        exit 1
    fi
    ;;
esac

# fx has a folder for each kind of CPU; the bits are the same.
real=$arithmetic
case $arithmetic-$target in
fx-cortex-m0) real=fx_16 ;;
fx-cortex-m3) real=fx_m3 ;;
fx-cortex-m4f | fx-rv32im | fx-gcc-m32 | fx-powerpc | fx-386-* | fx-qemu-486*) real=fx_32 ;;
esac

# What every compiler gets. Copies are loops: see common/memory.c.
flags="-std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding
 -ffp-contract=off -ffunction-sections -fdata-sections
 -DTARGET_IMAGE=image_$arithmetic -DTARGET_SCENE=$symbol
 -Ifirmware/real/$real -I$folder/tables -Ihal -Ifirmware -I$here/common"
firmware="firmware/*.c $folder/scene.c"
# Without -fno-tree-pre gcc follows a number that was saturated as one of 64 bits, and multiplies it so.
gnu='-fno-tree-pre -fno-tree-loop-distribute-patterns -fstack-usage -fcallgraph-info=su -nostdlib -Wl,--gc-sections'
records="$here/common/frame.c $here/common/port_records.c"
semihosting="$records $here/common/memory.c $here/common/semihosting_sink.c"
# A square root for those without one.
root=
[ "$arithmetic" = fx ] || root=$here/common/square_root.c

# cortex_m OPTIONS RAM COPROCESSOR [MORE]
# shellcheck disable=SC2086 # lists of words, here and below
cortex_m() {
    arm-none-eabi-gcc $1 -mthumb $flags $gnu -I$here/cortex_m -Wl,--defsym=ram_bytes="$2" \
        -Wl,-T,$here/cortex_m/link.ld -o "$folder/image.elf" $firmware $semihosting \
        $here/cortex_m/start.c $here/cortex_m/semihosting_call.c "$here/cortex_m/$3.c" ${4:-} -lgcc
}

riscv() {
    riscv64-unknown-elf-gcc -march=rv32im -mabi=ilp32 -mcmodel=medany -O2 $flags $gnu \
        -Wl,--defsym=ram_bytes=65536 -Wl,-T,$here/riscv/link.ld -o "$folder/image.elf" \
        $firmware $semihosting $here/riscv/start.S $here/riscv/semihosting_call.c $root -lgcc
}

# posix COMPILER OPTIONS: a program on the build machine, or on another Linux by qemu-user.
posix() {
    $1 $2 -O2 $flags -c -o "$folder/frame.o" $here/common/frame.c
    $1 $2 -O2 $flags -c -o "$folder/port_records.o" $here/common/port_records.c
    objects="$folder/frame.o $folder/port_records.o"
    for source in $firmware; do
        object=$folder/$(basename "$source" .c)_.o
        $1 $2 -O2 $flags -c -o "$object" "$source"
        objects="$objects $object"
    done
    $1 $2 -O2 -std=c99 -Wall -Wextra -Werror -I$here/common ${3:-} -o "$folder/image.elf" \
        tests/targets/posix_main.c $objects -lm
}

. $here/pc98/disk.sh

# pc98 MODE OPTIONS LOAD_ADDRESS ROOM: the renderer's disk.
# shellcheck disable=SC2086 # lists of words
pc98() {
    pc98_disk "$1" "$2" "$3" "$4" $flags $gnu "-DTARGET_TITLE=\"$name\"" $firmware \
        $here/pc98/main.c
}

pc98_flat() {
    pc98 flat '-m32 -O2' 0x20000 0x2F000
}

pc98_real() {
    pc98 real '-m16 -Os' 0 0xFFFC
}

# isapc: the PC-98 disk just made, in a ROM for a PC without a BIOS.
isapc() {
    $CC -m16 "-DDISK=\"$folder/disk.hdm\"" -nostdlib -static -no-pie -Wl,--build-id=none \
        -Wl,-T,$here/isapc/link.ld -Wl,--oformat=binary -o "$folder/rom.bin" $here/isapc/rom.S
}

wasm() {
    clang --target=wasm32 -Oz -Iemulator/board $flags -I$here/wasm/include -nostdlib -Wl,--no-entry \
        -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=65536 -fno-builtin -o "$folder/image.wasm" $firmware \
        $here/wasm/module.c $here/common/memory.c emulator/board/board.c emulator/board/board_pixel.c emulator/board/board_setup.c \
        emulator/board/board_report.c
}

case $target in
cortex-m0) cortex_m '-mcpu=cortex-m0 -Os' "${TARGET_RAM:-16384}" coprocessor_none $root ;;
cortex-m3) cortex_m '-mcpu=cortex-m3 -O2' 65536 coprocessor_none $root ;;
cortex-m4f) cortex_m '-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16 -O2' 65536 \
    coprocessor_fpu "${root:+$here/cortex_m/square_root_fpu.c}" ;;
rv32im) riscv ;;
native) posix "$CC" '' ;;
gcc) posix gcc '' ;;
clang) posix clang '' ;;
gcc-m32) posix gcc -m32 ;;
unsigned-char) posix gcc -funsigned-char ;;
powerpc) posix powerpc-linux-gnu-gcc '' -static ;;
386-flat) pc98_flat ;;
386-real) pc98_real ;;
qemu-486)
    pc98_flat
    isapc
    ;;
qemu-486-real)
    pc98_real
    isapc
    ;;
wasm) wasm ;;
*)
    echo "build.sh: no target \"$target\"" >&2
    exit 1
    ;;
esac

# fits ROOM SECTION...: the sections and the worst stack share so many bytes.
fits() {
    room=$1
    shift
    fixed=$(size -A "$folder/image.elf" |
        awk -v names=" $* " 'index(names, " " $1 " ") { sum += $2 } END { print sum + 0 }')
    deep=$(sh $here/stack.sh "$target" "$folder")
    [ $((fixed + deep)) -le "$room" ] || [ "${FIT:-}" = any ] || {
        echo "build.sh: $scene does not fit $target: memory of $fixed bytes and a stack of $deep, where" \
            "$room are there; choose a smaller --size or --depth, minimal features, or another target" >&2
        exit 1
    }
}

case $target in
cortex-m0) fits 16384 .data .bss ;;
cortex-m3 | cortex-m4f | rv32im) fits 65536 .data .bss ;;
386-flat | qemu-486) fits 192512 .text .rodata .data .bss ;;
386-real | qemu-486-real) fits 65532 .text .rodata .data .bss ;;
esac
