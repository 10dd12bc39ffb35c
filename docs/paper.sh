#!/bin/sh
# SPDX-License-Identifier: MIT
# Brings docs/paper.md and docs/figures/ up to date with what `superframe paper` made:
# sh docs/paper.sh FOLDER, after `superframe paper -o FOLDER` (make paper: build/paper).
set -eu

folder=${1:-build/paper}
cd "$(dirname "$0")/.."
[ -f "$folder/claims.md" ] && [ -f "$folder/fig7-rays.png" ] || {
    echo "docs/paper.sh: no claims.md and fig7-rays.png in $folder; make paper writes them there" >&2
    exit 2
}

for picture in "$folder"/fig*.png; do
    cp "$picture" docs/figures/
done
# The table stands between two comments.
awk -v table="$folder/claims.md" '
    /^<!-- claims: end -->/ { inside = 0 }
    !inside { print }
    /^<!-- claims: begin/ {
        inside = 1
        print ""
        while ((getline line < table) > 0) {
            print line
        }
        print ""
    }' docs/paper.md > docs/paper.md.new
mv docs/paper.md.new docs/paper.md
