#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs fig3 and fig4b on every target and writes the table into a page: table.sh PAGE
#
# The page's lines between "<!-- targets -->" and "<!-- end of targets -->" are replaced. The
# reference is what the native program gives in the same run. TARGETS and FLOAT_TARGETS name fewer
# targets; JOBS run at a time (2), each for TARGET_TIMEOUT seconds at most (600). SIZE and DEPTH are
# the picture's: 160x100 and 10 in the page, as in the page's table of all scenes.
# Exit status: 0 every hash is the native one, 1 one is not, and the page is as it was.
set -eu

page=$1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
TARGET_TIMEOUT=${TARGET_TIMEOUT:-600}
SIZE=${SIZE:-160x100}
DEPTH=${DEPTH:-10}
export BUILD SUPERFRAME TARGET_TIMEOUT SIZE DEPTH
here=$(dirname "$0")
work=$BUILD/targets/table
mkdir -p "$work"
table=$work/table.md
failed=0

TARGETS=${TARGETS:-gcc clang gcc-m32 unsigned-char wasm powerpc cortex-m4f cortex-m3 rv32im cortex-m0 \
    qemu-486 qemu-486-real 386-flat 386-real}
# Floating point: held to a tolerance elsewhere; here for what it costs. In software it takes too long
# for a table: tests/targets/size.sh measures it on a smaller picture.
FLOAT_TARGETS=${FLOAT_TARGETS-cortex-m4f}

native_hash() {
    "$SUPERFRAME" render "$1" --arith "$2" --size $SIZE --depth $DEPTH --quiet -o "$work/$1-$2.png" \
        --stats - | sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p'
}

# All runs as "TARGET ARITHMETIC SCENE FOLDER", the longest ones first: they are at the lists' ends.
runs() {
    {
        for target in $FLOAT_TARGETS; do
            echo "$target f32"
        done
        for target in $TARGETS; do
            echo "$target fx"
        done
    } | awk -v work="$work" '
        { line[NR] = $0 }
        END {
            for (i = NR; i > 0; i--) {
                split(line[i], part, " ")
                print line[i], "fig3", work "/" part[1] "-" part[2] "-fig3"
                print line[i], "fig4b", work "/" part[1] "-" part[2] "-fig4b"
            }
        }'
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
    cells=
    for scene in fig3 fig4b; do
        expected=$(cat "$work/native-$2-$scene")
        read -r hash count < "$work/$1-$2-$scene/result" || return 1
        if [ "$hash" != "$expected" ] && [ "$2" = fx ]; then
            echo "$1 $2 $scene: trace_hash $hash; the native one is $expected" >&2
            failed=1
        fi
        [ "$count" = - ] || count=$(awk -v n="$count" 'BEGIN { printf "%.3f", n / 1e9 }')
        cells="$cells | \`$hash\` | $count"
    done
    echo "| $(describe "$1") | $2$cells |" >> "$table"
}

for scene in fig3 fig4b; do
    native_hash $scene fx > "$work/native-fx-$scene"
    native_hash $scene f32 > "$work/native-f32-$scene"
done
runs | xargs -P "${JOBS:-2}" -L 1 sh "$here/measure.sh" || exit 1

{
    echo "| target | arithmetic | fig3: trace_hash | 10⁹ instructions | fig4b: trace_hash | 10⁹ instructions |"
    echo "|---|---|---|---|---|---|"
    echo "| superframe render | fx | \`$(cat "$work/native-fx-fig3")\` | - | \`$(cat "$work/native-fx-fig4b")\` | - |"
} > "$table"
for target in $TARGETS; do
    add_row "$target" fx
done
for target in $FLOAT_TARGETS; do
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
