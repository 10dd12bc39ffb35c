#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles the firmware where int has 16 bits (gcc for AVR), and looks that nothing asks for a
# 64-bit division of a library. Nothing is run.
#
# An AVR's double has 32 bits, so that constants lose bits there: this is about types and
# promotions, not about pictures.
# Exit status: 0 it compiles and asks for nothing else, 1 not.
set -u
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
work=$BUILD/targets/avr
failures=0
# Every feature, with a stack of rays that such a machine has room for, in both forms of sets.
for form in full many; do
    mkdir -p "$work/$form/features"
    sed 's/FEATURE_DEPTH = [0-9]*/FEATURE_DEPTH = 10/; s/FEATURE_ACCURACY = [0-9]*/FEATURE_ACCURACY = 0/' \
        firmware/features/all.h > "$work/$form/features/all.h"
    sed 's/FEATURE_NESTING = [0-9]*/FEATURE_NESTING = 8/' \
        firmware/features/$form/feature_set.h > "$work/$form/feature_set.h"
done
for variant in full/fx full/fx_32 full/fx_16 many/fx_16; do
    form=${variant%/*} real=${variant#*/}
    for source in firmware/*.c; do
        object=$work/$(basename "$source" .c).o
        if ! avr-gcc -mmcu=atmega2560 -std=c99 -pedantic -Wall -Wextra -Werror -Os -ffreestanding \
            -Ifirmware/real/$real -I"$work/$form" -Ihal -Ifirmware -c -o "$object" "$source"; then
            failures=$((failures + 1))
            continue
        fi
        if avr-nm -u "$object" | grep -E '__(u?divdi3|u?moddi3|divmoddi4|udivmod64|divdi)'; then
            echo "$source, $variant: asks for a 64-bit division"
            failures=$((failures + 1))
        fi
    done
done
# The encoder for USB has a table of 43 KB, larger than an AVR's objects: an MSP430's may be.
for source in hal/*.c hal/cable/*.c firmware/adapter/*.c; do
    if [ "$source" = hal/cable/usb_encoder.c ]; then
        clang --target=msp430 -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror \
            -ffreestanding -Ihal -Ihal/cable -fsyntax-only "$source" || failures=$((failures + 1))
        continue
    fi
    avr-gcc -mmcu=atmega2560 -std=c99 -pedantic -Wall -Wextra -Werror \
        -Os -Ihal -Ihal/cable -Ifirmware/adapter -c -o "$work/hal.o" "$source" || failures=$((failures + 1))
done
echo "int of 16 bits: $failures wrong"
[ $failures -eq 0 ]
