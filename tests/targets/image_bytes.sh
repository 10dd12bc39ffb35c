# SPDX-License-Identifier: MIT
# The bytes of an image that firmware/targets/build.sh has made; sourced with $here set to its folder.

# section IMAGE NAME...: the bytes of these sections together.
section() {
    image=$1
    shift
    size -A "$image" | awk -v names=" $* " 'index(names, " " $1 " ") { sum += $2 } END { print sum + 0 }'
}

# The worst stack. A function of the compiler's library takes at most 32 bytes (the largest is
# __aeabi_ldivmod's kin; a leaf pushes up to 6 registers).
stack() {
    case $1 in
    386-*) entry=pc98_main calls='pc98_main>firmware/image.c:image_draw
firmware/image.c:image_draw>firmware/targets/pc98/main.c:next_row
firmware/targets/pc98/main.c:next_row>firmware/image.c:image_row' ;;
    rv32im) entry=frame_draw calls='frame_draw>firmware/image.c:image_draw' ;;
    *) entry=reset calls='frame_draw>firmware/image.c:image_draw' ;;
    esac
    awk -v entry=$entry -v library=32 -v calls="$(echo $calls)" -f "$here/stack.awk" "$2"/*.ci
}
