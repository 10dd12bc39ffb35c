#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds what `make amalgamation` writes as other emulators would, and draws fig3 through each build.
#
# usage: BUILD=build sh tests/check_amalgamation.sh
#
# Held are: the pair compiles as C99 and as C++17, by gcc and clang, and for 32 bits, without a warning;
# whatever the linker sees begins with superframe_; the C library's memory functions and strcmp() are all
# that is asked for; the picture is that of `superframe replay`; and a state saved in the middle of fig3 and
# restored in a fresh process gives the same picture, answers and last state. Then the glue of
# docs/examples/emulators is built and run in stand-ins of NP2kai, DOSBox-X and MAME.
# Exit status: 0 all holds, 1 something does not, 2 the program is not there.
set -u
cd "$(dirname "$0")/.." || exit 2
BUILD=$(cd "${BUILD:-build}" && pwd) || exit 2
superframe=$BUILD/superframe
pair=$BUILD/amalgamation
out=$BUILD/out/amalgamation
warnings='-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror'
failures=0

wrong() {
    echo "check_amalgamation: $*"
    failures=$((failures + 1))
}

[ -x "$superframe" ] || {
    echo "check_amalgamation: no program at $superframe: make" >&2
    exit 2
}
rm -rf "$pair" "$out"
mkdir -p "$out" || exit 2
make --no-print-directory -s amalgamation BUILD="$BUILD" SETUP=no || exit 1

# ---- fig3, and what the emulator makes of it ----

# A board whose answers count too: at every hundredth access, red and blue are read back.
"$superframe" render fig3 --bus trace:"$out/drawn.txt" > "$out/log" 2>&1 || wrong 'fig3 was not drawn'
awk '!/^#/ { print; if (++number % 100 == 0) print "in8 00D8 00\nin8 00DC 00" }' \
    "$out/drawn.txt" > "$out/fig3.txt"
