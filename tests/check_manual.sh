#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the man pages to the program: each command stands in the synopsis, each option that a
# command's --help lists has an entry of its own, and no entry is about an option that is none.
#
# SUPERFRAME  the program (default: $BUILD/superframe). Exit status: 0 all are there, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
SUPERFRAME=${SUPERFRAME:-${BUILD:-build}/superframe}
page=docs/superframe.1
failures=0

complain() {
    echo "check_manual: $*"
    failures=$((failures + 1))
}

# The options that an entry begins with: the line behind a .TP, without roff's backslashes.
entries() {
    sed 's/\\-/-/g' "$@" | grep -A 1 '^\.TP' | grep '^\.B' |
        grep -o -- '--[a-z][a-z-]*[a-z]' | sort -u
}

commands=$("$SUPERFRAME" --help | sed -n 's/^  \([a-z]*\) .*/\1/p')
[ -n "$commands" ] || complain "$SUPERFRAME --help lists no command"
known=$(entries $page docs/superframe-trace.1)
all=
for command in $commands; do
    grep -q "^\.B superframe $command" $page || complain "$page: no synopsis of $command"
    options=$("$SUPERFRAME" "$command" --help | sed -n 's|^ *\(-., \)\{0,1\}\(--[a-z-]*\).*|\2|p')
    [ -n "$options" ] || complain "$command --help lists no option"
    all="$all $options"
    for option in $options; do
        printf '%s\n' "$known" | grep -q -x -e "$option" ||
            complain "$page: --help of $command lists $option, which has no entry"
    done
done
for option in $known; do
    case " $(echo $all) " in
    *" $option "*) ;;
    *) complain "man page: $option is no option of any command" ;;
    esac
done
[ $failures -eq 0 ]
