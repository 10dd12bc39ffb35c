#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds docs/changing.md to the tree: each list has as many files or folders as its heading says, and all
# are there.
# Exit status: 0 it holds, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
awk '
function end() {
    if (heading != "" && rows != asked) {
        printf "%s: %d are listed, the heading says %d\n", heading, rows, asked
        failures++
    }
    heading = ""
}
/^### / {
    end()
    if (match($0, /: [0-9]+ (files?|folders?)$/)) {
        heading = substr($0, 5)
        asked = substr($0, RSTART + 2) + 0
        rows = 0
        lists++
    }
}
/^\| `/ {
    rows++
    file = $2
    gsub(/`/, "", file)
    if (system("[ -e \"" file "\" ]") != 0) {
        printf "%s: no such file: %s\n", heading, file
        failures++
    }
}
END {
    end()
    exit lists == 0 || failures > 0
}' docs/changing.md
