#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs test programs and sums up: tests/run.sh BUILD PROGRAM...
#
# A program is a cmocka suite, or a script (*.sh) that counts as one test and whose exit status
# tells. Each has TEST_TIMEOUT seconds (600). What it prints is shown only if it fails. The last
# line is "N passed, N failed". A crash, a time-out or a suite that ran no test is a failure.
#
# Programs find in their environment BUILD, the build folder, and SUPERFRAME, the program under the
# sanitizers. Exit status: 0 all passed, 1 not, 2 bad usage.
set -u

[ $# -ge 1 ] || {
    echo 'usage: tests/run.sh BUILD PROGRAM...' >&2
    exit 2
}
BUILD=$1
shift
SUPERFRAME=${SUPERFRAME:-$BUILD/sanitized/superframe}
export BUILD SUPERFRAME
log=$(mktemp "$BUILD/test-log.XXXXXX") || exit 1
trap 'rm -f "$log"' EXIT
trap 'exit 130' INT TERM

total_passed=0
total_failed=0

# Adds up the numbers that cmocka's summaries give for one word, PASSED, FAILED or SKIPPED.
summary() {
    sed -n -e "s/^\[  $1  *\] \([0-9][0-9]*\) test(s).*/\1/p" \
        -e "s/^\[  $1  *\] .*: \([0-9][0-9]*\) test(s), listed below:.*/\1/p" "$log" |
        awk '{ sum += $1 } END { print sum + 0 }'
}

# Sets passed, failed and note for a cmocka suite that ended with $1.
judge_suite() {
    passed=$(summary PASSED)
    failed=$(summary FAILED)
    skipped=$(summary SKIPPED)
    announced=$(sed -n 's/^\[==========\] Running \([0-9]*\) test(s).*/\1/p' "$log" |
        awk '{ sum += $1 } END { print sum + 0 }')
    [ "$skipped" -eq 0 ] || note="$skipped skipped"
    if [ "$announced" -eq 0 ]; then
        failed=$((failed + 1))
        note='ran no test'
    elif [ $((passed + failed + skipped)) -lt "$announced" ]; then
        failed=$((failed + 1))
        note='stopped half-way'
    elif [ $((passed + failed)) -eq 0 ]; then
        failed=1
        note='all tests were skipped'
    elif [ "$1" -ne 0 ] && [ "$failed" -eq 0 ]; then
        failed=1
        note="exit status $1"
    fi
}

# Sets passed, failed and note for a script that ended with $1.
judge_script() {
    passed=1
    failed=0
    if [ "$1" -ne 0 ]; then
        passed=0
        failed=1
        note="exit status $1"
    fi
}

for program in "$@"; do
    note=
    began=$(date +%s)
    case $program in
    *.sh)
        timeout -k 10 "${TEST_TIMEOUT:-600}" sh "$program" > "$log" 2>&1
        status=$?
        judge_script $status
        ;;
    *)
        timeout -k 10 "${TEST_TIMEOUT:-600}" "$program" > "$log" 2>&1
        status=$?
        judge_suite $status
        ;;
    esac
    if [ $status -eq 124 ] || [ $status -eq 137 ]; then
        [ $failed -gt 0 ] || failed=1
        note="no end within ${TEST_TIMEOUT:-600} seconds, or killed"
    fi
    seconds=$(($(date +%s) - began))
    if [ $failed -gt 0 ]; then
        echo "---- $program:"
        tail -n 200 "$log" | cut -c 1-500
        echo "----"
    fi
    name=${program#"$BUILD"/sanitized/}
    printf '%-46s %5d passed %3d failed %5d s  %s\n' "${name#tests/}" "$passed" "$failed" "$seconds" "$note"
    total_passed=$((total_passed + passed))
    total_failed=$((total_failed + failed))
done

if [ $((total_passed + total_failed)) -eq 0 ]; then
    echo 'no test was run'
    total_failed=1
fi
echo "$total_passed passed, $total_failed failed"
[ $total_failed -eq 0 ]
