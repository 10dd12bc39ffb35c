#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures what an image with only what a scene requires saves, and writes it into a page: minimal.sh PAGE
#
# Every built-in scene, and each of which much is dead, is built for a Cortex-M0 in fx twice: with every
# feature and with its own. QEMU runs both. The page's lines between "<!-- minimal -->" and "<!-- end of minimal
# -->" are replaced. The full image's stack does not fit in 16 KiB: both are given 64 KiB and run
# on the machine of a Cortex-M3, which runs a Cortex-M0's instructions as they are.
# Exit status: 0 both images of each scene drew what the native program draws, and fig3's minimal
# image has at least 34 per cent fewer bytes of code; 1 not so, and the page is as it was.
set -eu

page=$1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
SIZE=80x50
export SUPERFRAME
here=$(dirname "$0")
work=$BUILD/targets/minimal
table=$work/table.md
mkdir -p "$work"

. "$here/image_bytes.sh"

# image SCENE FEATURES NAME: prints hash, code, constants, data, stack, instructions.
image() {
    folder=$work/$3-$2
    TARGET_RAM=65536 sh firmware/targets/build.sh cortex-m0 fx "$1" $SIZE - "$2" "$folder" >&2
    COUNT=$BUILD/targets/count.so sh "$here/run_target.sh" cortex-m3 "$folder" >&2
    echo "$(sh "$here/trace_hash.sh" "$folder") $(section "$folder/image.elf" .text .ARM.exidx)" \
        "$(section "$folder/image.elf" .rodata) $(section "$folder/image.elf" .bss .data)" \
        "$(sh firmware/targets/stack.sh cortex-m0 "$folder") $(cat "$folder/instructions.txt")"
    rm -f "$folder"/ports.*
}

native_hash() {
    "$SUPERFRAME" render "$1" --size $SIZE --quiet -o "$work/native.png" --stats - |
        sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p'
}

{
    echo '| scene | image | code | constants | data | stack | 10⁶ instructions | trace_hash |'
    echo '|---|---|---|---|---|---|---|---|'
} > "$table"
{
    "$SUPERFRAME" scenes | cut -f 1
    ls "$here"/dead_*.scene
} > "$work/scenes"
while read -r scene; do
    name=$(basename "$scene" .scene)
    echo "$name native $(native_hash "$scene")"
    for features in full minimal; do
        echo "$name $features $(image "$scene" $features "$name")"
    done
done < "$work/scenes" > "$work/measured"

# Columns: scene, image, hash, code, constants, data, stack, instructions.
awk '
function row(name, code, constants, data, stack, instructions, hash) {
    printf "| %s | %s | %s | %s | %s | %s | %s | %s |\n", $1, name, code, constants, data, stack, instructions, hash
}
function fewer(before, now) { return sprintf("%.0f %%", 100 - 100 * now / before) }
$2 == "native" { native = $3; scenes++; next }
$3 != native {
    print $1 ", " $2 " image: trace_hash " $3 "; the native one is " native > "/dev/stderr"
    failed = 1
}
{ row($2, $4, $5, $6, $7, sprintf("%.0f", $8 / 1e6), "`" $3 "`") }
$2 == "full" { for (i = 4; i <= 8; i++) full[i] = $i }
$2 == "minimal" {
    images++
    row("fewer", fewer(full[4], $4), fewer(full[5], $5), fewer(full[6], $6), fewer(full[7], $7),
        fewer(full[8], $8), "")
    if ($1 == "fig3" && $4 > 0.66 * full[4]) {
        print "fig3: " $4 " bytes of code instead of " full[4] ": less than 34 per cent fewer" > "/dev/stderr"
        failed = 1
    }
}
END { exit failed || images == 0 || images < scenes }' "$work/measured" >> "$table"

awk -v table="$table" '
/^<!-- minimal -->$/ {
    print
    while ((getline line < table) > 0) {
        print line
    }
    inside = 1
    next
}
/^<!-- end of minimal -->$/ { inside = 0 }
!inside { print }' "$page" > "$work/page.md"
cp "$work/page.md" "$page"
