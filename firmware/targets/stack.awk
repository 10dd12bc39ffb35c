# SPDX-License-Identifier: MIT
# The worst stack of an image, in bytes, from what gcc's -fcallgraph-info=su says.
#
#     awk -v entry=reset -v library=32 -v calls="frame_draw>firmware/image.c:image_draw" -f stack.awk *.ci
#
# `calls` names who is reached through a pointer: an edge to __indirect_call counts for nothing. A
# function without a figure (of the compiler's own library, of assembly) counts as `library` bytes.
# A cycle, or a frame of unknown size, ends in an error.

/^node:/ {
    match($0, /title: "[^"]*"/)
    node = (substr($0, RSTART + 8, RLENGTH - 9))
    if ($0 ~ /\(dynamic\)/) {
        print node ": a frame of unknown size" > "/dev/stderr"
        failed = 1
    }
    if (match($0, /[0-9]+ bytes/)) {
        frame[node] = substr($0, RSTART) + 0
    }
}
/^edge:/ {
    match($0, /sourcename: "[^"]*"/)
    source = (substr($0, RSTART + 13, RLENGTH - 14))
    match($0, /targetname: "[^"]*"/)
    target = (substr($0, RSTART + 13, RLENGTH - 14))
    if (target != "__indirect_call") {
        edges[source] = edges[source] " " target
    }
}

function depth(name, list, count, i, deepest, below) {
    if (name in known) {
        return known[name]
    }
    if (name in open) {
        print name ": calls itself" > "/dev/stderr"
        failed = 1
        return 0
    }
    open[name] = 1
    count = split(edges[name], list, " ")
    deepest = 0
    for (i = 1; i <= count; i++) {
        below = depth(list[i])
        if (below > deepest) {
            deepest = below
        }
    }
    delete open[name]
    known[name] = deepest + (name in frame ? frame[name] : library)
    return known[name]
}

END {
    count = split(calls, pairs, " ")
    for (i = 1; i <= count; i++) {
        split(pairs[i], pair, ">")
        edges[pair[1]] = edges[pair[1]] " " pair[2]
    }
    if (!(entry in frame)) {
        print entry ": no such function" > "/dev/stderr"
        failed = 1
    }
    worst = depth(entry)
    if (failed) {
        exit 1
    }
    print worst
}
