#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures what images take and holds it against the kept figures: size.sh [--keep] FILE
#
# FILE has a line for each image: target, arithmetic, scene, features, code, constants, RAM (the
# stack included), stack, 10^6 instructions of a frame of 160 x 100 at depth 10; - is what is not
# measured. All but the last in bytes. RAM is what outlives a call and the worst stack, which comes
# from gcc's own figures and the call graph. Of a WebAssembly module the whole file counts as code.
# JOBS images are measured at a time (2).
# Exit status: 0 nothing grew by more than 2 per cent and the limits hold, 1 something did, or an
# image was not built or not run to its end; then FILE is as it was.
set -eu

keep=no
[ "$1" != --keep ] || {
    keep=yes
    shift
}
kept=$1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
export BUILD SUPERFRAME
here=$(dirname "$0")
now=$BUILD/targets/size.txt
work=$BUILD/targets/size
rm -rf "$work"
mkdir -p "$work"

. firmware/targets/targets.sh

# Prints all images as "TARGET ARITHMETIC FEATURES count|-", those first that take longest.
images() {
    for target in $(target_names); do
        target_read "$target"
        for image in $sizes; do
            case $image in
            */count) echo "$target $image" ;;
            *) echo "$target $image/-" ;;
            esac
        done
    done | tr / ' ' | tac | sort -s -r -k 4
}
images | xargs -P "${JOBS:-2}" -L 1 sh "$here/size_image.sh" "$work"

{
    echo '# target arithmetic scene features code constants ram stack million_instructions'
    cat "$work"/*.size
} > "$now"
column -t "$now" 2> /dev/null || cat "$now"
awk -f "$here/size_limits.awk" "$now"

if [ $keep = yes ]; then
    cp "$now" "$kept"
    exit 0
fi
awk -f "$here/size_growth.awk" "$kept" "$now"
