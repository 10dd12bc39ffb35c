#!/bin/sh
# SPDX-License-Identifier: MIT
# Looks for each file that a page, a comment or a makefile names by its path; capitals stand for any name.
# Exit status: 0 all are there, 1 one is not.
set -u
cd "$(dirname "$0")/.." || exit 1
missing=0
for path in $(find README.md Makefile docs hal emulator firmware host tests -type f ! -path '*_corpus/*' \
    -exec grep -aohE '(^|[^A-Za-z0-9_/.-])(hal|emulator|firmware|host|tests|docs)/[a-z0-9_/.-]+\.(c|h|sh|mk|md|awk)\>' {} + |
    sed 's/^[^a-z]//' | sort -u); do
    [ -e "$path" ] || {
        echo "no such file: $path, in $(grep -rlF "$path" README.md Makefile docs hal emulator firmware host tests | head -n 3 | tr '\n' ' ')"
        missing=1
    }
done
exit $missing
