#!/bin/sh
# SPDX-License-Identifier: MIT
# The board probe on both profiles of the emulated board: the answers of docs/probe.md's table, the
# summary made of them, the bars; and on a board that is absent, or broken.
#
# Exit status: 0 all hold, 1 one does not.
# shellcheck source=tests/targets/expect.sh
. "$(dirname "$0")/expect.sh"
work=$BUILD/targets/probe

sh firmware/targets/build_probe.sh "$work" || exit 1
image=$work/disk.hdm

# boot NAME OPTION...: what the screen says, in NAME.txt.
boot() {
    name=$1
    shift
    timeout 200 "$SUPERFRAME" boot "$image" "$@" > "$work/$name.txt" 2>&1 || wrong "boot $*: status $?"
}

# The table's answers of one profile as lines "number|name|answer|the other profile's answer".
answers() {
    awk -F ' *[|] *' -v column="$1" -v other="$2" '
        $2 ~ /^[0-9]+$/ && NF == 8 { print $2 "|" $3 "|" $column "|" $other }' docs/probe.md
}

# The summary that these answers make: marks, check.
summary() {
    awk -F '|' -v own="$1" '
    function number(text, i, value) {
        value = 0
        for (i = 1; i <= length(text); i++) {
            value = 16 * value + index("0123456789ABCDEF", substr(text, i, 1)) - 1
        }
        return value
    }
    { marks = marks ($3 == $4 ? "B" : own); check = (check + $1 * (number($3) % 65521)) % 65521 }
    END { printf "Summary: %s %04X\n", marks, check }'
}

# profile NAME COLUMN OTHER MARK
profile() {
    answers "$2" "$3" > "$work/$1.answers"
    [ "$(wc -l < "$work/$1.answers")" -eq 52 ] || wrong 'docs/probe.md: not 52 experiments'
    # The screen has three columns of 26.
    sed -n 's/^screen: //p' "$work/$1.txt" | awk '{
        for (i = 0; i < 3; i++) { cell = substr($0, 26 * i + 1, 26); sub(/ *$/, "", cell); print cell }
    }' > "$work/$1.cells"
    while IFS='|' read -r number name answer _; do
        expected=$(printf '%2d %-12s %s' "$number" "$name" "$answer")
        grep -qFx "$expected" "$work/$1.cells" || wrong "$1: not on the screen: $expected"
    done < "$work/$1.answers"
    grep -qFx "screen: $(summary "$4" < "$work/$1.answers")" "$work/$1.txt" ||
        wrong "$1: not on the screen: $(summary "$4" < "$work/$1.answers")"
    grep -q 'screen: Ended by Esc' "$work/$1.txt" || wrong "$1: not ended by Esc"
}

# What the bars must be, as a port trace of their definition.
bars() {
    awk 'BEGIN {
        split("FF FF 00 00 FF FF 00 00", red)
        split("FF FF FF FF 00 00 00 00", green)
        split("FF 00 FF 00 FF 00 FF 00", blue)
        for (y = 0; y < 400; y++) {
            printf "out16 00D6 %04X\n", y
            ramp = int((y - 200) / 50)
            for (x = 0; x < 640; x++) {
                bar = int(x / 80) + 1
                level = sprintf("%02X", int(x * 2 / 5))
                r = y < 200 ? red[bar] : (ramp == 0 || ramp == 3 ? level : "00")
                g = y < 200 ? green[bar] : (ramp == 1 || ramp == 3 ? level : "00")
                b = y < 200 ? blue[bar] : (ramp >= 2 ? level : "00")
                printf "out16 00D4 %04X\nout8 00D8 %s\nout8 00DA %s\nout8 00DC %s\n", x, r, g, b
            }
        }
    }' > "$work/bars.trace"
    "$SUPERFRAME" replay "$work/bars.trace" --picture memory -o "$work/bars.png" > /dev/null &&
        "$SUPERFRAME" compare "$work/bars.png" "$work/1987.png" --within 0 --share 100 > /dev/null ||
        wrong 'the picture is not that of the bars'
    rm -f "$work/bars.trace"
}

boot 1987 --escape 60 -o "$work/1987.png" &
boot later --profile later --escape 60
wait
profile 1987 6 7 1
profile later 7 6 L
bars

boot absent --faults absent
grep -q 'screen: No SuperFrame board answers at 00D0h' "$work/absent.txt" || wrong 'an absent board is not said'
boot early --escape 7
grep -q 'screen: Ended by Esc' "$work/early.txt" || wrong 'Esc does not end the experiments'
grep -q 'Summary' "$work/early.txt" && wrong 'a summary of experiments that were not made'
# Blue is gone: the memory test sees it at the first dot, and the summary says x for it.
boot dead --faults dead=00DC --escape 60
grep -q '19 memory test  FF000000' "$work/dead.txt" || wrong 'the memory test does not see that blue is dead'
grep -q 'Summary: .\{18\}x' "$work/dead.txt" || wrong 'the summary does not mark an unknown answer'

echo "probe: $failures wrong"
[ $failures -eq 0 ]
