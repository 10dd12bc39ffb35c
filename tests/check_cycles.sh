#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves from the objects' symbols that no source files need each other in a circle.
#
# A file needs another one if it uses a function or table that the other defines. One arithmetic's firmware
# and one stream engine stand for all of them. $BUILD/release is made by make.
# Exit status: 0 no circle, 1 there is one, 2 nothing was found to check.
set -u
cd "$(dirname "$0")/.." || exit 2
BUILD=${BUILD:-build}
pairs=$BUILD/cycles.txt

# circles OBJECT...: prints a line for each circle of files.
circles() {
    nm -A -g -P "$@" 2> /dev/null | awk '{
        file = $1
        sub(/:$/, "", file)
        if ($3 == "U") {
            needs[++count] = file " " $2
        } else if ($3 != "w" && $3 != "v") {
            home[$2] = file
        }
    } END {
        for (i = 1; i <= count; i++) {
            split(needs[i], pair, " ")
            if (pair[2] in home && home[pair[2]] != pair[1]) {
                print pair[1], home[pair[2]]
            }
        }
    }' | sort -u > "$pairs"
    used=$(wc -l < "$pairs")
    [ "$used" -gt 0 ] || {
        echo "check_cycles: nothing found among $*" | cut -c 1-200 >&2
        exit 2
    }
    total=$((total + used))
    tsort "$pairs" 2>&1 > /dev/null | sed 's/^tsort: //'
}

# objects_of PREFIX FOLDER...: the objects of all sources below the folders, of those that this build has.
objects_of() {
    prefix=$1
    shift
    find "$@" -name '*.c' | while read -r source; do
        object=$BUILD/release/$prefix${source%.c}.o
        [ ! -e "$object" ] || echo "$object"
    done
}

total=0
found=$BUILD/cycles-found.txt
{
    # shellcheck disable=SC2046 # names without blanks
    circles $(objects_of '' host emulator hal firmware/adapter)
    # shellcheck disable=SC2046
    circles $(objects_of arithmetic_fx/ firmware host/render/per_arithmetic)
    # shellcheck disable=SC2046
    circles $(objects_of stream_engine_f32_plain/ firmware host/stream)
} > "$found"
if [ -s "$found" ]; then
    echo 'check_cycles: these files need each other:'
    cat "$found"
    exit 1
fi
echo "check_cycles: $total pairs of files, no circle"
