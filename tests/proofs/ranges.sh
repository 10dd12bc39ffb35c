#!/bin/sh
# SPDX-License-Identifier: MIT
# Has Frama-C's Eva read ranges.c: no operation of fixed point overflows, for any argument allowed.
#
# ranges.sh FOLDER, where the reports go. Three things are proved:
#   1. no undefined behaviour and no signed overflow, on a CPU of 64 bits;
#   2. the same where int has 16 bits;
#   3. nothing unsigned wraps either, but for the functions of `wrapping`, which are meant to.
# Every operation that strict/real.h declares must be called. Exit status: 0 proved, 1 not.
set -eu

reports=$1
here=$(dirname "$0")
mkdir -p "$reports"

# What wraps, and why that is right:
#   area_add, area_subtract   the sign tells afterwards, and the sum is saturated
#   fixed_rounded_near        a shift in two halves: what is lost above is in the other half
#   fixed_slope_of_norm, fixed_nearest_root64   n - r^2 is never negative and r + 1 fits, because r is
#                             the floor of the root of n < 2^64 - 2^32: root_exhaustive.c
wrapping='area_add|area_subtract|fixed_rounded_near|fixed_slope_of_norm|fixed_nearest_root64'

# What Eva takes from the contracts in ranges.c instead of reading it: proved by trial, or by the
# main `kernels`; in the third run also the two functions that negate by wrapping.
by_trial=fixed_reciprocal,fixed_root_of_normal
by_kernels=fixed_slope_of_norm,fixed_nearest_root64
negating=fixed_magnitude,fixed_magnitude64

for operation in $(sed -n 's/^[a-z].*[ *]\([a-z_]*\)(.*/\1/p' firmware/real/strict/real.h); do
    grep -q "[ ()]$operation(" "$here/ranges.c" || {
        echo "ranges: $operation of strict/real.h is not called in ranges.c" >&2
        exit 1
    }
done

# eva NAME MAIN MACHINE TAKEN [OPTION...]: prints whatever is not proved.
eva() {
    report=$reports/$1-$2
    main=$2 machine=$3 taken=$4
    shift 4
    timeout -k 5 500 frama-c -eva -eva-precision 5 -main "$main" -machdep "$machine" "$@" \
        -eva-use-spec "$taken" -cpp-extra-args="-Ifirmware/real/fx -Ihal -Ifirmware" \
        "$here/ranges.c" -then -report-csv "$report.csv" > "$report.txt" 2>&1 || {
        tail -n 20 "$report.txt" >&2
        echo "ranges: Frama-C could not read ranges.c; all it said: $report.txt" >&2
        exit 1
    }
    # 100% of the statements of what was reached: a sure error would leave the rest unread.
    grep -q 'statements reached (out of [0-9]*): 100% coverage' "$report.txt" || {
        echo "ranges: not everything was reached; see $report.txt" >&2
        exit 1
    }
    # Columns: folder, file, line, function, kind, status, property. A contract that is taken has
    # postconditions that Eva does not look at.
    awk -F '\t' -v taken=",$taken,$negating," '
    NR > 1 && $1 !~ /FRAMAC_SHARE/ && $6 !~ /^(Valid|Considered valid|Dead)/ &&
    !($5 == "postcondition" && index(taken, "," $4 ",")) {
        print $1 "/" $2 ":" $3 ": " $4 ": " $5 " is " tolower($6) ": " $7
    }' "$report.csv"
}

# both NAME MACHINE TAKEN [OPTION...]
both() {
    name=$1 machine=$2 more=$3
    shift 3
    eva "$name" kernels "$machine" "$by_trial" "$@"
    eva "$name" operations "$machine" "$by_trial,$by_kernels$more" "$@"
}

failed=0
# judge WHAT LINES
judge() {
    if [ -n "$2" ]; then
        printf '%s\n' "$2"
        echo "ranges: NOT proved: $1"
        failed=1
    else
        echo "ranges: proved: $1"
    fi
}

found=$(both wide x86_64 '')
judge 'no undefined behaviour' "$found"
found=$(both narrow x86_16 '')
judge 'no undefined behaviour where int has 16 bits' "$found"
found=$(both wrapping x86_64 ",$negating" -warn-unsigned-overflow)
judge 'nothing wraps that is not meant to' \
    "$(printf '%s\n' "$found" | grep -Ev "^\$|: ($wrapping): unsigned_overflow is unknown" || true)"
exit $failed
