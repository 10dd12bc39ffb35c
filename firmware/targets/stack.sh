#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the worst stack of an image in bytes: stack.sh TARGET FOLDER
#
# FOLDER is what build.sh has made for the target; of a compiler other than gcc nothing is known.
# A function of the compiler's library takes at most 32 bytes (the largest is __aeabi_ldivmod's kin;
# a leaf pushes up to 6 registers). Exit status: 0 printed, 1 not known.
set -eu

. firmware/targets/targets.sh
target_read "$1" || exit 1
[ -n "$entry" ] || exit 1
awk -v entry="$entry" -v library=32 -v calls="$(printf %s "$calls" | tr '\n' ' ')" -f "$targets/stack.awk" "$2"/*.ci
