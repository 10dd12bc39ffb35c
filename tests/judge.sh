#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs one test program for tests/run.sh, and says how it ended: tests/judge.sh PROGRAM
#
# The line that sums it up goes to standard output, after what a program printed that failed, and to the
# end of the file RESULTS. Environment: BUILD, SUPERFRAME, RESULTS and TEST_TIMEOUT. Exit status: 0.
set -u

program=$1
log=$(mktemp "$BUILD/test-log.XXXXXX") || exit 1
trap 'rm -f "$log" "$log.shown"' EXIT
trap 'exit 130' INT TERM

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

note=
began=$(date +%s)
case $program in
*.sh)
    timeout -k 10 "$TEST_TIMEOUT" sh "$program" > "$log" 2>&1
    status=$?
    judge_script $status
    ;;
*)
    timeout -k 10 "$TEST_TIMEOUT" "$program" > "$log" 2>&1
    status=$?
    judge_suite $status
    ;;
esac
if [ $status -eq 124 ] || [ $status -eq 137 ]; then
    [ "$failed" -gt 0 ] || failed=1
    note="no end within $TEST_TIMEOUT seconds, or killed"
fi
seconds=$(($(date +%s) - began))
name=${program#"$BUILD"/sanitized/}
{
    if [ "$failed" -gt 0 ]; then
        echo "---- $program:"
        tail -n 200 "$log" | cut -c 1-500
        echo "----"
    fi
    printf '%-46s %5d passed %3d failed %5d s  %s\n' "${name#tests/}" "$passed" "$failed" "$seconds" "$note"
} > "$log.shown"
# In one go: another program may end at the same time.
tail -n 1 "$log.shown" >> "$RESULTS"
cat "$log.shown"
