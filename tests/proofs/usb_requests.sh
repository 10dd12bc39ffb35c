#!/bin/sh
# SPDX-License-Identifier: MIT
# Has Frama-C's Eva run usb_requests.c where int has 16 bits, which no CPU of the tests' has.
#
# usb_requests.sh FOLDER, where the report goes. Exit status: 0 proved, 1 not.
set -eu

report=$1
here=$(dirname "$0")
mkdir -p "$report"
report=$report/usb_requests

timeout -k 5 120 frama-c -eva -eva-precision 5 -eva-auto-loop-unroll 256 -main ask_all \
    -machdep x86_16 -cpp-extra-args="-Ihal -Ihal/cable -Ifirmware/adapter" "$here/usb_requests.c" firmware/adapter/usb_device.c \
    firmware/adapter/usb_descriptors.c firmware/adapter/usb_adapter.c hal/cable/usb_ops.c hal/cable/usb_wire.c hal/bus.c \
    -then -report-csv "$report.csv" > "$report.txt" 2>&1 || {
    tail -n 20 "$report.txt" >&2
    echo "usb_requests: Frama-C could not read it; all it said: $report.txt" >&2
    exit 1
}
# Columns: folder, file, line, function, kind, status, property.
found=$(awk -F '\t' 'NR > 1 && $1 !~ /FRAMAC_SHARE/ && $6 !~ /^(Valid|Considered valid|Dead)/ {
    print $1 "/" $2 ":" $3 ": " $4 ": " $5 " is " tolower($6) ": " $7
}' "$report.csv")
if [ -n "$found" ]; then
    printf '%s\n' "$found"
    echo 'usb_requests: NOT proved: answers are whole where int has 16 bits'
    exit 1
fi
grep -q 'user assertion' "$report.csv" || {
    echo "usb_requests: the answers were not reached; see $report.txt" >&2
    exit 1
}
echo 'usb_requests: proved: answers are whole where int has 16 bits'
