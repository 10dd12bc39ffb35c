#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves that the fx image writes the same ports whatever compiled it: trace_hash_matrix.sh
#
# fig3 (320 x 200, depth level 10) is compiled into const tables, and these with the firmware by
# each of the compilers and options below; every program has to print the trace_hash and the number
# of port writes that `superframe render fig3` reports. A variant that this machine can't build is
# skipped, and said to be. Environment: BUILD, the build folder, with the program in it.
# Exit status: 0 all agree, 1 one does not, 2 it can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
build=${BUILD:-build}
folder=$build/trace-hash-matrix
superframe=$build/superframe
failures=0
built=0

mkdir -p "$folder" || exit 2
"$superframe" compile fig3 -o "$folder/fig3.c" || exit 2
"$superframe" render fig3 -o "$folder/fig3.png" --stats "$folder/stats.json" --jobs 2 || exit 2
expected=$(awk -F '[":, ]+' '$2 == "trace_hash" { hash = $3 } $2 == "port_writes" { writes = $3 }
    END { print hash, writes }' "$folder/stats.json")
echo "superframe render fig3: $expected"

# compile PROGRAM COMPILER OPTION...: two files of the firmware at a time.
compile() {
    program=$1
    shift
    rm -rf "$program.d" && mkdir -p "$program.d" || return 1
    printf '%s\n' "$folder/fig3.c" tests/trace_hash_matrix.c firmware/*.c |
        xargs -P 2 -I FILE sh -c 'file=$1 folder=$2; shift 2
            exec "$@" -std=c99 -Ifirmware/real/fx -Ifirmware/features/full -Ihal -Ifirmware \
                -c -o "$folder/$(basename "$file" .c).o" "$file"' \
            compile FILE "$program.d" "$@" || return 1
    "$@" -o "$program" "$program.d"/*.o
}

# variant COMPILER OPTION...
variant() {
    program=$folder/$(echo "$*" | tr -c 'a-zA-Z0-9\n' '_')
    if ! command -v "$1" > /dev/null 2>&1; then
        echo "skipped, $1 is not installed: $*"
        return
    fi
    if ! echo 'int main(void) { return 0; }' | "$@" -x c -o "$program.probe" - 2> /dev/null ||
        ! "$program.probe"; then
        echo "skipped, this machine can't build or run it: $*"
        return
    fi
    if ! compile "$program" "$@" 2> "$program.log"; then
        head -n 20 "$program.log" | cut -c 1-300
        echo "does not compile: $*"
        failures=$((failures + 1))
        return
    fi
    found=$(timeout -k 5 120 "$program")
    status=$?
    built=$((built + 1))
    if [ $status -ne 0 ] || [ "$found" != "$expected" ]; then
        echo "differs: $*: $found, exit status $status"
        failures=$((failures + 1))
    else
        echo "the same: $*"
    fi
}

variant gcc -O0
variant gcc -O2
variant gcc -O3
variant gcc -O2 -funsigned-char
variant gcc -O1 -fsanitize=undefined -fno-sanitize-recover=all
variant gcc -m32 -O2
variant gcc -m32 -O2 -march=i386 -mfpmath=387
variant clang -O2

[ $built -gt 0 ] || exit 2
[ $failures -eq 0 ]
