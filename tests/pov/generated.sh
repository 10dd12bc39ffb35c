#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds generated scenes against POV-Ray: tests/pov/generated.sh BUILD SCENES
#
# Scenes are those of tests/relations/, from seed 0 on, until so many could be exported. Where there
# is no povray it says so and passes.
# Exit status: 0 all agree (or skipped), 1 not, 2 bad usage.
set -u

case ${2:-} in
'' | *[!0-9]*)
    echo 'usage: tests/pov/generated.sh BUILD SCENES; allowed is: a whole number' >&2
    exit 2
    ;;
esac
build=$1
wanted=$2
if ! command -v povray > /dev/null 2>&1; then
    echo 'pov: skipped: there is no povray (sh setup.sh pov)'
    exit 0
fi
out=$build/pov/generated
size=96x60
mkdir -p "$out"
# About one scene in twelve can be exported: docs/pov-export.md says what can't.
"$build/release/tests/relations/relations" "$out" "SEEDS=0:$((20 * wanted))" WRITE=yes > /dev/null || exit 1

seed=0
checked=0
failed=0
while [ $checked -lt "$wanted" ] && [ -f "$out/$seed.scene" ]; do
    scene=$out/$seed.scene
    seed=$((seed + 1))
    # A pattern's border in a face: POV-Ray takes noise for the cell there.
    grep -q 'origin = (0, 0, 0)' "$scene" && continue
    "$build/superframe" export "$scene" --pov --size $size --depth 6 --threshold 0 --colour full \
        -o "$out/scene.pov" > "$out/export.log" 2>&1 || continue
    checked=$((checked + 1))
    model=$(sed -n 's/.*model = "\([a-z]*\)".*/\1/p' "$scene")
    highlight=$(sed -n 's/.*highlight = "\([a-z]*\)".*/\1/p' "$scene")
    if ! timeout -k 10 60 povray "+I$out/scene.pov" "+O$out/scene.png" "+W${size%x*}" "+H${size#*x}" \
        -A -D -V +WT1 File_Gamma=1.0 < /dev/null > "$out/povray.log" 2>&1 ||
        ! "$build/release/tests/pov/pov_check" "$scene" $size 6 0 "$model" "$highlight" \
            "$out/scene.png" "$out/povray.log" > "$out/check.log" 2>&1; then
        failed=$((failed + 1))
        echo "$scene does not agree:"
        cat "$out/check.log"
    fi
done
echo "pov: $checked generated scenes checked of $seed, $failed do not agree"
[ $checked -eq "$wanted" ] && [ $failed -eq 0 ]
