#!/bin/sh
# SPDX-License-Identifier: MIT
# What `superframe boot` makes of the boot sectors of boot_sectors.s: the screen, the exit status, and
# the reason where a sector is refused.
#
# Exit status: 0 all as the table says, 1 one is not.
# shellcheck source=tests/targets/expect.sh
. "$(dirname "$0")/expect.sh"
work=$BUILD/targets/boot
sectors=0
rm -rf "$work"
mkdir -p "$work"

# put SECTOR TEXT: what a sector of the disk begins with.
put() {
    printf '%s' "$2" | dd of="$work/disk" bs=1024 seek="$1" conv=notrunc status=none
}

# assemble SOURCE BINARY OPTION...
assemble() {
    source=$1
    binary=$2
    shift 2
    ${CC:-gcc} -m16 -nostdlib -static -no-pie -Wl,--build-id=none -Wl,-T,firmware/targets/pc98/boot.ld \
        -Wl,--oformat=binary -Wl,-e,0 -o "$binary" "$@" "$source" || wrong "$source: not assembled"
}

# table FILE INSTRUCTIONS: boots each sector of a table, and looks at what comes of it. A whole line of the screen is
# expected by "screen:", a part of what is said otherwise. The common code and one sector of each name
# go to NAME.s; names and expectations to table.txt.
table() {
    awk -v work="$work" '
        /^#= / { sub(/^#= /, ""); print > (work "/table.txt"); file = work "/" $1 ".s"; printf "%s", common > file; next }
        file == "" { common = common $0 "\n"; next }
        { print > file }' "$1"
    while IFS='|' read -r name status text options; do
        name=${name% }
        text=$(printf '%s' "$text" | sed 's/^ *//; s/ *$//')
        assemble "$work/$name.s" "$work/$name.bin"
        cp "$work/disk" "$work/$name.hdm"
        dd if="$work/$name.bin" of="$work/$name.hdm" conv=notrunc status=none
        case $options in
        *protected*) chmod a-w "$work/$name.hdm" && options= ;;
        esac
        # shellcheck disable=SC2086 # a list of words, and a number behind blanks
        timeout 60 "$SUPERFRAME" boot "$work/$name.hdm" --instructions $2 -o "$work/$name.png" $options \
            > "$work/$name.txt" 2>&1
        found=$?
        # shellcheck disable=SC2086
        [ $found -eq $status ] || wrong "$name: exit status $found, not $status"
        case $text in
        screen:*) grep -qFx "$text" "$work/$name.txt" ;;
        *) grep -qF "$text" "$work/$name.txt" ;;
        esac || { wrong "$name: does not say: $text" && head -n 6 "$work/$name.txt"; }
        [ -e "$work/$name.png" ] && [ $found -ne 0 ] && wrong "$name: a run that failed has left a picture"
        [ -s "$work/$name.png" ] || [ $found -ne 0 ] || wrong "$name: a run to the end has left no picture"
        [ $found -eq 0 ] || grep -q 'eip' "$work/$name.txt" || wrong "$name: no registers"
        rm -f "$work/$name.hdm" "$work/$name.png"
        sectors=$((sectors + 1))
    done < "$work/table.txt"
    rm "$work/table.txt"
}

truncate -s 1261568 "$work/disk"
put 1231 LZ
put 16 A1
put 24 B1
table tests/targets/boot_sectors.s 20000000

# An image of one sector: IMAGE in the second line, and the letters that lie 7, 15, 17 and 18 sectors
# on, if they were read; and the boot sector that reads it.
cat > "$work/image.s" << 'end'
    .code16
    movw    $0xA000, %ax
    movw    %ax, %es
    pushw   %cs
    popw    %ds
    movb    $0, %ah
    movw    $text, %si
    movw    $160, %di
1:  lodsb
    stosb
    incw    %di
    testb   %al, %al
    jnz     1b
    subw    $2, %di
    movb    7 * 1024, %al
    stosw
    movb    15 * 1024, %al
    stosw
    movb    17 * 1024, %al
    stosw
    movb    18 * 1024, %al
    stosw
    cli
    hlt
text:
    .asciz  "IMAGE"
end
assemble "$work/image.s" "$work/image.bin"
assemble firmware/targets/pc98/boot.S "$work/loader.bin" -DIMAGE_SECTORS=1
dd if="$work/image.bin" of="$work/disk" bs=1024 seek=1 conv=notrunc status=none
dd if="$work/loader.bin" of="$work/disk" bs=1024 seek=2 conv=notrunc status=none
table tests/targets/boot_loader.s 300000

# An image that goes on on the other side and on the next cylinder: H, A and C are where those begin.
put 8 H1
put 18 C3
put 19 past
assemble firmware/targets/pc98/boot.S "$work/long.bin" -DIMAGE_SECTORS=18
dd if="$work/long.bin" of="$work/disk" conv=notrunc status=none
timeout 60 "$SUPERFRAME" boot "$work/disk" > "$work/long.txt" 2>&1 || wrong "a long image: status $?"
grep -qFx 'screen: IMAGEHAC' "$work/long.txt" || { wrong 'a long image is not where it should be' && cat "$work/long.txt"; }

