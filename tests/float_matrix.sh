#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the float images together whatever unit computes them: float_matrix.sh
#
# fig3 (320 x 200, depth level 10) is rendered by the f32 and f64 images as SSE code, as x87 code with
# and without excess precision, by clang, and with fused products. Against gcc -O2 with SSE all but 6
# of the 64,000 pixels (f32), or all (f64), have to be within 1 LSB. A variant that this machine can't
# build is skipped, and said to be. Environment: BUILD, the build folder, with the program in it.
# Exit status: 0 all agree, 1 one does not, 2 it can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
build=${BUILD:-build}
folder=$build/float-matrix
failures=0
compared=0
mkdir -p "$folder" || exit 2
"$build/superframe" compile fig3 -o "$folder/fig3.c" || exit 2

# render ARITHMETIC PICTURE COMPILER OPTION...: false if this machine can't.
render() {
    arithmetic=$1
    picture=$2
    shift 2
    command -v "$1" > /dev/null 2>&1 &&
        "$@" -std=c99 -Ifirmware/real/"$arithmetic" -Ifirmware/features/full -Ihal -Ifirmware \
            -o "$picture.program" tests/float_matrix.c tests/no_ports.c "$folder/fig3.c" firmware/*.c -lm \
            2> "$picture.log" || return 1
    timeout -k 5 120 "$picture.program" > "$picture" || {
        echo "fails: $arithmetic: $*"
        failures=$((failures + 1))
    }
}

# The pixels of two pictures that are more than 1 LSB apart; cmp gives the bytes in octal.
pixels_apart() {
    cmp -l "$1" "$2" | awk '
        function value(octal) {
            return int(octal / 100) * 64 + int(octal % 100 / 10) * 8 + octal % 10
        }
        {
            difference = value($2) - value($3)
            if (difference < -1 || difference > 1) {
                apart[int(($1 - 1) / 3)] = 1
            }
        }
        END { for (pixel in apart) count++; print count + 0 }'
}

# variant ARITHMETIC ALLOWED COMPILER OPTION...
variant() {
    arithmetic=$1
    allowed=$2
    shift 2
    picture=$folder/$arithmetic-$(echo "$*" | tr -c 'a-zA-Z0-9\n' '_')
    if ! render "$arithmetic" "$picture" "$@"; then
        echo "skipped, this machine can't build it: $arithmetic: $*"
        return
    fi
    if [ "$(wc -c < "$picture")" -ne 192000 ]; then
        echo "no picture: $arithmetic: $*"
        failures=$((failures + 1))
        return
    fi
    apart=$(pixels_apart "$folder/$arithmetic.reference" "$picture")
    echo "$arithmetic: $apart pixels are more than 1 LSB apart: $*"
    compared=$((compared + 1))
    [ "$apart" -le "$allowed" ] || failures=$((failures + 1))
}

for arithmetic in f32 f64; do
    allowed=$([ $arithmetic = f32 ] && echo 6 || echo 0)
    render $arithmetic "$folder/$arithmetic.reference" gcc -O2 -ffp-contract=off || exit 2
    variant $arithmetic "$allowed" gcc -O0 -ffp-contract=off
    variant $arithmetic "$allowed" gcc -O2 -m32 -mfpmath=387
    variant $arithmetic "$allowed" gcc -O2 -m32 -mfpmath=387 -fexcess-precision=fast
    variant $arithmetic "$allowed" gcc -O2 -m32 -msse2 -mfpmath=sse
    variant $arithmetic "$allowed" gcc -O2 -march=native -ffp-contract=fast
    variant $arithmetic "$allowed" clang -O2 -ffp-contract=off
done

[ $compared -gt 0 ] || exit 2
[ $failures -eq 0 ]
