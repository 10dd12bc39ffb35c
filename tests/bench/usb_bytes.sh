#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints docs/usb-bytes.md: what every built-in scene costs on the cable, in full colour and in the
# eight colours of the random dither. usb_bytes.sh SUPERFRAME USB_BYTES
set -eu
superframe=$1
usb_bytes=$2
trace=$(mktemp)
trap 'rm -f "$trace"' EXIT

cat << 'END'
# Bytes on the cable

What the picture of each built-in scene costs between host and adapter, with headers and CRCs; the
acknowledgements go the other way. A pixel is the board's, four port accesses; the paper's 320 x 200
rendered pixels are 2 x 2 of them. Seconds are the limits of the wire: bulk at full speed 1,216,000
bytes a second, at high speed 53,248,000; HID with a report of 63 bytes a frame (1 ms) or microframe
(125 us). Each scene in full colour, and in the 8 digital colours of the random dither where that goes:
each dithered pixel takes 2 x 2 dots, for which fig4a and fig4b at 640 x 400 have no room. Made by
`make usb-table`; `tests/check_usb_bytes.sh` holds fig3 to at most 3.2 bytes a pixel, and dithered ones
to 0.5.

| scene | pixels | bytes | bytes a pixel | bulk full speed, s | bulk high speed, s | HID full speed, s | HID high speed, s |
|---|---|---|---|---|---|---|---|
END
"$superframe" scenes | cut -f 1 | while read -r scene; do
    "$superframe" render "$scene" --quiet --colour full --bus trace:"$trace"
    "$usb_bytes" "$scene, full colour" "$trace"
    if "$superframe" render "$scene" --quiet --colour dither --bus trace:"$trace" 2> /dev/null; then
        "$usb_bytes" "$scene, dithered" "$trace"
    fi
done
"$superframe" render fig3 --quiet --size 640x400 --colour full --bus trace:"$trace"
"$usb_bytes" "fig3 at 640 x 400, full colour" "$trace"
