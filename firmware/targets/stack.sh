#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the worst stack of an image in bytes: stack.sh TARGET FOLDER
#
# FOLDER is what build.sh has made for the target; of a compiler other than gcc nothing is known.
# A function of the compiler's library takes at most 32 bytes (the largest is __aeabi_ldivmod's kin;
# a leaf pushes up to 6 registers). Exit status: 0 printed, 1 not known.
set -eu

case $1 in
386-* | qemu-486*) entry=pc98_main calls='pc98_main>firmware/image.c:image_draw
firmware/image.c:image_draw>firmware/targets/pc98/main.c:next_row
firmware/targets/pc98/main.c:next_row>firmware/image.c:image_row' ;;
rv32im) entry=frame_draw calls='frame_draw>firmware/image.c:image_draw' ;;
*) entry=reset calls='frame_draw>firmware/image.c:image_draw' ;;
esac
# shellcheck disable=SC2086 # lines become words
awk -v entry=$entry -v library=32 -v calls="$(echo $calls)" -f "$(dirname "$0")/stack.awk" "$2"/*.ci
