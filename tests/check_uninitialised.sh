#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves of some scenes that an image reads no memory that it did not write: check_uninitialised.sh
#
# The training pass and the image's own rows run under clang's memory sanitizer, in each arithmetic
# below. Address and undefined-behaviour sanitizers, which the suites run under, do not see this.
# Environment: BUILD, the build folder, with the program in it.
# Exit status: 0 holds, 1 does not, 2 can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
build=${BUILD:-build}
folder=$build/uninitialised
superframe=$build/superframe
failures=0

COMPILE='clang -std=c99 -O1 -gline-tables-only -fsanitize=memory -fno-sanitize-recover=all
    -Ihal -Ifirmware'

# firmware ARITHMETIC FEATURES: compiles the firmware, two files at a time. check() takes it from then on.
firmware() {
    features=-Ifirmware/features/$2
    rm -rf "${folder:?}/$1"
    mkdir -p "$folder/$1" || exit 2
    # shellcheck disable=SC2086 # the compiler and its options are words
    printf '%s\n' firmware/*.c |
        xargs -P 2 -I FILE sh -c 'file=$1 folder=$2 arithmetic=$3; shift 3
            exec "$@" "-Ifirmware/real/$arithmetic" \
                -c -o "$folder/$arithmetic/$(basename "$file" .c).o" "$file"' \
            firmware FILE "$folder" "$1" $COMPILE "$features" || exit 2
}

# check ARITHMETIC SCENE OPTION...: the options are those of compile.
check() {
    arithmetic=$1
    scene=$2
    shift 2
    tables=$folder/$(basename "$scene" .scene).c
    "$superframe" compile "$scene" "$@" -o "$tables" || exit 2
    name=$(sed -n 's/^const struct scene \([a-zA-Z0-9_]*\).*/\1/p' "$tables")
    # shellcheck disable=SC2086 # the compiler and its options are words
    $COMPILE "$features" "-Ifirmware/real/$arithmetic" "-DSCENE=$name" "-DIMAGE=image_$arithmetic" \
        -o "$folder/image" tests/uninitialised_image.c "$tables" "$folder/$arithmetic"/*.o -lm ||
        exit 2
    if timeout -k 5 60 "$folder/image" > "$folder/log" 2>&1; then
        echo "$arithmetic $scene $*: $(cat "$folder/log")"
    else
        echo "$arithmetic $scene $*: exit status $?"
        head -n 20 "$folder/log" | cut -c 1-300
        failures=$((failures + 1))
    fi
}

firmware fx full
check fx fig3 --size 8x5
check fx fig3 --size 8x5 --tail estimate
check fx fig4a --size 8x5 --depth 40 --error 16
check fx fig5 --size 8x5 --error 4
check fx fig6a --size 8x5 --colour dither
check fx fig6b --size 8x5 --colour exposures
firmware f32 full
check f32 fig5 --size 8x5 --error 8
check f32 figA --size 8x5 --depth 20 --tail estimate
firmware f32 many
check f32 docs/examples/chandelier.scene --size 8x5
[ $failures -eq 0 ]
