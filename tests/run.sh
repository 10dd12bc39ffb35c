#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs test programs and sums up: tests/run.sh BUILD PROGRAM...
#
# A program is a cmocka suite, or a script (*.sh) that counts as one test and whose exit status
# tells. TEST_JOBS run at a time (2), each for TEST_TIMEOUT seconds at most (600). What a program
# prints is shown only if it fails. A crash, a time-out or a suite that ran no test is a failure.
# The last line is "N passed, N failed". With TEST_SLOWEST=N, the N programs that took longest come before.
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
TEST_TIMEOUT=${TEST_TIMEOUT:-600}
RESULTS=$(mktemp "$BUILD/test-results.XXXXXX") || exit 1
export BUILD SUPERFRAME TEST_TIMEOUT RESULTS
trap 'rm -f "$RESULTS"' EXIT
trap 'exit 130' INT TERM

[ $# -eq 0 ] || printf '%s\n' "$@" | xargs -P "${TEST_JOBS:-2}" -n 1 sh "$(dirname "$0")/judge.sh"

if [ "${TEST_SLOWEST:-0}" -gt 0 ]; then
    echo "the $TEST_SLOWEST that took longest:"
    sort -k 6 -n -r "$RESULTS" | head -n "$TEST_SLOWEST"
fi
awk -v programs=$# '
{ passed += $2; failed += $4 }
END {
    if (NR < programs) {
        print programs - NR " programs were not judged"
        failed += programs - NR
    } else if (passed + failed == 0) {
        print "no test was run"
        failed = 1
    }
    printf "%d passed, %d failed\n", passed, failed
    exit (failed > 0)
}' "$RESULTS"
