#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves that no function of the firmware calls itself, at whatever remove: check_recursion.sh
#
# gcc writes down every call of a source file (-fcallgraph-info); with -O0 nothing is inlined, so
# the graph is the source's own. A call through a pointer could lead anywhere: only draw_rows() may
# make one (to the source of its rows, outside the image), and what tells an observer of the tree
# (outside the image too, and there on the host only).
# Exit status: 0 holds, 1 does not, 2 can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
# A compiler cache keeps objects, but not the graphs that are written beside them.
export CCACHE_DISABLE=1
folder=${BUILD:-build}/callgraph
failures=0

# check ARITHMETIC FEATURES
check() {
    rm -rf "${folder:?}/$1"
    mkdir -p "$folder/$1" || exit 2
    for source in firmware/*.c; do
        gcc -std=c99 -ffreestanding -O0 -fcallgraph-info -I"firmware/real/$1" \
            -Ifirmware/features/"$2" -Ihal -Ifirmware -c \
            -o "$folder/$1/$(basename "$source" .c).o" "$source" || exit 2
    done
    awk -v arithmetic="$1, $2" '
    function name_in(line, key) {
        sub(".*" key ": \"", "", line)
        sub(/".*/, "", line)
        return line
    }
    # path holds what is being visited.
    function visit(name, path, callees, count, i) {
        if (index(path, "|" name "|") > 0) {
            printf "%s: recursion: %s %s\n", arithmetic, path, name
            failures++
            return
        }
        if (name in done) {
            return
        }
        count = split(calls[name], callees, "\n")
        for (i = 1; i <= count; i++) {
            visit(callees[i], path "|" name "|")
        }
        done[name] = 1
    }
    /^node:/ && !/ellipse/ {
        functions[name_in($0, "title")] = 1
    }
    /^edge:/ {
        from = name_in($0, "sourcename")
        to = name_in($0, "targetname")
        if (to == "__indirect_call" && from !~ /(^|:)(draw_rows|report_end|visit|follow)$/) {
            printf "%s: %s calls through a pointer; that is for draw_rows and the observer\n",
                   arithmetic, from
            failures++
        }
        if (!((from, to) in seen)) {
            seen[from, to] = 1
            calls[from] = calls[from] (calls[from] == "" ? "" : "\n") to
            edges++
        }
    }
    END {
        for (name in functions) {
            count++
            visit(name, "")
        }
        printf "%s: %d functions, %d calls\n", arithmetic, count, edges
        exit failures > 0 || count == 0
    }' "$folder/$1"/*.ci || failures=1
}

if ! command -v gcc > /dev/null 2>&1; then
    echo 'check_recursion: gcc is needed: it is the compiler that writes call graphs' >&2
    exit 2
fi
check fx full
check f32 full
check f64 full
check f64 many
exit $failures
