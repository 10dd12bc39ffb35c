#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds predicted instructions against counted ones and writes the table into a page: check.sh BUILD PAGE
#
# The page's lines between "<!-- cost -->" and "<!-- end of cost -->" are replaced. The overhead of
# cost_codes was fitted to fig3 in one arithmetic of each target; no row here is one of those.
# Exit status: 0 none is off by more than half, 1 one is.
set -eu

build=$1
page=$2
work=$build/cost
mkdir -p "$work"
table=$work/table.md

rows='
m0 fx fig5 Cortex-M0
m0 fx fig4a Cortex-M0
m3 fx fig5 Cortex-M3
m3 f32 fig3 Cortex-M3
m4f f32 fig5 Cortex-M4F
i386 fx fig5 386
i386 fx fig4a 386
i387 f32 fig5 386 with 387
x86_64 fx fig5 x86-64
x86_64 f64 fig5 x86-64
'

{
    echo '| target | arithmetic | scene | predicted, 10⁶ | counted, 10⁶ | off by |'
    echo '|---|---|---|---|---|---|'
} > "$table"
echo "$rows" | while read -r code arithmetic scene label; do
    [ -n "$code" ] || continue
    sh tests/cost/whole.sh "$build/superframe" "$scene" 8x5 "$code" "$arithmetic" > "$work/counted.txt"
    counted=$(sed -n 's/.*instructions //p' "$work/counted.txt")
    predicted=$("$build/release/tests/cost/predict" "$scene" "$code" "$arithmetic" < "$work/counted.txt")
    awk -v counted="$counted" -v predicted="$predicted" -v cells="$label | $arithmetic | $scene" 'BEGIN {
        off = 100 * (predicted / counted - 1)
        printf "| %s | %.2f | %.2f | %+.0f %% |\n", cells, predicted / 1e6, counted / 1e6, off
        exit off > 50 || off < -50
    }' >> "$table" || echo "$label, $arithmetic, $scene: off by more than half" >&2
    tail -n 1 "$table"
done
[ "$(grep -c '^| [C3x]' "$table")" -eq "$(echo "$rows" | grep -c .)" ]

awk -v table="$table" '
/^<!-- cost -->$/ {
    print
    while ((getline line < table) > 0) {
        print line
    }
    inside = 1
    next
}
/^<!-- end of cost -->$/ { inside = 0 }
!inside { print }' "$page" > "$work/page.md"
cp "$work/page.md" "$page"
awk -F '|' '/%/ { if ($7 + 0 > 50 || $7 + 0 < -50) failed = 1 } END { exit failed }' "$table"
