#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs fig3 and fig4b on every target and writes the table into a page: table.sh PAGE
#
# The page's lines between "<!-- targets -->" and "<!-- end of targets -->" are replaced. The
# reference is what the native program gives in the same run. TARGETS names fewer targets; JOBS run
# at a time (2), each for TARGET_TIMEOUT seconds at most (600). SIZE and DEPTH are the picture's:
# 160x100 and 10 in the page, as in the page's table of all scenes.
# Floating point is held to a tolerance elsewhere, and is here for what it costs.
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

. firmware/targets/targets.sh
TARGETS=${TARGETS:-$(target_names)}
for target in $TARGETS; do
    target_read "$target" || exit 1
done

native_hash() {
    "$SUPERFRAME" render "$1" --arith "$2" --size $SIZE --depth $DEPTH --quiet -o "$work/$1-$2.png" \
        --stats - | sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p'
}

# ships ARITHMETIC: prints the targets that ship it.
ships() {
    for target in $TARGETS; do
        target_read "$target" && case " $arithmetics " in *" $1 "*) echo "$target" ;; esac
    done
}

# All runs as "TARGET ARITHMETIC SCENE FOLDER", those first that take longest.
runs() {
    for arithmetic in f32 fx; do
        for target in $(ships $arithmetic); do
            for scene in fig4b fig3; do
                echo "$target $arithmetic $scene $work/$target-$arithmetic-$scene"
            done
        done
    done | tac
}

# add_row TARGET ARITHMETIC
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
    target_read "$1"
    echo "| $title | $2$cells |" >> "$table"
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
for arithmetic in fx f32; do
    for target in $(ships $arithmetic); do
        add_row "$target" $arithmetic
    done
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
