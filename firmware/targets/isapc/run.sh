#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs rom.bin of the current folder on QEMU's isapc with a 486; the port writes go to ports.trace.
#
# QEMU logs each write. The second DMA controller of that PC takes the board's ports in bytes, so
# that a word arrives as two writes; the image writes to odd ports in no other way. The image ends
# in HLT, which QEMU does not report: it is ended when it has taken next to no time for three seconds,
# or TARGET_TIMEOUT seconds (600) have gone by.
# Exit status: 0 the last dot was written and nothing after it, 1 not.
set -eu

rm -f log.fifo
mkfifo log.fifo
qemu-system-i386 -M isapc -cpu 486 -m 4 -nodefaults -display none -no-reboot -bios rom.bin \
    -trace memory_region_ops_write > log.fifo 2>&1 &
machine=$!
trap 'kill $machine 2> /dev/null || :; rm -f log.fifo' EXIT

# The CPU time of the machine so far, in ticks; "gone" once it has ended.
ticks() {
    sed 's/.*) //' "/proc/$machine/stat" 2> /dev/null | awk '{ print $12 + $13; n++ } END { if (!n) print "gone" }'
}

watch_machine() {
    before=-9
    idle=0
    for second in $(seq "${TARGET_TIMEOUT:-600}"); do
        sleep 1
        now=$(ticks)
        [ "$now" != gone ] || return 0
        idle=$((idle + 1))
        # A halted machine takes a tick now and then.
        [ $((now - before)) -le 1 ] || idle=0
        before=$now
        [ $idle -lt 3 ] || break
    done
    kill $machine 2> /dev/null || return 0
    # One that does not hear it is ended all the same: nobody waits for it without end.
    for second in 1 2 3 4 5; do
        sleep 1
        [ "$(ticks)" != gone ] || return 0
    done
    kill -9 $machine 2> /dev/null || :
}
watch_machine &

awk '
function flush_byte() {
    if (held != "") {
        printf "out8 %04X %02X\n", held, held_value
    }
    held = ""
}

# A number as QEMU prints it, 0x and lower-case digits.
function number(text, value, i) {
    value = 0
    for (i = 3; i <= length(text); i++) {
        value = 16 * value + index("0123456789abcdef", substr(text, i, 1)) - 1
    }
    return value
}

$1 != "memory_region_ops_write" || NR > 4000000 { next }
{
    port = number($7)
    if (port < 208 || port > 223) {
        next
    }
    value = number($9)
    if (port % 2 == 1 && held == port - 1) {
        printf "out16 %04X %04X\n", held, 256 * value + held_value
        register[held] = 256 * value + held_value
        held = ""
        next
    }
    flush_byte()
    held = port
    held_value = value
    if (ended) {
        late = 1
    }
    # Blue of dot (639, 399): nothing follows.
    if (port == 220 && register[212] == 639 && register[214] == 399) {
        ended = 1
        flush_byte()
    }
}
END {
    flush_byte()
    exit !ended || late
}' < log.fifo > ports.trace
