#!/bin/sh
# SPDX-License-Identifier: MIT
# Proves from the #include lines who includes whom: docs/design.md's table of folders.
#
# A header in quotes must lie in the file's own folder or in one that the folder may include; a
# header in brackets must be none of the project's, and in firmware/ one of the freestanding ones.
# Exit status: 0 all hold, 1 one does not, 2 nothing was found to check.
set -u
cd "$(dirname "$0")/.." || exit 2

BUILD=${BUILD:-build}
mkdir -p "$BUILD"
find hal firmware emulator host -name '*.[ch]' | sort > "$BUILD/include-files.txt"
[ -s "$BUILD/include-files.txt" ] || {
    echo 'check_includes: no source files found' >&2
    exit 2
}

# shellcheck disable=SC2046 # names without blanks
awk -v list="$BUILD/include-files.txt" '
# The rule that a folder falls under: its longest prefix here.
BEGIN {
    may["hal"] = "hal hal/*"
    may["firmware"] = "firmware hal firmware/real/* firmware/features/* firmware/sets/*"
    may["firmware/real"] = "firmware/real"
    may["firmware/real/lab"] = "firmware/real/lab firmware/real"
    may["firmware/features"] = "firmware/features hal firmware firmware/sets/*"
    may["firmware/adapter"] = "firmware/adapter hal hal/*"
    # The ports for other CPUs lie around the firmware; the module for a web page holds the board too.
    may["firmware/targets"] = "firmware/targets/* firmware hal firmware/real/* firmware/features/*"
    may["firmware/targets/wasm"] = "firmware/targets/wasm emulator/board " may["firmware/targets"]
    may["emulator"] = "emulator/* hal hal/*"
    # The folders of host/: each may include what stands before it.
    count = split("base scene compiler validate picture render stream board adapter boot stats trace " \
        "export options lab command", order, " ")
    outside = "hal hal/* emulator/* firmware firmware/adapter"
    for (i = 1; i <= count; i++) {
        before = before " host/" order[i]
        may["host/" order[i]] = outside before
    }
    # Compiled beside the firmware, once for each arithmetic.
    may["host/render/per_arithmetic"] = may["host/render"] " host/render/per_arithmetic host/render/sets/* firmware/real/* firmware/features/* firmware/sets/*"
    may["host/render/sets"] = may["host/render/per_arithmetic"]
    may["host/stream"] = may["host/stream"] " host/stream/* host/stream/sets/* firmware/real/* firmware/features/* firmware/sets/*"
    # What the rest of host/ may see of the firmware.
    is_public["firmware/image.h"] = is_public["firmware/scene_constants.h"] = is_public["firmware/scene_fields.h"] = 1
    sees_private["host/render/per_arithmetic"] = sees_private["host/render/sets"] = sees_private["host/stream"] = 1
    freestanding = " float.h iso646.h limits.h stdarg.h stdbool.h stddef.h stdint.h "
    while ((getline file < list) > 0) {
        is_ours[file] = 1
        name = file
        sub(/.*\//, "", name)
        # Stand-ins for a C library that a target does not have.
        if (file !~ /^firmware\/targets\/[^\/]*\/include\//) {
            is_our_name[name] = 1
        }
    }
}

function folder_of(path) {
    sub(/\/[^\/]*$/, "", path)
    return path
}

function rule_of(folder) {
    while (!(folder in may) && folder ~ /\//) {
        folder = folder_of(folder)
    }
    return folder
}

function without_dots(path) {
    while (path ~ /[^\/.]+\/\.\.\//) {
        sub(/[^\/.]+\/\.\.\//, "", path)
    }
    return path
}

# The place of a header that FILENAME names, among the folders it may include; "" if none.
function place_of(name, folders, count, i, file, pattern) {
    file = without_dots(folder_of(FILENAME) "/" name)
    if (file in is_ours) {
        return file
    }
    # In host/ a header is called by its folder.
    if (FILENAME ~ /^host\// && ("host/" name) in is_ours) {
        return "host/" name
    }
    count = split(may[rule_of(folder_of(FILENAME))], folders, " ")
    for (i = 1; i <= count; i++) {
        if (folders[i] !~ /\*$/) {
            if ((folders[i] "/" name) in is_ours) {
                return folders[i] "/" name
            }
            continue
        }
        pattern = "^" substr(folders[i], 1, length(folders[i]) - 1) "[^/]+/" name "$"
        for (file in is_ours) {
            if (file ~ pattern) {
                return file
            }
        }
    }
    return ""
}

# Whether the folder that a place lies in is one that FILENAME may include.
function is_allowed(place, own, folders, count, i, folder) {
    own = rule_of(folder_of(FILENAME))
    folder = folder_of(place)
    count = split(may[own], folders, " ")
    for (i = 1; i <= count; i++) {
        sub(/\/\*$/, "", folders[i])
        if (folder == folders[i] || (rule_of(folder) == folders[i])) {
            return 1
        }
    }
    return 0
}

function wrong(text) {
    printf "%s:%d: %s\n", FILENAME, FNR, text
    failures++
}

/^[ \t]*#[ \t]*include/ {
    lines++
    own = rule_of(folder_of(FILENAME))
    name = $0
    # A feature set chooses the form of sets, and so the walk.
    sub(/SETS_WALK$/, "\"sets/bits/walk.h\"", name)
    if (name ~ /</) {
        sub(/^[^<]*</, "", name)
        sub(/>.*/, "", name)
        if (name in is_our_name) {
            wrong("<" name ">: a header of the project in brackets; allowed are quotes")
        } else if (own ~ /^firmware/ && index(freestanding, " " name " ") == 0) {
            wrong("<" name ">: not a freestanding header; allowed are:" freestanding)
        }
        next
    }
    sub(/^[^"]*"/, "", name)
    sub(/".*/, "", name)
    place = place_of(name)
    if (place == "" || !is_allowed(place)) {
        wrong("\"" name "\": " own "/ may include only: " may[own])
    } else if (own ~ /^host/ && !(own in sees_private) && place ~ /^firmware\/[^\/]*$/ && !(place in is_public)) {
        wrong("\"" name "\": not a public header of the firmware")
    } else if (folder_of(place) != folder_of(FILENAME) && place ~ /_internal\.h$/) {
        wrong("\"" name "\": an internal header of another folder")
    }
}

END {
    printf "%d include lines, %d wrong\n", lines, failures
    exit lines == 0 ? 2 : failures > 0
}' $(cat "$BUILD/include-files.txt")
