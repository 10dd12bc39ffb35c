#!/bin/sh
# SPDX-License-Identifier: MIT
# What `superframe boot` makes of the boot sectors of boot_sectors.s: the screen, the exit status, and
# the reason where a sector is refused.
#
# Exit status: 0 all as the table says, 1 one is not.
set -u
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
# Not the program under the sanitizers: the CPU is not what they look at, and takes its time.
SUPERFRAME=$BUILD/superframe
work=$BUILD/targets/boot
failures=0
rm -rf "$work"
mkdir -p "$work"

wrong() {
    echo "WRONG: $*"
    failures=$((failures + 1))
}

# put SECTOR TEXT: what a sector of the disk begins with.
put() {
    printf '%s' "$2" | dd of="$work/disk" bs=1024 seek="$1" conv=notrunc status=none
}

# The common code and one sector of each name, in NAME.s; names and expectations in table.txt.
awk -v work="$work" '
    /^#= / { sub(/^#= /, ""); print > (work "/table.txt"); file = work "/" $1 ".s"; printf "%s", common > file; next }
    file == "" { common = common $0 "\n"; next }
    { print > file }' tests/targets/boot_sectors.s

truncate -s 1261568 "$work/disk"
put 1231 LZ
put 16 A1
put 24 B1
while IFS='|' read -r name status text options; do
    name=${name% }
    text=$(printf '%s' "$text" | sed 's/^ *//; s/ *$//')
    ${CC:-gcc} -m16 -nostdlib -static -no-pie -Wl,--build-id=none -Wl,-T,firmware/targets/pc98/boot.ld \
        -Wl,--oformat=binary -Wl,-e,0 -o "$work/$name.bin" "$work/$name.s" || { wrong "$name: not assembled" && continue; }
    cp "$work/disk" "$work/$name.hdm"
    dd if="$work/$name.bin" of="$work/$name.hdm" conv=notrunc status=none
    case $options in
    *protected*) chmod a-w "$work/$name.hdm" && options= ;;
    esac
    # shellcheck disable=SC2086 # a list of words, and a number behind blanks
    timeout 60 "$SUPERFRAME" boot "$work/$name.hdm" --instructions 20000000 -o "$work/$name.png" $options \
        > "$work/$name.txt" 2>&1
    found=$?
    # shellcheck disable=SC2086
    [ $found -eq $status ] || wrong "$name: exit status $found, not $status"
    case $text in
    screen:*) [ "$(head -n 1 "$work/$name.txt")" = "$text" ] ;;
    *) grep -qF "$text" "$work/$name.txt" ;;
    esac || { wrong "$name: does not say: $text" && head -n 3 "$work/$name.txt"; }
    [ -e "$work/$name.png" ] && [ $found -ne 0 ] && wrong "$name: a run that failed has left a picture"
    [ $found -eq 0 ] || [ $found -eq 2 ] || grep -q 'eip' "$work/$name.txt" || wrong "$name: no registers"
    rm -f "$work/$name.hdm" "$work/$name.png"
done < "$work/table.txt"
# expect STATUS TEXT COMMAND...: the command ends so and says so.
expect() {
    status=$1
    text=$2
    shift 2
    timeout 60 "$@" > "$work/said.txt" 2>&1
    found=$?
    [ $found -eq "$status" ] || wrong "$*: exit status $found, not $status"
    [ -z "$text" ] || grep -qF "$text" "$work/said.txt" || wrong "$*: does not say: $text"
}

# same FILE: what is expected comes by standard input.
same() {
    diff - "$1" > "$work/diff.txt" || { wrong "$1: not as expected" && head -n 9 "$work/diff.txt"; }
}

# disk NAME BYTES: a raw disk that begins with these bytes, given as for printf.
disk() {
    printf "$2" > "$work/$1"
    truncate -s 1261568 "$work/$1"
}

# The screen in a file, with a secret cell and a coloured one: A blue, B secret.
disk screen.hdm '\270\000\240\216\300\046\306\006\000\000\101\046\306\006\000\040\041\046\306\006\002\000\102\046\306\006\002\040\340\372\364'
expect 0 'screen: A' "$SUPERFRAME" boot "$work/screen.hdm" --screen "$work/screen.txt"
{ echo A && yes '' | head -n 24 && echo 'row 0, columns 0-0: blue'; } | same "$work/screen.txt"
expect 1 'cannot be written' "$SUPERFRAME" boot "$work/screen.hdm" --screen "$work/none/screen.txt"
expect 2 'two results' "$SUPERFRAME" boot "$work/screen.hdm" --screen - --stats -

# cli; mov cx, 11; mov al, 0; out D9h, al; loop; hlt: a trace that ends before its run.
disk writes.hdm '\372\271\013\000\260\000\346\331\342\374\364'
expect 0 'trace.txt: the trace ends after 3 port accesses; the run goes on' \
    "$SUPERFRAME" boot "$work/writes.hdm" --trace "$work/trace.txt" --trace-accesses 3
printf '%s\n' '# profile 1987, base 00D0' 'out8 00D9 00' 'out8 00D9 00' 'out8 00D9 00' | same "$work/trace.txt"
expect 0 'black' "$SUPERFRAME" boot "$work/writes.hdm" --trace "$work/trace.txt" --trace-accesses 11 -o "$work/x.png"
[ "$(grep -c out8 "$work/trace.txt")" -eq 11 ] || wrong 'a trace as long as its limit is cut'
grep -q 'trace ends' "$work/said.txt" && wrong 'a trace as long as its limit is said to end'

# mov ax, 1234h; 66 mov dx... : four bytes at D4 are two words, the low one first.
disk wide.hdm '\146\270\105\000\043\001\272\324\000\146\357\146\355\372\364'
expect 0 '' "$SUPERFRAME" boot "$work/wide.hdm" --trace "$work/trace.txt"
printf '%s\n' '# profile 1987, base 00D0' 'out16 00D4 0045' 'out16 00D6 0123' 'in16 00D4 FFFF' \
    'in16 00D6 FFFF' | same "$work/trace.txt"

# Files that are no disk to boot from.
printf 'T98FDDIMAGE.R0' > "$work/x.nfd"
expect 2 'x.nfd: an NFD image' "$SUPERFRAME" boot "$work/x.nfd" -o "$work/none.png"
expect 2 'cannot be read: Is a directory' "$SUPERFRAME" boot "$work" -o "$work/none.png"
[ ! -e "$work/none.png" ] || wrong 'a file that is no disk has left a picture'

echo "boot: $(wc -l < "$work/table.txt") sectors, $failures wrong"
[ $failures -eq 0 ]
