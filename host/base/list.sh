#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a C file that lists what a build has of a kind: PREFIX_NAME for each name, each a struct PREFIX.
#
# usage: list.sh LIST HEADER PREFIX [NAME...]
#
# LIST_built has pointers to them, and NULL at the end. LIST_names has the names as messages put them:
# "a, b or c".
set -eu

[ $# -ge 3 ] || {
    echo 'usage: list.sh LIST HEADER PREFIX [NAME...]' >&2
    exit 2
}
list=$1 header=$2 prefix=$3
shift 3
echo '/* Made by host/base/list.sh. */'
echo "#include \"$header\""
echo
pointers= names= last=
for name in "$@"; do
    echo "extern const struct $prefix ${prefix}_$name;"
    pointers="$pointers&${prefix}_$name, "
    [ -z "$last" ] || names="$names${names:+, }$last"
    last=$name
done
printf '\nconst struct %s *const %s_built[] = {%sNULL};\n' "$prefix" "$list" "$pointers"
echo "extern const char ${list}_names[];"
echo "const char ${list}_names[] = \"$names${names:+ or }$last\";"
