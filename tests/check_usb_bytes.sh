#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the encoder to what it promises of the paper's figures: at most 3.2 bytes a pixel for fig3 in
# full colour, less than 1 in the eight colours of the dither.
#
# Exit status: 0 it holds, 1 it does not. $BUILD has both programs.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
trace=$(mktemp) || exit 1
trap 'rm -f "$trace"' EXIT

# hold MOST WORDS...: what render makes of the words costs at most so many bytes a pixel.
hold() {
    most=$1
    shift
    "$BUILD/superframe" render "$@" --quiet --bus trace:"$trace" || exit 1
    row=$("$BUILD/release/tests/bench/usb_bytes" "$*" "$trace") || exit 1
    echo "$row"
    echo "$row" | awk -F'|' -v most="$most" '{ exit !($5 > 0 && $5 <= most) }' || {
        echo "check_usb_bytes: $*: more than $most bytes a pixel"
        exit 1
    }
}

hold 3.2 fig3 --colour full
for scene in fig3 fig6a fig6b; do
    hold 0.5 "$scene" --colour dither
done