"$superframe" replay "$out/fig3.txt" -o "$out/fig3.png" --stats "$out/stats.json" >> "$out/log" 2>&1
crc=$(sed -n 's/.*"frame_crc": "\([0-9a-f]*\)".*/\1/p' "$out/stats.json")
accesses=$(wc -l < "$out/fig3.txt")
middle=$((accesses / 2))
[ ${#crc} -eq 8 ] || wrong 'the emulator drew nothing'

# ---- The pair ----

# built NAME COMPILER...: builds the part, draws fig3 through it, and compares the picture.
built() {
    name=$1
    shift
    # shellcheck disable=SC2086 # words
    "$@" $warnings -I"$pair" -Itests/emulators -Itests/fixtures -o "$out/$name" "$pair/superframe_board.c" tests/emulators/part.c ||
        {
            wrong "$name: not built"
            return
        }
    "$out/$name" "$out/fig3.txt" 1 "$accesses" - "$out/$name.state" > "$out/$name.txt" 2> "$out/$name.crc"
    [ "$(cat "$out/$name.crc")" = "$crc" ] || wrong "$name: draws $(cat "$out/$name.crc"), the emulator $crc"
    cmp "$out/$name.state" "$out/gcc-c99.state" || wrong "$name: ends in another state"
}

built gcc-c99 gcc -std=c99 -O2
built clang-c99 clang -std=c99 -O1 -fsanitize=address,undefined -fno-sanitize-recover=all
if command -v g++ > /dev/null; then
    built gcc-c++17 g++ -x c++ -std=c++17 -O2
    built clang-c++17 clang++ -x c++ -std=c++17 -O1
else
    echo 'skipped without g++: the pair as C++17, and the glue for DOSBox-X and MAME'
fi
if echo 'int main(void) { return 0; }' | gcc -m32 -x c - -o "$out/32" 2> /dev/null; then
    built gcc-32-bits gcc -std=c99 -m32 -O2
else
    echo 'skipped without gcc-multilib: the pair for 32 bits'
fi

gcc -std=c99 -O2 -c -o "$out/board.o" "$pair/superframe_board.c"
for name in $(nm -g --defined-only "$out/board.o" | awk '{ print $NF }'); do
    grep -q "[ *]$name(.*" "$pair/superframe_board.h" || wrong "$name is shown to the linker, and not in the header"
    [ "$name" != "${name#superframe_}" ] || wrong "$name has no prefix"
done
wanted=$(nm -u "$out/board.o" | awk '$NF !~ /^(memcpy|memset|memcmp|strcmp|__stack_chk_fail|_GLOBAL_OFFSET_TABLE_)$/ { print $NF }')
[ -z "$wanted" ] || wrong "the part asks for $wanted"
# Without comments, constants and macros are words in capitals, and types follow struct or enum.
gcc -fpreprocessed -E -P "$pair/superframe_board.h" > "$out/names.txt"
hidden=$(grep -oE '\b([A-Z][A-Z0-9_]+|(struct|enum) +[a-z_]+)\b' "$out/names.txt" | sed 's/.* //' |
    grep -viE '^(superframe.*|ENTRY)$' | sort -u)
[ -z "$hidden" ] || wrong "the header shows names without the prefix: $hidden"

# ---- A state in the middle of fig3 ----

# Three processes: the whole, the first half, and the rest from the state of that half.
part=$out/clang-c99
"$part" "$out/fig3.txt" 1 "$middle" - "$out/half.state" > "$out/halves.txt" 2> "$out/half.crc"
"$part" "$out/fig3.txt" $((middle + 1)) "$accesses" "$out/half.state" "$out/rest.state" >> "$out/halves.txt" 2> "$out/rest.crc"
[ "$(cat "$out/half.crc")" != "$crc" ] || wrong 'half of fig3 is all of it'
[ "$(cat "$out/rest.crc")" = "$crc" ] || wrong "restored in the middle: draws $(cat "$out/rest.crc"), not $crc"
cmp "$out/halves.txt" "$out/gcc-c99.txt" || wrong 'restored in the middle: other answers'
cmp "$out/rest.state" "$out/gcc-c99.state" || wrong 'restored in the middle: another state at the end'
head -c 400000 "$out/half.state" > "$out/cut.state"
if "$part" "$out/fig3.txt" 1 1 "$out/cut.state" "$out/none.state" > /dev/null 2> "$out/cut.log"; then
    wrong 'half a state was taken'
fi
grep -q 'wrong length' "$out/cut.log" || wrong 'half a state is refused without the reason'

# ---- The glue, in stand-ins of three emulators ----

# glued EMULATOR COMPILER...: builds the glue into the stand-in, and plays fig3 through it. The part is
# compiled as C, so that C++ glue finds it by extern "C".
sanitized='-O1 -fsanitize=address,undefined -fno-sanitize-recover=all'
# shellcheck disable=SC2086 # words
gcc -std=c99 $sanitized -c -o "$out/part.o" "$pair/superframe_board.c" || wrong 'the part was not built'
glued() {
    emulator=$1
    shift
    # shellcheck disable=SC2086 # words
    if "$@" $warnings $sanitized -I"$pair" -Itests/emulators -Itests/fixtures -I"tests/emulators/$emulator" \
        -I"docs/examples/emulators/$emulator" -o "$out/$emulator" "docs/examples/emulators/$emulator"/*.c* \
        "tests/emulators/$emulator"/*.c* "$out/part.o"; then
        "$out/$emulator" "$out/drawn.txt" "$crc" || wrong "$emulator: the glue does not serve"
    else
        wrong "$emulator: the glue was not built"
    fi
}

glued np2kai gcc -std=c99
if command -v g++ > /dev/null; then
    glued dosbox-x g++ -std=c++17
    glued mame g++ -std=c++17
fi

rm -f "$out"/*.txt "$out"/*.state
echo "check_amalgamation: $failures wrong"
[ $failures -eq 0 ]
