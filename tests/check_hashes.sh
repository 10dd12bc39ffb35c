#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the table of hashes on docs/targets.md to what `superframe render` reports.
#
# The hashes are no measure of what is right: a port has to reach them, and whoever changes one has
# to say why. Environment: BUILD, the build folder, with the program in it. Exit status: 0 all are
# as on the page, 1 one is not, 2 the table is not there.
set -u
cd "$(dirname "$0")/.." || exit 2
SUPERFRAME=${SUPERFRAME:-${BUILD:-build}/superframe}
folder=${BUILD:-build}/check-hashes
page=docs/targets.md
mkdir -p "$folder" || exit 2
sed -n '/^<!-- hashes -->/,/^<!-- end of hashes -->/p' $page | grep '^|' > "$folder/page"
[ "$(wc -l < "$folder/page")" -ge 2 ] || {
    echo "check_hashes: $page has no table of hashes" >&2
    exit 2
}

# The table's head names the options, its first column the scenes.
hash_of() {
    # shellcheck disable=SC2086 # options
    "$SUPERFRAME" render "$1" --size 160x100 $2 --stats "$folder/$1.stats" -o "$folder/$1.png" > /dev/null &&
        sed -n 's/^ *"trace_hash": "\([0-9a-f]*\)",$/\1/p' "$folder/$1.stats"
}

head -n 2 "$folder/page" > "$folder/found"
options=$(sed -n '1s/^| scene | *//p' "$folder/page" | tr -d '`' | sed 's/ *| */|/g; s/|$//')
for scene in $("$SUPERFRAME" scenes | cut -f 1); do
    row="| $scene |"
    IFS='|'
    for option in $options; do
        unset IFS
        row="$row \`$(hash_of "$scene" "$(echo "$option" | sed 's/^as it is$//')")\` |"
    done
    unset IFS
    printf '%s\n' "$row" >> "$folder/found"
done
diff -u "$folder/page" "$folder/found" || {
    echo "check_hashes: $page has other hashes; what was found is in $folder/found"
    exit 1
}
