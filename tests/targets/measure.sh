#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds and runs one scene on one target: measure.sh TARGET ARITHMETIC SCENE FOLDER
#
# Leaves in FOLDER/result the trace_hash and the instructions of the run (- where they are not
# counted), or nothing, and what was said in FOLDER.log. SIZE and DEPTH are the picture's; BUILD and
# SUPERFRAME as for the others. Exit status: 0 done, 1 not.
set -eu

target=$1 arithmetic=$2 scene=$3 folder=$4
here=$(dirname "$0")
began=$(date +%s)

run() {
    sh firmware/targets/build.sh "$target" "$arithmetic" "$scene" "$SIZE" "$DEPTH" minimal "$folder" &&
        COUNT=$BUILD/targets/count.so sh "$here/run_target.sh" "$target" "$folder"
}

rm -rf "$folder"
if ! run > "$folder.log" 2>&1; then
    echo "$target $arithmetic $scene: not built, or not run to its end:" >&2
    tail -n 20 "$folder.log" >&2
    exit 1
fi
count=-
[ ! -f "$folder/instructions.txt" ] || count=$(cat "$folder/instructions.txt")
hash=$(sh "$here/trace_hash.sh" "$folder")
rm -f "$folder"/ports.*
echo "$hash $count" > "$folder/result"
echo "$target $arithmetic $scene: $hash, $count instructions, $(($(date +%s) - began)) s"
