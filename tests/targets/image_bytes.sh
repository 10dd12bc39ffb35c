# SPDX-License-Identifier: MIT
# The bytes of an image that firmware/targets/build.sh has made; sourced.

# section IMAGE NAME...: the bytes of these sections together.
section() {
    image=$1
    shift
    size -A "$image" | awk -v names=" $* " 'index(names, " " $1 " ") { sum += $2 } END { print sum + 0 }'
}
