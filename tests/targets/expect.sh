# SPDX-License-Identifier: MIT
# What the tests of images begin with, as `. "$(dirname "$0")/expect.sh"`: the place, the program, and what
# counts failures. $work, a folder, is the caller's to set.
set -u
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
# Not the program under the sanitizers: the CPU is not what they look at, and takes its time.
SUPERFRAME=$BUILD/superframe
export BUILD SUPERFRAME
failures=0

wrong() {
    echo "WRONG: $*"
    failures=$((failures + 1))
}

# expect STATUS TEXT COMMAND...: the command ends so and says so; TEXT is a pattern of grep.
expect() {
    status=$1
    text=$2
    shift 2
    timeout 60 "$@" > "$work/said.txt" 2>&1
    found=$?
    [ $found -eq "$status" ] || wrong "$*: exit status $found; expected is $status"
    [ -z "$text" ] || grep -q "$text" "$work/said.txt" || {
        wrong "$*: does not say: $text"
        head -n 5 "$work/said.txt"
    }
}
