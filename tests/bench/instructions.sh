#!/bin/sh
# SPDX-License-Identifier: MIT
# Instructions a ray, counted by callgrind: tests/bench/instructions.sh BUILD [check|keep] KEPT
#
# check  compares with the file KEPT: no scene may take more than 2 % above what is kept there
# keep   writes that file
#
# What is counted is all that a render does after the scene is loaded, and before the PNG. The
# program decides it alone, so that it is the same on a busy machine; compiler and libraries change it.
# Exit status: 0 done, 1 something has grown or a run failed, 2 bad usage.
set -u

PERCENT=2
usage() {
    echo 'usage: tests/bench/instructions.sh BUILD check|keep KEPT' >&2
    exit 2
}
[ $# -eq 3 ] || usage
build=$1 what=$2 kept=$3
case $what in check | keep) ;; *) usage ;; esac
[ "$what" = keep ] || [ -r "$kept" ] || {
    echo "bench: $kept cannot be read; make bench-instructions-keep writes it" >&2
    exit 2
}
superframe=$build/superframe
out=$build/bench
mkdir -p "$out" || exit 1

# scene | arithmetic | N | size | rows. A strip through the middle of the picture; two whole bands of
# rows where it is asked what a ray costs at other N.
table='
fig3|fx|10|320x200|98:102
fig3|f32|10|320x200|98:102
fig3|f64|10|320x200|98:102
fig4a|fx|10|320x200|98:102
fig4a|f64|10|320x200|98:102
fig5|fx|10|320x200|98:102
fig5|f64|10|320x200|98:102
fig7-isolated|fx|10|320x200|98:102
fig7-isolated|f64|10|320x200|98:102
figA|fx|10|320x200|98:102
figA|f64|10|320x200|98:102
fig3|f64|5|640x400|192:208
fig3|f64|20|640x400|192:208
fig4a|f64|5|640x400|192:208
fig4a|f64|20|640x400|192:208
fig5|f64|5|640x400|192:208
fig5|f64|20|640x400|192:208
'

# one SCENE ARITHMETIC N SIZE ROWS: prints rays and instructions.
one() {
    rm -f "$out/callgrind.out"
    valgrind --tool=callgrind --toggle-collect=render --callgrind-out-file="$out/callgrind.out" \
        "$superframe" render "$1" --arith "$2" --depth "$3" --size "$4" --rows "$5" --colour full \
        --quiet -o "$out/instructions.png" --stats "$out/instructions.json" \
        > "$out/callgrind.log" 2>&1 || {
        tail -n 5 "$out/callgrind.log" >&2
        return 1
    }
    rays=$(sed -n 's/^  "rays": \([0-9]*\),$/\1/p' "$out/instructions.json")
    instructions=$(sed -n 's/^totals: \([0-9]*\)$/\1/p' "$out/callgrind.out")
    if [ -z "$rays" ] || [ "${instructions:-0}" -eq 0 ]; then
        echo "bench: $1: callgrind has counted nothing: is there no function render()?" >&2
        return 1
    fi
    echo "$rays $instructions"
}

found=$out/instructions.txt
{
    echo '# Instructions a ray: make bench-instructions-keep writes this, make bench-check reads it.'
    echo "# $(head -n 1 "$build/flags" | cut -d ' ' -f 1) $(sh -c "$(cut -d ' ' -f 1 "$build/flags") -dumpfullversion") $(uname -m)"
    echo '# scene arithmetic N size rows rays instructions instructions_a_ray'
} > "$found" || exit 1
while IFS='|' read -r scene arithmetic depth size rows; do
    [ -n "$scene" ] || continue
    counts=$(one "$scene" "$arithmetic" "$depth" "$size" "$rows") || exit 1
    echo "$scene $arithmetic $depth $size $rows $counts" |
        awk '{ printf "%s %.2f\n", $0, $7 / $6 }' >> "$found"
done << TABLE
$table
TABLE

if [ "$what" = keep ]; then
    cp "$found" "$kept" && cat "$kept"
    exit
fi
awk -v percent=$PERCENT -v kept="$kept" -f "$(dirname "$0")/growth.awk" "$kept" "$found"
