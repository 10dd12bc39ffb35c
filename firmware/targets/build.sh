#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the firmware for a target: build.sh TARGET ARITHMETIC SCENE SIZE DEPTH FEATURES FOLDER
#
# TARGET      a folder here with a target.sh: see targets.sh
# ARITHMETIC  fx or f32
# SCENE       what `superframe compile` takes; SIZE and DEPTH go with it, - is the scene's own
# FEATURES    minimal: what the scene requires; full: everything
# FOLDER      where image.elf (or .wasm, .hdm) is made
# COMPILE     more options of `superframe compile`: --tail estimate
# FIT         any: an image whose stack does not fit the machine's memory is built all the same
# SUPERFRAME  the program (build/superframe); CC the native compiler (gcc)
# TARGET_RAM  bytes of memory in place of the target's: up to 65536 for a Cortex-M0 in QEMU
#
# Exit status: 0 built, 1 not.
set -eu

target=$1 arithmetic=$2 scene=$3 size=$4 depth=$5 features=$6 folder=$7
SUPERFRAME=${SUPERFRAME:-build/superframe}
CC=${CC:-gcc}
. firmware/targets/targets.sh
target_read "$target" || exit 1
memory=${TARGET_RAM:-$memory}
name=$(basename "$scene" .scene)
symbol=scene_$(printf %s "$name" | sed 's/[^0-9A-Za-z]/_/g')

rm -rf "$folder"
mkdir -p "$folder/tables"
options=${COMPILE:-}
[ "$size" = - ] || options="$options --size $size"
[ "$depth" = - ] || options="$options --depth $depth"
"$SUPERFRAME" compile "$scene" $options -o "$folder/scene.c"
if [ "$features" = minimal ]; then
    "$SUPERFRAME" compile "$scene" $options --minimal -o "$folder/tables/feature_set.h"
else
    # Sets as lists, where the scene has them.
    form=full
    ! grep -q 'FEATURE_NESTING' "$folder/scene.c" || form=many
    cp firmware/features/$form/feature_set.h "$folder/tables/feature_set.h"
fi

# A multiple exposure takes a camera whose shutter is opened eight times.
if [ "$screen" = yes ] && grep -q SHOW_EXPOSURES "$folder/scene.c"; then
    echo "build.sh: $target shows one picture, and \"$scene\" is a multiple exposure;" \
        'allowed are colour = "full", "bits:1" to "bits:8" and "dither"' >&2
    exit 1
fi

# The folder of the numbers, and a square root for those without one.
real=$fx root=
[ "$arithmetic" = fx ] || real=$arithmetic root=$square_root

# What every compiler gets. Copies are loops: see common/memory.c.
flags="-std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding
 -ffp-contract=off -ffunction-sections -fdata-sections
 -DTARGET_IMAGE=image_$arithmetic -DTARGET_SCENE=$symbol
 -Ifirmware/real/$real -I$folder/tables -Ihal -Ifirmware -I$targets/common"
firmware="firmware/*.c $folder/scene.c"
# Without -fno-tree-pre gcc follows a number that was saturated as one of 64 bits, and multiplies it so.
gnu='-fno-tree-pre -fno-tree-loop-distribute-patterns -fstack-usage -fcallgraph-info=su -nostdlib -Wl,--gc-sections'
records="$targets/common/frame.c $targets/common/port_records.c"
semihosting="$records $targets/common/memory.c $targets/common/semihosting_sink.c"

build

[ "$memory" -gt 0 ] && [ "${FIT:-}" != any ] || exit 0
fixed=$(size -A "$folder/image.elf" |
    awk -v names=" $sections " 'index(names, " " $1 " ") { sum += $2 } END { print sum + 0 }')
deep=$(sh $targets/stack.sh "$target" "$folder")
[ $((fixed + deep)) -le "$memory" ] || {
    echo "build.sh: $scene does not fit $target: memory of $fixed bytes and a stack of $deep, where" \
        "$memory are there; choose a smaller --size or --depth, minimal features, or another target" >&2
    exit 1
}
