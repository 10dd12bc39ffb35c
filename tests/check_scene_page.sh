#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the tables of docs/scene-format.md to `superframe scenes --keys`: check_scene_page.sh [--write]
#
# A table stands between "<!-- keys: TITLE -->" and "<!-- end of keys -->". --write puts the tables
# of today into the page. The examples that the page names are drawn. Exit status: 0 page and program agree,
# 1 they do not, or a table is on no page.
set -eu
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
SUPERFRAME=${SUPERFRAME:-$BUILD/superframe}
page=docs/scene-format.md
work=$BUILD/scene-page
mkdir -p "$work"

"$SUPERFRAME" scenes --keys > "$work/keys.md"
awk -v keys="$work/keys.md" '
BEGIN {
    while ((getline line < keys) > 0) {
        if (line ~ /^## /) {
            title = substr(line, 4)
            titles++
        } else if (line ~ /^\|/) {
            table[title] = table[title] line "\n"
        }
    }
}
/^<!-- keys: .* -->$/ {
    title = substr($0, 12, length($0) - 15)
    print
    printf "%s", table[title]
    shown += table[title] != ""
    inside = 1
}
/^<!-- end of keys -->$/ { inside = 0 }
!inside && !/^<!-- keys: / { print }
END {
    if (shown != titles || titles == 0) {
        print "check_scene_page: " titles " tables, " shown " of them in the page" > "/dev/stderr"
        exit 1
    }
}' "$page" > "$work/page.md"
if [ "${1:-}" = --write ]; then
    cp "$work/page.md" "$page"
elif ! diff -u "$page" "$work/page.md"; then
    echo "check_scene_page: $page is not what the program says; tests/check_scene_page.sh --write mends it" >&2
    exit 1
fi

# The scenes that the page shows: no ray leaks.
for scene in docs/examples/*.scene; do
    "$SUPERFRAME" render "$scene" --size 64x40 --arith f32 -o "$work/example.png" --stats "$work/example.json" \
        --quiet && grep -q '"leaked_rays": 0,' "$work/example.json" || {
        echo "check_scene_page: $scene: not drawn, or a ray leaked" >&2
        exit 1
    }
done
