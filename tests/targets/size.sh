#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures what images take and holds it against the kept figures: size.sh [--keep] FILE
#
# FILE has a line for each image: target, arithmetic, scene, features, code, constants, RAM (the
# stack included), stack, 10^6 instructions of a frame of 160 x 100 at depth 10 (- where they are
# not counted). All but the last in bytes. RAM is what outlives a call and the worst stack, which
# comes from gcc's own figures and the call graph.
# Exit status: 0 nothing grew by more than 2 per cent and the limits hold, 1 something did.
set -eu

keep=no
[ "$1" != --keep ] || {
    keep=yes
    shift
}
kept=$1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
export SUPERFRAME
here=$(dirname "$0")
now=$BUILD/targets/size.txt
work=$BUILD/targets/size
mkdir -p "$work"

# Images: target, arithmetic, features, and whether their instructions are counted.
images='
cortex-m0 fx minimal count
cortex-m0 fx full -
cortex-m0 f32 minimal count
cortex-m3 fx minimal count
cortex-m3 fx full -
cortex-m3 f32 minimal count
cortex-m4f fx minimal count
cortex-m4f f32 minimal count
rv32im fx minimal count
386-flat fx minimal count
386-flat fx full -
386-real fx minimal -
'

. "$here/image_bytes.sh"

measure() {
    folder=$work/$1-$2-$3
    sh firmware/targets/build.sh "$1" "$2" fig3 "$5" 10 "$3" "$folder" >&2
    deep=$(stack "$1" "$folder")
    memory=$(($(section "$folder/image.elf" .bss .data) + deep))
    sizes="$(section "$folder/image.elf" .text .ARM.exidx) $(section "$folder/image.elf" .rodata) $memory $deep"
    count=-
    if [ "$4" = count ]; then
        sh firmware/targets/build.sh "$1" "$2" fig3 160x100 10 "$3" "$folder-run" >&2
        COUNT=$BUILD/targets/count.so sh "$here/run_target.sh" "$1" "$folder-run" >&2
        count=$(awk '{ printf "%.1f", $1 / 1e6 }' "$folder-run/instructions.txt")
        rm -f "$folder-run"/ports.*
    fi
    echo "$1 $2 fig3 $3 $sizes $count"
}

echo '# target arithmetic scene features code constants ram stack million_instructions' > "$now"
echo "$images" | while read -r target arithmetic features counted; do
    [ -z "$target" ] || measure "$target" "$arithmetic" "$features" "$counted" 320x200 >> "$now"
done
column -t "$now" 2> /dev/null || cat "$now"

# The issue's limits, whatever is kept.
awk '
$1 == "cortex-m0" && $2 == "fx" && $4 == "minimal" {
    seen++
    if ($5 + $6 > 16384) { print "cortex-m0: " $5 + $6 " bytes of code and constants; the limit is 16384"; failed = 1 }
    if ($7 > 4096) { print "cortex-m0: " $7 " bytes of RAM; the limit is 4096"; failed = 1 }
}
$1 == "386-flat" && $4 == "minimal" {
    seen++
    if ($5 + $6 > 32768) { print "386-flat: " $5 + $6 " bytes; the limit is 32768"; failed = 1 }
}
END { exit failed || seen < 2 }' "$now"

if [ $keep = yes ]; then
    cp "$now" "$kept"
    exit 0
fi
awk '
/^#/ { next }
{ image = $1 " " $2 " " $3 " " $4 }
NR == FNR { before[image] = $0; next }
!(image in before) { print image ": no kept figures; make size-keep keeps them"; failed = 1; next }
{
    split(before[image], was, " ")
    split("code constants RAM stack instructions", what, " ")
    for (i = 5; i <= 9; i++) {
        if (was[i] != "-" && $i > was[i] * 1.02) {
            printf "%s: %s grew from %s to %s\n", image, what[i - 4], was[i], $i
            failed = 1
        }
    }
}
END { exit failed }' "$kept" "$now"
