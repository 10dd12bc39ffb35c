#!/bin/sh
# SPDX-License-Identifier: MIT
# Without libquadmath the program is built all the same: it draws, says of --arith f128 that this build
# has none, and lists those that it has.
#
# $BUILD/superframe_without is made by make. Exit status: 0 it holds, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
program=$BUILD/superframe_without
out=$BUILD/without-f128.txt
failures=0

# expect STATUS TEXT WORDS...
expect() {
    expected=$1
    text=$2
    shift 2
    "$program" "$@" > "$out" 2>&1
    status=$?
    if [ $status -ne "$expected" ] || ! grep -q -e "$text" "$out"; then
        echo "check_without_f128: $*: exit status $status, expected $expected and \"$text\":"
        cat "$out"
        failures=$((failures + 1))
    fi
}

missing='--arith f128: not built into this version; allowed is: fx, f32 or f64$'
for command in 'render fig3' 'measure fig3 -o /dev/null' 'tree fig3 0 0'; do
    # shellcheck disable=SC2086 # a list of words
    expect 2 "$missing" $command --arith f128
done
expect 2 '--arith: "f16" is invalid; allowed is: fx, f32 or f64$' render fig3 --arith f16
expect 0 "the firmware's arithmetic (fx); allowed: fx, f32 or" render --help
if grep -q f128 "$out"; then
    echo 'check_without_f128: the help speaks of f128'
    failures=$((failures + 1))
fi
expect 0 '^f64 *holds it$' check fig3
if grep -q f128 "$out"; then
    echo 'check_without_f128: check speaks of f128'
    failures=$((failures + 1))
fi
for arithmetic in fx f32 f64; do
    expect 0 '"leaked_rays": 0,' render fig3 --size 8x8 -o /dev/null --quiet --arith $arithmetic --stats -
done
[ $failures -eq 0 ]
