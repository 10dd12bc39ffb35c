#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures one image for size.sh: size_image.sh FOLDER TARGET ARITHMETIC FEATURES count|-
#
# Leaves the image's line in FOLDER/TARGET-ARITHMETIC-FEATURES.size. Exit status: 0 done, 1 not.
set -eu

target=$2 arithmetic=$3 features=$4 counted=$5
name=$target-$arithmetic-$features
folder=$1/$name
here=$(dirname "$0")
. "$here/image_bytes.sh"

fail() {
    echo "$name: $1:" >&2
    tail -n 20 "$folder.log" >&2
    exit 1
}

# build SIZE
build() {
    FIT=any sh firmware/targets/build.sh "$target" "$arithmetic" fig3 "$1" 10 "$features" "$folder" \
        > "$folder.log" 2>&1 || fail 'not built'
}

count=-
if [ "$counted" = count ]; then
    build 160x100
    COUNT=$BUILD/targets/count.so sh "$here/run_target.sh" "$target" "$folder" > "$folder.log" 2>&1 ||
        fail 'not run to its end'
    count=$(awk '{ printf "%.1f", $1 / 1e6 }' "$folder/instructions.txt")
    [ -n "$count" ] || fail 'no instructions were counted'
fi
build 320x200
if [ -f "$folder/image.wasm" ]; then
    sizes="$(wc -c < "$folder/image.wasm") - - -"
else
    deep=$(sh firmware/targets/stack.sh "$target" "$folder")
    sizes="$(section "$folder/image.elf" .text .ARM.exidx) $(section "$folder/image.elf" .rodata) $(($(section "$folder/image.elf" .bss .data) + deep)) $deep"
fi
echo "$target $arithmetic fig3 $features $sizes $count" > "$folder.size"