# changed NAME SED TEXT: the boot sector, changed by sed, before its image: what the screen says.
changed() {
    cp "$work/disk" "$work/changed.hdm"
    LC_ALL=C sed "$2" "$work/loader.bin" > "$work/changed.bin"
    cmp -s "$work/loader.bin" "$work/changed.bin" && wrong "$1: the boot sector is as it was"
    dd if="$work/changed.bin" of="$work/changed.hdm" conv=notrunc status=none
    timeout 60 "$SUPERFRAME" boot "$work/changed.hdm" > "$work/changed.txt" 2>&1 || wrong "$1: status $?"
    grep -qFx "screen: superframe: the disk cannot be read: sector 0001, status $3" "$work/changed.txt" ||
        wrong "$1: status $3 is not said"
}

# What a disk refuses: another sector length in CH, no MFM, a buffer over 30000h, another drive.
changed CH 's/\xB5\x03/\xB5\x02/' C0
changed MFM 's/\xB4\x56/\xB4\x16/' E0
changed border 's/\xB8\x00\x20\x8E\xC0/\xB8\xE0\x2F\x8E\xC0/' 20
changed drive 's/\xA0\x84\x05/\xB0\x91\x90/' 60

# Before has_386 there are opcodes of the 8086 alone. Those of later CPUs begin with 0F or 60 to 6F, are
# C0, C1, C8, C9, or are more than the 8086 has of these.
end=$(${CC:-gcc} -m16 -c -DIMAGE_SECTORS=1 -o "$work/loader.o" firmware/targets/pc98/boot.S &&
    nm "$work/loader.o" | sed -n 's/^\([0-9a-f]*\) T has_386$/0x\1/p')
objdump -D -b binary -m i8086 --stop-address="$end" "$work/loader.bin" | awk -F '\t' '
    /\.byte|\(bad\)/ && !text { print; wrong = 1 }
    $3 ~ /^ret/ { text = 1 }                 # the message is behind it
    NF > 2 && !text { count++ }
    NF > 2 && !text && $2 ~ /^(0f|6[0-9a-f]|c0|c1|c8|c9|f1) / { print; wrong = 1 }
    END { exit wrong || count < 30 }' || wrong "opcodes before has_386 that an 8086 does not have"

# same FILE: what is expected comes by standard input.
same() {
    diff - "$1" > "$work/diff.txt" || { wrong "$1: not as expected" && head -n 9 "$work/diff.txt"; }
}

# disk NAME BYTES: a raw disk that begins with these bytes, given as for printf.
disk() {
    printf "$2" > "$work/$1"
    truncate -s 1261568 "$work/$1"
}

# Where a run went wrong: 0F FF is no opcode.
disk bad.hdm '\017\377'
expect 1 'an opcode that the CPU does not have; at 0001FC00h in real mode' "$SUPERFRAME" boot "$work/bad.hdm"
grep -q 'cs     00001FC0' "$work/said.txt" || wrong 'the registers are not where the run went wrong'
# lcall edi: on this the translator of Unicorn 2.0.1 aborts.
disk bad.hdm '\377\337'
expect 1 'at 0001FC00h in real mode' "$SUPERFRAME" boot "$work/bad.hdm"
# The stack at 1FC0:0400 grows down into the code: 0FFFh is pushed until it is run.
disk bad.hdm '\270\300\037\216\320\274\000\004\150\017\377\353\373'
expect 1 'an opcode that the CPU does not have' "$SUPERFRAME" boot "$work/bad.hdm"
# jmp A000:0000: the text screen, and then nothing.
disk bad.hdm '\352\000\000\000\240'
expect 1 'was run; nothing is there' "$SUPERFRAME" boot "$work/bad.hdm"

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

# Two predictions for an RA2 at 16 MHz, 4.4 and 5.7 clocks an instruction, each with its source: here 16
# million rounds of LOOP in ECX, and little else.
disk long.hdm '\372\146\271\000\044\364\000\147\342\375\364'
expect 0 '' "$SUPERFRAME" boot "$work/long.hdm" --stats "$work/stats.json"
for line in '"predicted_seconds_RA2": 4.4,' '"predicted_source_RA2": "4.4 clocks an instruction, assumed",' \
    '"predicted_seconds_RA2_NP2kai": 5.7,' "by NP2kai's table of the 386 on fig3"; do
    grep -qF "$line" "$work/stats.json" || wrong "--stats: not there: $line"
done

# mov ax, 1234h; 66 mov dx... : four bytes at D4 are two words, the low one first.
disk wide.hdm '\146\270\105\000\043\001\272\324\000\146\357\146\355\372\364'
expect 0 '' "$SUPERFRAME" boot "$work/wide.hdm" --trace "$work/trace.txt"
printf '%s\n' '# profile 1987, base 00D0' 'out16 00D4 0045' 'out16 00D6 0123' 'in16 00D4 FFFF' \
    'in16 00D6 FFFF' | same "$work/trace.txt"

# Files that are no disk to boot from.
printf 'T98FDDIMAGE.R0' > "$work/x.nfd"
expect 2 'x.nfd: an NFD image' "$SUPERFRAME" boot "$work/x.nfd" -o "$work/none.png"
expect 2 'cannot be read: No such file' "$SUPERFRAME" boot "$work/none.hdm" -o "$work/none.png"
printf 'no image' > "$work/x.hdm"
expect 2 'x.hdm: no 2HD image: less than 1261568 bytes' "$SUPERFRAME" boot "$work/x.hdm" -o "$work/none.png"
expect 2 'cannot be read: Is a directory' "$SUPERFRAME" boot "$work" -o "$work/none.png"
[ ! -e "$work/none.png" ] || wrong 'a file that is no disk has left a picture'

echo "boot: $sectors sectors, $failures wrong"
[ $failures -eq 0 ]
