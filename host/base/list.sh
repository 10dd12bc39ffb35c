#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a C file that lists what a build has of a kind: PREFIX_NAME for each name, each a struct PREFIX.
#
# usage: list.sh LIST HEADER PREFIX [NAME...]
#
# LIST_built has pointers to them, and NULL at the end. LIST_names, for a header that declares that list,
# has the names.
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
pointers= names=
for name in "$@"; do
    echo "extern const struct $prefix ${prefix}_$name;"
    pointers="$pointers&${prefix}_$name, "
    names="$names\"$name\", "
done
printf '\nconst struct %s *const %s_built[] = {%sNULL};\n' "$prefix" "$list" "$pointers"
if grep -q "${list}_names" "host/$header"; then
    echo "const char *const ${list}_names[] = {${names}NULL};"
fi
