#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes a plain-text port trace of a target's records: records.sh PORTS.bin > TRACE.txt
#
# A record is five bytes: port, width in bytes, value, little-endian. A file that ends inside a
# record fails. Exit status: 0 done, 1 no file of records.
set -u
size=$(wc -c < "$1") || exit 1
[ "$size" -gt 0 ] && [ $((size % 5)) -eq 0 ] || {
    echo "$1: $size bytes are no whole number of records" >&2
    exit 1
}
od -An -v -tu1 -w5 "$1" | awk '
    $3 == 1 { printf "out8 %02X%02X %02X\n", $2, $1, $4; next }
    $3 == 2 { printf "out16 %02X%02X %02X%02X\n", $2, $1, $5, $4; next }
    { print "not a width: " $3 > "/dev/stderr"; failed = 1; exit }
    END { exit failed }'
