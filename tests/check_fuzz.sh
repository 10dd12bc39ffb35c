#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the fuzzers from their kept corpora: check_fuzz.sh [SECONDS [NAME]], see docs/fuzzing.md
#
# Two at a time. First comes every file of the corpus, then what the last run has left in
# $BUILD/fuzz/NAME/found, where whatever is found goes; without arguments, 15 seconds from the corpus
# alone. An input that fails goes to $BUILD/fuzz/NAME. Exit status: 0 none did, 1 one did, 2 nothing
# was run.
set -u
cd "$(dirname "$0")/.." || exit 2
BUILD=${BUILD:-build}
[ $# -gt 0 ] || FUZZ_FOUND=found-by-test
FUZZ_FOUND=${FUZZ_FOUND:-found}
export BUILD FUZZ_FOUND
seconds=${1:-15}

if [ $# -lt 2 ]; then
    ls "$BUILD"/fuzzed/tests/fuzz/*_fuzz > /dev/null || exit 2
    for program in "$BUILD"/fuzzed/tests/fuzz/*_fuzz; do
        basename "$program" _fuzz
    done | xargs -P 2 -n 1 sh tests/check_fuzz.sh "$seconds" || exit 1
    exit 0
fi

name=$2
program=$BUILD/fuzzed/tests/fuzz/${name}_fuzz
corpus=tests/fuzz/${name}_corpus
folder=$BUILD/fuzz/$name
log=$folder/log
if ! [ -x "$program" ] || ! [ -d "$corpus" ]; then
    echo "check_fuzz: no fuzzer \"$name\" with a corpus" >&2
    exit 2
fi
found=$folder/$FUZZ_FOUND
rm -rf "$folder/found-by-test"
mkdir -p "$found" || exit 2
set -- -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -max_len=8192 \
    -artifact_prefix="$folder/" -print_final_stats=1
[ ! -f "tests/fuzz/$name.dict" ] || set -- "$@" -dict="tests/fuzz/$name.dict"
if "$program" "$@" "$found" "$corpus" > "$log" 2>&1; then
    sed -n "s/^#\([0-9]*\).*DONE *cov: \([0-9]*\) ft: \([0-9]*\) .*/$name: \1 inputs, \2 edges, \3 features/p" "$log"
    exit 0
fi
tail -n 40 "$log"
input=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
echo "$name: ${input:-no input} fails; again: $program $input"
exit 1
