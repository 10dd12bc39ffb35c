#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the examples against what `make install` put into a fresh prefix, and nothing else, and runs
# their tests; then breaks one and sees that the test kit says so.
#
# usage: BUILD=build sh tests/check_install.sh     (after `make fresh-prefix`)
# Exit status: 0 all holds, 1 something does not, 2 there is no fresh prefix.
set -u
cd "$(dirname "$0")/.." || exit 2

BUILD=$(cd "${BUILD:-build}" && pwd) || exit 2
prefix=$BUILD/prefix
out=$BUILD/examples
failures=0
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig" LD_LIBRARY_PATH="$prefix/lib"
CC=${CC:-gcc}
export CC

[ -f "$prefix/lib/pkgconfig/superframe.pc" ] || {
    echo "check_install: no fresh prefix at $prefix: make fresh-prefix" >&2
    exit 2
}
rm -rf "$out"
mkdir -p "$out" || exit 2

wrong() {
    echo "check_install: $*"
    failures=$((failures + 1))
}

# The examples are built in copies outside the project's folder: no header of it can be found.
place=$(mktemp -d) || exit 2
trap 'rm -rf "$place"' EXIT
cp -R docs/examples/. "$place" || exit 2

# Who sits at the machine may open an adapter: udev looks there for what is not Debian's.
grep -q 'ATTR{idVendor}=="1209".*TAG+="uaccess"' "$prefix/lib/udev/rules.d/70-superframe.rules" ||
    wrong 'the udev rule is not installed'

# Every header stands for itself, in C99.
for header in "$prefix"/include/superframe/*.h; do
    printf '#include <superframe/%s>\n' "$(basename "$header")" > "$place/alone.c"
    # shellcheck disable=SC2046 # words
    $CC -std=c99 -pedantic -Wall -Wextra -Werror $(pkg-config --cflags superframe) -fsyntax-only \
        "$place/alone.c" || wrong "$(basename "$header") cannot be included by itself"
done

for example in gradient viewer; do
    mkdir -p "$out/$example"
    make -C "$place/$example" OUT="$out/$example" "$out/$example/$example" test ||
        wrong "$example: not built, or its tests failed"
done

# What they show: the gradient as the viewer shows it is the gradient.
"$out/gradient/gradient" "$out/gradient.png" || wrong 'the gradient was not drawn'
"$out/viewer/viewer" "$out/gradient.png" "$out/again.png" || wrong 'the viewer failed'
cmp "$out/gradient.png" "$out/again.png" || wrong 'the viewer shows another picture'
"$out/viewer/viewer" "$place/gradient/main.c" "$out/none.png" 2> /dev/null &&
    wrong 'the viewer took a C file for a picture'

# The static library alone does as well.
# shellcheck disable=SC2046 # words
$CC -std=c99 $(pkg-config --cflags superframe) -o "$out/static" "$place/gradient/main.c" \
    "$place/gradient/gradient.c" "$prefix/lib/libsuperframe.a" -lpng -lxxhash -ldeflate &&
    env -u LD_LIBRARY_PATH "$out/static" "$out/static.png" &&
    cmp "$out/gradient.png" "$out/static.png" || wrong 'the static library does not serve'

# A broken gradient fails its tests, with a report and the two pictures.
sed -i 's/x \* 255 \/ 639/x * 255 \/ 640/' "$place/gradient/gradient.c"
mkdir -p "$out/broken"
if make -C "$place/gradient" OUT="$out/broken" test > "$out/broken.log" 2>&1; then
    wrong 'a broken gradient passed'
fi
grep -q 'expected FF0080, found FE0080' "$out/broken.log" || wrong 'the report does not say what'
grep -q '^the_first_and.*the writes differ' "$out/broken.log" || wrong 'the report lacks the writes'
for picture in expected found; do
    [ -s "$out/broken/the_corners_have_the_ends_of_the_gradient-$picture.png" ] ||
        wrong "no $picture picture"
done

# The command and the manual pages.
"$prefix/bin/superframe" --version || wrong 'the command does not run'
for page in man1/superframe.1 man1/superframe-trace.1 man3/superframe.3 man3/superframe-testing.3; do
    [ -s "$prefix/share/man/$page" ] || wrong "no $page"
done

# DESTDIR goes before the prefix, and into no file.
make --no-print-directory -s install BUILD="$BUILD" PREFIX=/opt/sf DESTDIR="$out/stage" ||
    wrong 'no install with DESTDIR'
[ -x "$out/stage/opt/sf/bin/superframe" ] || wrong 'DESTDIR was not taken'
grep -q '^prefix=/opt/sf$' "$out/stage/opt/sf/lib/pkgconfig/superframe.pc" ||
    wrong 'pkg-config does not get the prefix'

echo "check_install: $failures wrong"
[ $failures -eq 0 ]
