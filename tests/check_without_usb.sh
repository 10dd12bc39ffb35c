#!/bin/sh
# SPDX-License-Identifier: MIT
# Without libusb and hidapi the program is built all the same: it draws, and says of --bus usb and hid
# what is missing.
#
# $BUILD/superframe_without is made by make. Exit status: 0 it holds, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
program=$BUILD/superframe_without
out=$BUILD/without-usb.txt

# refuse TEXT WORDS...: exit status 1, and the text is said.
refuse() {
    text=$1
    shift
    "$program" "$@" > "$out" 2>&1
    status=$?
    if [ $status -ne 1 ] || ! grep -q -e "$text" "$out"; then
        echo "check_without_usb: $*: exit status $status, expected 1 and \"$text\":"
        cat "$out"
        exit 1
    fi
}

refuse '--bus usb: built without libusb-1.0; install its headers (libusb-1.0-0-dev)' \
    render fig3 --bus usb --wait
refuse '--bus hid: built without hidapi; install its headers (libhidapi-dev)' render fig3 --bus hid
refuse 'usb: built without libusb-1.0' devices
refuse 'hid: built without hidapi' devices
"$program" render fig3 --size 8x8 -o /dev/null --quiet
