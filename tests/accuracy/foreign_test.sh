#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds --error to its promise on the foreign scenes, at shallow depth levels: `make accuracy-foreign` is
# the same at length. Exit status: 0 it is kept, or withdrawn aloud, and nothing proved is exceeded; 1 not.
set -u
cd "$(dirname "$0")/../.." || exit 1
promise=$BUILD/release/tests/accuracy/promise

# refused ARGUMENT...: exit status 2, and nothing in the table.
refused() {
    if "$promise" "$@" > "$BUILD/promise.table" 2>&1 || [ $? -ne 2 ] || grep -q '^|' "$BUILD/promise.table"; then
        echo "promise $* is not refused"
        exit 1
    fi
}

refused
refused 24x15 4 1
refused 24 4 1 tests/accuracy/foreign/forty_lights.scene
refused 24x15 4x 1 tests/accuracy/foreign/forty_lights.scene
refused 24x15 4 1, tests/accuracy/foreign/forty_lights.scene
"$promise" 80x50 4,10 4,1 tests/accuracy/foreign/*.scene > "$BUILD/promise.table" || {
    cat "$BUILD/promise.table"
    exit 1
}
