#!/bin/sh
# SPDX-License-Identifier: MIT
# Every scene draws one picture, to the last port write, in an image with every feature and in one
# with what the scene requires, whatever pruned branches count as and however deep they are followed.
#
# Exit status: 0 all hold, 1 one does not.
set -u
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
# Not the program under the sanitizers: images are what is looked at.
SUPERFRAME=$BUILD/superframe
export BUILD SUPERFRAME
work=$BUILD/targets/minimal_test
mkdir -p "$work"
failures=0
pictures=0

# image SCENE DEPTH FEATURES: leaves the image's port writes in $work/FEATURES/ports.bin.
image() {
    sh firmware/targets/build.sh gcc fx "$1" 32x20 "$2" "$3" "$work/$3" &&
        TARGET_TIMEOUT=100 sh tests/targets/run_target.sh gcc "$work/$3"
}

# same SCENE DEPTH OPTIONS
same() {
    pictures=$((pictures + 1))
    COMPILE=$3
    export COMPILE
    if ! image "$1" "$2" full || ! image "$1" "$2" minimal; then
        echo "WRONG: $1, depth $2, $3: not built, or not run to its end"
    elif ! cmp "$work/full/ports.bin" "$work/minimal/ports.bin"; then
        echo "WRONG: $1, depth $2, $3: the minimal image draws another picture"
    else
        return
    fi
    failures=$((failures + 1))
}

for scene in $("$SUPERFRAME" scenes | cut -f 1) tests/targets/features.scene; do
    for options in '--tail black' '--tail estimate' '--error 8'; do
        same "$scene" - "$options"
    done
done
# Where every depth level is reached: the first one, the last one, and those from which learning
# goes to it.
for depth in 0 238 240; do
    same tests/targets/mirrors.scene $depth '--tail estimate'
done
for depth in 0 255; do
    same tests/targets/mirrors.scene $depth '--error 8'
done
echo "minimal: $failures of $pictures pictures differ"
[ $failures -eq 0 ] && [ $pictures -gt 5 ]
