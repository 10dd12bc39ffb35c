#!/bin/sh
# SPDX-License-Identifier: MIT
# Counts the instructions of the hot fixed-point operations, and lists the library calls they make.
#
# Usage: operation_cost.sh COMPILER [OPTION...], from the root of the tree; OBJDUMP and NM name the
# tools (llvm-objdump and llvm-nm read every target), REAL the folder of firmware/real/ (fx). Everything is inlined and all
# branches are counted; what the library's functions take comes on top.
set -eu
object=$(mktemp)
trap 'rm -f "$object"' EXIT
"$@" -std=c99 -ffreestanding '-Dinline=inline __attribute__((always_inline))' \
    -Ifirmware/real/"${REAL:-fx}" -c -o "$object" tests/real/operation_cost.c
"${OBJDUMP:-objdump}" -d --no-show-raw-insn "$object" |
    awk '/>:$/ { name = $2 } /^ *[0-9a-f]+:[ \t]/ { count[name]++ }
         END { for (name in count) if (name !~ /[$.]/) print count[name], name }' |
    tr -d '<>:' | sort -k 2
"${NM:-nm}" -u "$object" | sed 's/^ *U */calls /'
