#!/bin/sh
# SPDX-License-Identifier: MIT
# Counts the instructions of a whole rendering on a target: whole.sh SUPERFRAME SCENE SIZE TARGET ARITHMETIC
#
# Prints them with the events of the same rendering on the host, of which cost_model predicts its
# own figure: the ratio is `whole` of cost_codes. Needs what instructions.sh needs.
set -eu
superframe=$1 scene=$2 size=$3 target=$4 arithmetic=$5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
. tests/cost/targets.sh
choose "$target"
"$superframe" compile "$scene" --size "$size" --colour full -o "$folder/scene.c"
symbol=$(sed -n 's/^const struct scene \([a-zA-Z0-9_]*\) = .*/\1/p' "$folder/scene.c")
# shellcheck disable=SC2086 # the compiler has options
$compiler -std=c99 -O2 -ffreestanding -fno-stack-protector -ffp-contract=off -Ifirmware/real/"$(real "$arithmetic")" \
    -Ifirmware/features/full -Ihal -Ifirmware -DIMAGE=image_"$arithmetic" -DSCENE="$symbol" -DHEIGHT="${size#*x}" \
    -nostdlib -static -Wl,-z,noexecstack -o "$folder/program" \
    "$folder/scene.c" tests/cost/whole_image.c tests/no_ports.c tests/cost/root.c firmware/*.c "$folder/$start.s" -lgcc
"$superframe" render "$scene" --size "$size" --colour full --arith "$arithmetic" --bus trace:/dev/null --stats - |
    sed -n 's/^ *"\(rays\|shadow_rays\|nodes\|solid_tests\)": \([0-9]*\),/\1 \2/p' | tr '\n' ' '
echo "$target $arithmetic $scene instructions $(count_instructions)"
