#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks what every file must look like: its format, its licence line, its length.
# Exit status: 0 all do, 1 one does not.
set -u
cd "$(dirname "$0")/.." || exit 1
LINES_MOST=500
failures=0

wrong() {
    echo "$*"
    failures=$((failures + 1))
}

sources=$(find hal firmware emulator host tests docs/examples -name '*.[ch]' | sort)
others=$(find hal firmware emulator host tests -name '*.sh' | sort)
for file in $sources $others Makefile tests/*.mk setup.sh .ci/run; do
    head -n 3 "$file" | grep -q 'SPDX-License-Identifier: MIT' ||
        wrong "$file: no SPDX line among the first three"
    lines=$(wc -l < "$file")
    [ "$lines" -le $LINES_MOST ] || wrong "$file: $lines lines; allowed are $LINES_MOST"
done

if command -v clang-format > /dev/null 2>&1; then
    for file in $sources; do
        clang-format --dry-run -Werror "$file" > /dev/null 2>&1 ||
            wrong "$file: not as clang-format makes it: clang-format -i $file"
    done
else
    wrong 'clang-format is not there: sh setup.sh lint'
fi

echo "style: $failures wrong"
[ $failures -eq 0 ]
