#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the trace_hash of what run_target.sh has left: trace_hash.sh FOLDER
set -eu

SUPERFRAME=${SUPERFRAME:-build/superframe}
trace=$1/ports.trace
if [ -f "$1/ports.bin" ]; then
    trace=$1/ports.txt
    sh "$(dirname "$0")/records.sh" "$1/ports.bin" > "$trace"
fi
hash=$("$SUPERFRAME" replay "$trace" --stats - | sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p')
rm -f "$1/ports.txt"
[ -n "$hash" ]
echo "$hash"
