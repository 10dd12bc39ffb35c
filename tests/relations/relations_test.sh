#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds all relations on a fixed range of seeds, and checks what the program refuses.
# Exit status: 0 all hold, 1 one does not.
set -u
relations=$BUILD/release/tests/relations/relations
out=$BUILD/relations
failures=0

# refused ARGUMENT...: exit status 2, one line that says what is allowed, nothing on standard output.
refused() {
    text=$("$relations" "$@" 2>&1 > "$out.stdout")
    status=$?
    if [ $status -ne 2 ] || [ -s "$out.stdout" ] || [ "${text#*allowed is}" = "$text" ]; then
        echo "relations $*: exit status $status: $text"
        failures=$((failures + 1))
    fi
}

refused
refused SEEDS=0:1
for argument in SEEDS=5 SEEDS=5:5 SEEDS=6:5 SEEDS=1:2x SEEDS=-1:2 SEEDS=1:1234567890 SEEDS= \
    RELATION=none RELATION= SECONDS=0 SECONDS=1s JOBS=0 JOBS=257 COVERED=no seeds=0:1 0:1; do
    refused "$out" "$argument"
done
rm -f "$out.stdout"

"$relations" "$out" SEEDS=0:400 COVERED=yes || failures=$((failures + 1))
[ $failures -eq 0 ]
