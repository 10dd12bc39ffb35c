#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles the code of docs/porting.md's bare 386 for that processor and looks at what became of it:
# each function has exactly its one instruction.
#
# Exit status: 0 it does, 1 it does not, 2 the code was not found.
set -u
cd "$(dirname "$0")/.." || exit 2

BUILD=${BUILD:-build}
work=$BUILD/porting
mkdir -p "$work" || exit 2

# The first block of indented lines that includes outp.h.
awk '/^    #include "outp.h"/ { on = 1 } on && /^[^ ]/ { exit } on { sub(/^    /, ""); print }' \
    docs/porting.md > "$work/outp_386.c"
grep -q '^uint16_t inpw' "$work/outp_386.c" || {
    echo 'check_porting: docs/porting.md has no code for the 386' >&2
    exit 2
}
gcc -std=gnu99 -Wall -Wextra -Wconversion -Werror -m32 -march=i386 -Os -ffreestanding -fno-pic \
    -fcf-protection=none -Ihal -S -o "$work/outp_386.s" "$work/outp_386.c" || exit 1

wrong=0
for pair in outp:outb outpw:outw inp:inb inpw:inw; do
    function=${pair%:*}
    found=$(awk -v name="$function:" '$1 == name { on = 1 } on && $1 == "ret" { exit }
        on && $1 ~ /^(in|out)[bwl]$/ { print $1 }' "$work/outp_386.s" | tr '\n' ' ')
    if [ "$found" != "${pair#*:} " ]; then
        echo "check_porting: $function has \"$found\" instead of ${pair#*:}"
        wrong=$((wrong + 1))
    fi
done
echo "check_porting: $wrong wrong"
[ $wrong -eq 0 ]
