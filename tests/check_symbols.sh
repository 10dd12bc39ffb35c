#!/bin/sh
# SPDX-License-Identifier: MIT
# Reads what the firmware's images ask of the outside: check_symbols.sh [IMAGE_OBJECT...]
#
# An image object is all of firmware/ in one arithmetic, linked with -r and nothing else; its name
# ends in _fx.o, _f32.o or _f64.o. By default those of $BUILD/release are read. Checked are:
# 1. the undefined symbols are the four ports, the square root in f32 and f64, and what a compiler
#    calls by itself for copies and 64-bit arithmetic: no libc, no heap, no stdio, no libm;
# 2. there is no writable data: .data and .bss are empty;
# 3. beside the objects, arithmetic_*.o and stream_engine_*.o show the symbol of their name only.
# Exit status: 0 all hold, 1 one does not.
set -u
cd "$(dirname "$0")/.." || exit 1
release=${BUILD:-build}/release
[ $# -gt 0 ] || set -- "$release/firmware_fx.o" "$release/firmware_f32.o" "$release/firmware_f64.o"

ports='outp outpw inp inpw'
# memcpy() and its kin are part of what gcc and clang expect even of a freestanding target; the
# others divide, multiply and shift 64 bits on a 32-bit one; the table is that of -fPIC on a 386.
compiler='memcpy memmove memset memcmp __divdi3 __moddi3 __divmoddi4 __udivdi3 __umoddi3
__udivmoddi4 __muldi3 __ashldi3 __ashrdi3 __lshrdi3 __clzsi2 __clzdi2 _GLOBAL_OFFSET_TABLE_'
failures=0

wrong() {
    echo "$*"
    failures=$((failures + 1))
}

for object in "$@"; do
    [ -f "$object" ] || {
        wrong "$object: is not there"
        continue
    }
    case $object in
    *_fx.o) allowed="$ports" ;;
    *_f32.o) allowed="$ports sqrtf" ;;
    *_f64.o) allowed="$ports sqrt" ;;
    *)
        wrong "$object: no known arithmetic; allowed is: a name that ends in _fx.o, _f32.o, _f64.o"
        continue
        ;;
    esac
    symbols=$(nm -u "$object" | awk '{ print $NF }')
    case " $(echo $symbols) " in
    *' outp '*) ;;
    *) wrong "$object: does not write to ports: not an image of the firmware" ;;
    esac
    for symbol in $symbols; do
        case " $allowed $(echo $compiler) " in
        *" $symbol "*) ;;
        *) wrong "$object: asks for $symbol; allowed are: $allowed" ;;
        esac
    done
    # Constants with addresses in them lie in .data.rel.ro: written by the loader, by nobody else.
    written=$(size -A "$object" |
        awk '/^\.(data|bss|tdata|tbss)/ && !/^\.data\.rel\.ro/ && $2 > 0 { print $1 " " $2 }')
    [ -z "$written" ] || wrong "$object: has writable data: $written bytes"
    echo "$object: $(echo $symbols)"
done

for joined in "$release"/arithmetic_*.o "$release"/stream_engine_*.o; do
    [ -f "$joined" ] || continue
    name=$(basename "$joined" .o)
    shown=$(nm -g --defined-only "$joined" | awk '{ print $NF }')
    [ "$shown" = "$name" ] || wrong "$joined: shows $(echo $shown); allowed is: $name alone"
done

[ $failures -eq 0 ]
