# SPDX-License-Identifier: MIT
# Prints "object file" for each source file of the project in the compiler's lists of dependencies. An object of a
# firmware's image, or of a stream engine, is named as the one that it is linked into.

{
    for (i = 1; i <= NF; i++) {
        if ($i ~ /\.o:$/) {
            object = substr($i, 1, length($i) - 3)
            sub(/^build\//, "", object)
            if (match(object, /^sanitized\/stream\/[^\/]*\//)) {
                object = "sanitized/stream_" substr(object, 18, RLENGTH - 18) ".o"
            } else if (object ~ /^sanitized\/[^\/]*\/(firmware|host)\//) {
                split(object, parts, "/")
                object = "sanitized/image_" parts[2] ".o"
            } else {
                object = object ".o"
            }
        } else if ($i ~ /^(hal|firmware|emulator|host)\/.*\.[ch]$/) {
            print object, $i
        }
    }
}
