# SPDX-License-Identifier: MIT
# Prints "object file" for each source file of the project in the compiler's lists of dependencies. An object of a
# firmware's image, or of a stream engine, is named as the one that it is linked into; a/b/../c.h is a/c.h.

{
    for (i = 1; i <= NF; i++) {
        if ($i ~ /\.o:$/) {
            object = substr($i, 1, length($i) - 3)
            sub(/^build\//, "", object)
            if (object ~ /^[a-z]+\/(arithmetic|stream_engine)_[^\/]*\/(firmware|host)\//) {
                split(object, parts, "/")
                object = parts[1] "/" parts[2]
            }
            object = object ".o"
        } else if ($i ~ /^(hal|firmware|emulator|host)\/.*\.[ch]$/) {
            file = $i
            while (sub(/[^\/]+\/\.\.\//, "", file)) {
            }
            print object, file
        }
    }
}
