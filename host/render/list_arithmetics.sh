#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a C file that lists the arithmetics of a build: list_arithmetics.sh NAME... [-- MISSING...]
set -eu

[ $# -gt 0 ] && [ "$1" != -- ] || {
    echo 'list_arithmetics.sh: no arithmetic given: at least one is needed' >&2
    exit 2
}
echo '/* Made by host/render/list_arithmetics.sh. */'
echo '#include "render/arithmetic.h"'
echo
names= last=
list='const struct arithmetic *const arithmetics_built[] = {'
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    echo "extern const struct arithmetic arithmetic_$1;"
    list="$list&arithmetic_$1, "
    [ -z "$last" ] || names="$names${names:+, }$last"
    last=$1
    shift
done
[ $# -eq 0 ] || shift
printf '\n%sNULL};\n' "$list"
echo "const char arithmetic_names[] = \"$names${names:+ or }$last\";"
printf 'const char *const arithmetics_missing[] = {'
[ $# -eq 0 ] || printf '"%s", ' "$@"
echo 'NULL};'
