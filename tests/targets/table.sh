#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs fig3 and fig4b on every target and writes the table into a page: table.sh PAGE
#
# The page's lines between "<!-- targets -->" and "<!-- end of targets -->" are replaced. The
# reference is what the native program gives in the same run. TARGETS names fewer targets.
# Exit status: 0 every hash is the native one, 1 one is not, and the page is as it was.
set -eu

page=$1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
SIZE=320x200
DEPTH=10
export SUPERFRAME
here=$(dirname "$0")
work=$BUILD/targets/table
plugin=$BUILD/targets/count.so
mkdir -p "$work"
table=$work/table.md
failed=0

native_hash() {
    "$SUPERFRAME" render "$1" --arith "$2" --size $SIZE --depth $DEPTH --quiet -o "$work/$1-$2.png" \
        --stats - | sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p'
}

# measure TARGET ARITHMETIC SCENE: prints the hash and, where they are counted, the instructions.
measure() {
    folder=$work/$1-$2-$3
    sh firmware/targets/build.sh "$1" "$2" "$3" $SIZE $DEPTH minimal "$folder" >&2
    COUNT=$plugin TARGET_TIMEOUT=1800 sh "$here/run_target.sh" "$1" "$folder" >&2
    count=-
    [ ! -f "$folder/instructions.txt" ] || count=$(cat "$folder/instructions.txt")
    echo "$(sh "$here/trace_hash.sh" "$folder") $count"
    rm -f "$folder/ports.bin" "$folder/ports.trace"
}

# What a row says; the name, then what it is.
describe() {
    case $1 in
    gcc) echo 'gcc, x86-64' ;;
    clang) echo 'clang, x86-64' ;;
    gcc-m32) echo 'gcc -m32' ;;
    unsigned-char) echo 'gcc -funsigned-char' ;;
    powerpc) echo 'PowerPC, big-endian (qemu-user)' ;;
    cortex-m0) echo 'Cortex-M0 (QEMU microbit)' ;;
    cortex-m3) echo 'Cortex-M3 (QEMU mps2-an385)' ;;
    cortex-m4f) echo 'Cortex-M4F (QEMU mps2-an386)' ;;
    rv32im) echo 'RV32IM (QEMU virt)' ;;
    386-flat) echo '386, protected mode (PC-98 floppy on Unicorn)' ;;
    386-real) echo '386, real mode (PC-98 floppy on Unicorn)' ;;
    qemu-486) echo '486, protected mode (the same floppy on QEMU isapc)' ;;
    qemu-486-real) echo '486, real mode (the same floppy on QEMU isapc)' ;;
    wasm) echo 'WebAssembly (node)' ;;
    esac
}

add_row() {
    what=$(describe "$1")
    cells=
    for scene in fig3 fig4b; do
        expected=$(native_hash $scene "$2")
        result=$(measure "$1" "$2" $scene)
        hash=${result% *}
        count=${result#* }
        [ "$hash" = "$expected" ] || [ "$2" != fx ] || {
            echo "$1 $2 $scene: trace_hash $hash; the native one is $expected" >&2
            failed=1
        }
        note=
        [ "$hash" = "$expected" ] || note=' (differs)'
        [ "$count" = - ] || count=$(awk -v n="$count" 'BEGIN { printf "%.3f", n / 1e9 }')
        cells="$cells | \`$hash\`$note | $count"
    done
    echo "| $what | $2$cells |" >> "$table"
    tail -n 1 "$table"
}

{
    echo "| target | arithmetic | fig3: trace_hash | 10⁹ instructions | fig4b: trace_hash | 10⁹ instructions |"
    echo "|---|---|---|---|---|---|"
    echo "| superframe render | fx | \`$(native_hash fig3 fx)\` | - | \`$(native_hash fig4b fx)\` | - |"
} > "$table"
for target in ${TARGETS:-gcc clang gcc-m32 unsigned-char wasm powerpc cortex-m4f cortex-m3 rv32im \
    cortex-m0 qemu-486 qemu-486-real 386-flat 386-real}; do
    add_row "$target" fx
done
# Floating point: held to a tolerance elsewhere; here for what it costs.
for target in ${FLOAT_TARGETS-cortex-m4f cortex-m3 cortex-m0}; do
    add_row "$target" f32
done
[ $failed -eq 0 ]

awk -v table="$table" '
/^<!-- targets -->$/ {
    print
    while ((getline line < table) > 0) {
        print line
    }
    inside = 1
    next
}
/^<!-- end of targets -->$/ { inside = 0 }
!inside { print }' "$page" > "$work/page.md"
cp "$work/page.md" "$page"
