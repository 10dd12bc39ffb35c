#!/bin/sh
# SPDX-License-Identifier: MIT
# Counts the instructions that each kind of operation takes on a target: instructions.sh TARGET...
#
# TARGET is one of m0 m3 m4f i386 i387 x86_64. Each operation is run twice, 20 and 60 times, by qemu
# one instruction at a time; the difference, less that of the empty loop, is what it takes. Prints
# the columns `instructions` of cost_codes, host/stats/cost_tables.c. Run from the root of the tree; needs qemu-user and the
# target's compiler (gcc-arm-none-eabi, gcc-multilib).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
kinds='ADD TEST PRODUCT DOT SLOPE OVER ROOT QUOTIENT NORMALISE REFRACT POWER TRANSMIT CELL'

. tests/cost/targets.sh

# instructions ARITHMETIC KIND ROUNDS: all that the program takes.
instructions() {
    # shellcheck disable=SC2086 # the compiler has options
    $compiler -std=c99 -O2 -ffreestanding -fno-stack-protector -ffp-contract=off -Ifirmware/real/"$(real "$1")" -Ifirmware \
        -DKIND="WRAP_$2" -DROUNDS="$3" -nostdlib -static -Wl,-z,noexecstack -o "$folder/program" \
        tests/cost/one_operation.c tests/cost/root.c "$folder/$start.s" -lgcc
    count_instructions
}

# forty ARITHMETIC KIND: what 40 of them take.
forty() {
    echo $(($(instructions "$1" "$2" 60) - $(instructions "$1" "$2" 20)))
}

for target in "$@"; do
    choose "$target"
    case $target in
    i386) arithmetics=fx ;;
    i387) arithmetics='f32 f64' ;;
    *) arithmetics='fx f32 f64' ;;
    esac
    for arithmetic in $arithmetics; do
        empty=$(forty "$arithmetic" KINDS)
        printf '    {"%s", "%s", {' "$target" "$arithmetic"
        separator=
        for kind in $kinds; do
            printf '%s%s' "$separator" "$(forty "$arithmetic" "$kind" | awk -v empty="$empty" \
                '{ difference = ($1 - empty) / 40; printf "%.1f", (difference > 0 ? difference : 0) }')"
            separator=', '
        done
        printf '}},\n'
    done
done
