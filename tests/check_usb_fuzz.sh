#!/bin/sh
# SPDX-License-Identifier: MIT
# Fuzzes the packet decoders for a short time, from the kept corpus: check_usb_fuzz.sh [SECONDS]
#
# What it finds beyond the corpus stays in $BUILD/usb-fuzz and is taken up again. Exit status: 0
# nothing crashed, hung or left the sixteen ports, 1 something did, 2 it can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
folder=${BUILD:-build}/usb-fuzz
seconds=${1:-15}
mkdir -p "$folder/found" || exit 2
command -v clang > /dev/null 2>&1 || {
    echo 'check_usb_fuzz: clang is needed: it brings the fuzzer' >&2
    exit 2
}
clang -std=c99 -D_POSIX_C_SOURCE=200809L -g -O1 -fsanitize=fuzzer,address,undefined \
    -fno-sanitize-recover=all -Ihal -Ihal/usb -Iemulator -Ihost -o "$folder/usb_fuzz" \
    tests/fuzz/usb_fuzz.c emulator/usbip.c hal/bus.c hal/usb/*.c host/usb_bus.c \
    host/usb_session.c host/usb_verify.c || exit 2
"$folder/usb_fuzz" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len=8192 \
    -artifact_prefix="$folder/crash-" -print_final_stats=1 "$folder/found" \
    tests/fuzz/usb_corpus > "$folder/log" 2>&1
status=$?
tail -n 12 "$folder/log"
[ $status -eq 0 ]
