#!/bin/sh
# SPDX-License-Identifier: MIT
# Renders exported scenes with POV-Ray and holds its pictures and ray counts against superframe's:
# tests/pov/check.sh BUILD [SCENE...]
#
# Without a SCENE: all of the table below. POVRAY_TIMEOUT is the seconds that one picture may take
# (300). Where there is no povray it says so and passes.
# Exit status: 0 all agree (or skipped), 1 not, 2 bad usage.
set -u

[ $# -ge 1 ] || {
    echo 'usage: tests/pov/check.sh BUILD [SCENE...]' >&2
    exit 2
}
build=$1
shift
if ! command -v povray > /dev/null 2>&1; then
    echo 'pov: skipped: there is no povray (sh setup.sh pov)'
    exit 0
fi
superframe=$build/superframe
pov_check=$build/release/tests/pov/pov_check
out=$build/pov
mkdir -p "$out"

# scene | size | N | threshold | model | highlight. The built-in scenes as they are by default; then
# small pictures whose rays nothing but N ends.
table='
figA|320x200|10|1/4096|fresnel|phong
fig3|320x200|5|1/4096|fresnel|phong
fig3|320x200|10|1/4096|fresnel|phong
fig4a|640x400|15|1/4096|fresnel|phong
fig4b|640x400|10|1/4096|fresnel|phong
fig5|320x200|10|1/4096|fresnel|phong
fig6a|320x200|10|1/4096|fresnel|phong
fig6b|320x200|10|1/4096|fresnel|phong
fig7-isolated|320x200|10|1/4096|fresnel|phong
fig7-frustum|320x200|10|1/4096|fresnel|phong
tests/pov/solids.scene|320x200|8|1/65536|fresnel|phong
tests/pov/materials.scene|320x200|8|1/65536|fresnel|blinn
tests/pov/inside.scene|160x100|8|1/4096|fresnel|phong
tests/pov/gloss.scene|320x200|8|1/65536|fresnel|phong
tests/pov/gloss.scene|320x200|8|1/65536|fresnel|blinn
fig4b|320x200|10|1/4096|simple|phong
tests/pov/materials.scene|320x200|8|1/65536|simple|blinn
tests/pov/gloss.scene|320x200|8|1/65536|simple|phong
figA|64x40|10|0|fresnel|phong
fig3|64x40|10|0|fresnel|phong
fig4b|64x40|10|0|fresnel|phong
fig5|64x40|8|0|fresnel|phong
fig6a|64x40|10|0|fresnel|phong
fig6b|64x40|8|0|fresnel|phong
fig7-isolated|64x40|10|0|fresnel|phong
fig7-frustum|64x40|10|0|fresnel|phong
'

# one SCENE SIZE N THRESHOLD MODEL HIGHLIGHT
one() {
    name=$(basename "$1" .scene)-$2-$3-$5-$6
    echo "$1, $2, N = $3, threshold $4, $5, $6:"
    "$superframe" export "$1" --pov --size "$2" --depth "$3" --threshold "$4" --model "$5" \
        --highlight "$6" --colour full -o "$out/$name.pov" || return 1
    timeout -k 10 "${POVRAY_TIMEOUT:-300}" povray "+I$out/$name.pov" "+O$out/$name.png" \
        "+W${2%x*}" "+H${2#*x}" -A -D -V +WT1 File_Gamma=1.0 < /dev/null > "$out/$name.log" 2>&1 || {
        echo "  povray failed:"
        grep -v '^ *$' "$out/$name.log" | tail -n 12
        return 1
    }
    "$pov_check" "$1" "$2" "$3" "$4" "$5" "$6" "$out/$name.png" "$out/$name.log"
}

checked=0
failed=0
while IFS='|' read -r scene size depth threshold model highlight; do
    [ -n "$scene" ] || continue
    if [ $# -gt 0 ]; then
        case " $* " in
        *" $scene "*) ;;
        *) continue ;;
        esac
    fi
    checked=$((checked + 1))
    one "$scene" "$size" "$depth" "$threshold" "$model" "$highlight" || {
        failed=$((failed + 1))
        echo "  does not agree: $scene $size $depth $threshold $model $highlight"
    }
done <<TABLE
$table
TABLE

[ $checked -gt 0 ] || {
    echo "pov: none of $* is in the table" >&2
    exit 2
}
echo "pov: $checked checked, $failed do not agree"
[ $failed -eq 0 ]
