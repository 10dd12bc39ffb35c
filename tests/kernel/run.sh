#!/bin/sh
# SPDX-License-Identifier: MIT
# Boots Debian's kernel in an emulated PC, plugs virtual adapters into it over the network, and draws
# on them there: run.sh FOLDER ADAPTER SUPERFRAME
#
# FOLDER      where initramfs.sh has put the guest; the log and the pictures go to FOLDER/log
# ADAPTER     the program whose `adapter` serves: the one under the sanitizers
# SUPERFRAME  the program whose own emulator the pictures behind the cables are held against
#
# Exit status: 0 all steps held and the pictures are the emulator's, 1 not.
set -u
folder=$1
adapter=$2
superframe=$3
log=$folder/log
began=$(date +%s)
servers=
names='BULK HID REPLUG-BULK REPLUG-HID PULLED'

# shellcheck disable=SC2086 # a list of numbers
stop_servers() {
    [ -z "$servers" ] || kill $servers 2> /dev/null
    wait
    servers=
}
trap stop_servers EXIT
trap 'exit 130' INT TERM

fail() {
    echo "test-kernel: $*"
    exit 1
}

start_server() {
    "$adapter" adapter --quiet --listen 127.0.0.1:0 --serial "$1" -o "$log/$1.png" > "$log/$1.txt" 2>&1 &
    servers="$servers $!"
}

# The port that the system has chosen is in the first line that a server prints.
wait_for_server() {
    for _ in $(seq 400); do
        port=$(sed -n 's/^listening on 127.0.0.1 port \([0-9]*\);.*/\1/p' "$log/$1.txt")
        [ -z "$port" ] || break
        sleep 0.05
    done
    [ -n "$port" ] || fail "the virtual adapter $1 does not listen: $(cat "$log/$1.txt")"
    ports="$ports PORT_$(echo "$1" | tr - _)=$port"
}

rm -rf "$log"
mkdir -p "$log" || exit 1
ports=
for name in $names; do
    : > "$log/$name.txt"
    start_server "$name"
done
for name in $names; do
    wait_for_server "$name"
done

# The kernel hands words of its command line that it does not know to the first process. It takes a
# timer that a busy host keeps waiting for a broken one, and panics, unless it is told not to look.
timeout -k 5 600 qemu-system-x86_64 -accel tcg -m 512 -nodefaults -no-user-config -display none \
    -no-reboot -kernel "$folder/kernel" -initrd "$folder/initramfs" \
    -append "console=ttyS0 quiet panic=-1 no_timer_check$ports" -serial "file:$log/guest.txt" \
    -netdev user,id=net,restrict=off -device e1000,netdev=net,romfile= > "$log/qemu.txt" 2>&1 < /dev/null
status=$?
stop_servers

[ $status -eq 0 ] || fail "the emulated PC ended with $status: $(tail -n 5 "$log/qemu.txt" "$log/guest.txt")"
cut -c 1-300 "$log/guest.txt" | tr -d '\r' | grep -E '^(guest:|ok |not ok |    )'
grep -q '^guest: done' "$log/guest.txt" || fail "the guest did not come to its end: $(tail -n 20 "$log/guest.txt")"
grep -q '^guest: done, 0 steps failed' "$log/guest.txt" || fail "not all steps held, see $log/guest.txt"

# hold NAME WORDS...: the picture behind a cable is the one that the emulator draws by itself.
hold() {
    name=$1
    shift
    "$superframe" render fig3 --quiet -o "$log/expected-$name.png" "$@" &&
        cmp "$log/$name.png" "$log/expected-$name.png" || fail "$name: the picture is another one"
    echo "ok - the picture behind $name is the emulator's"
}
hold BULK
hold HID
hold REPLUG-BULK --depth 2 --colour dither
hold REPLUG-HID --depth 2
hold PULLED --depth 2 --colour dither
for name in $names; do
    [ "$(wc -l < "$log/$name.txt")" -eq 1 ] || fail "$name complains: $(head -n 20 "$log/$name.txt")"
done
echo "test-kernel: all held, $(($(date +%s) - began)) s"
