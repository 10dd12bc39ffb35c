#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes the board as two files that another emulator takes over: superframe_board.h and superframe_board.c.
#
# usage: amalgamate.sh VERSION FOLDER
#
# Nothing is written by hand there. Names that the board shows begin with board_, BOARD_ or GRADE_; in the
# pair they begin with superframe_ or SUPERFRAME_, and struct board is struct superframe. What
# board_internal.h declares becomes static. The section "On a bus" and board_bus.c are left out.
set -eu

[ $# -eq 2 ] || {
    echo 'usage: amalgamate.sh VERSION FOLDER' >&2
    exit 2
}
version=$1 folder=$2
here=$(dirname "$0")
root=$here/../..
public="$root/hal/board_ports.h $here/board.h $here/board_screen.h $here/board_state.h"
private="$root/hal/splitmix64.h $here/board_controller.h $here/board_internal.h"
for file in "$here"/board*.c; do
    case $file in
    */board_bus.c) ;;
    *) private="$private $file" ;;
    esac
done
# What the internal header declares, other than as static.
internal=$(sed -n 's/^[a-z].*[ *]\(board_[a-z_]*\)(.*;$/\1/p' "$here/board_internal.h")

# Prints the text without what belongs to a file alone, with the names that the pair shows.
renamed() {
    awk -v internal="$internal" '
    BEGIN {
        count = split(internal, names)
        for (i = 1; i <= count; i++) {
            is_internal[names[i]] = 1
        }
    }
    function name_of(word, before) {
        if (word == "board" && before ~ /struct $/) {
            return "superframe"
        }
        if (word ~ /^board_/) {
            return "superframe_" substr(word, 7)
        }
        if (word ~ /^BOARD_/) {
            return "SUPERFRAME_" substr(word, 7)
        }
        return word ~ /^GRADE_/ ? "SUPERFRAME_" word : word
    }
    # A file has a name of its own; so has a program of a test.
    function is_file(rest) {
        return rest ~ /^\.(h|c|md)([^a-z]|$)/
    }
    FNR == 1 { is_left_out = 0 }
    /^\/\* ---- On a bus / { is_left_out = 1 }
    is_left_out || /^\/\* SPDX/ || /^#include/ || /^#(ifndef|define) SUPERFRAME_.*_H$/ || /^#endif$/ { next }
    /^$/ && is_empty { next }
    {
        is_empty = /^$/
        rest = $0
        line = ""
        if (match(rest, /^[a-z][a-z_0-9 *]*[ *]board_[a-z_]*\(/)) {
            word = substr(rest, 1, RLENGTH - 1)
            sub(/.*[ *]/, "", word)
            if (word in is_internal) {
                line = "static "
            }
        }
        while (match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
            word = substr(rest, RSTART, RLENGTH)
            line = line substr(rest, 1, RSTART - 1)
            rest = substr(rest, RSTART + RLENGTH)
            line = line (is_file(rest) ? word : name_of(word, line))
        }
        print line rest
    }' "$@"
}

# begin NAME WHAT: the head of one of the two.
begin() {
    echo '/* SPDX-License-Identifier: MIT */'
    echo "/* $1 of superframe $version: $2"
    echo ' * Made by emulator/board/amalgamate.sh. Change the sources of superframe instead.'
    echo ' *'
    sed 's/^/ * /; s/ *$//' "$root/LICENSE"
    echo ' */'
}

# includes FILE...: the headers of the C library that the files include.
includes() {
    sed -n 's/^#include <.*>$/&/p' "$@" | sort -u
    echo
}

mkdir -p "$folder"
# shellcheck disable=SC2086 # words
{
    begin superframe_board.h 'the PC-9801 SuperFrame board, as a part for emulators.'
    printf '#ifndef SUPERFRAME_BOARD_H\n#define SUPERFRAME_BOARD_H\n\n'
    includes $public
    printf '#ifdef __cplusplus\nextern "C" {\n#endif\n\n'
    renamed $public
    printf '\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n'
} > "$folder/superframe_board.h"
# shellcheck disable=SC2086 # words
{
    begin superframe_board.c 'compiles as C99 and as C++17, and needs string.h alone.'
    printf '#include "superframe_board.h"\n\n'
    includes $private
    renamed $private
} > "$folder/superframe_board.c"
