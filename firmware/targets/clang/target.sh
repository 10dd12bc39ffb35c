# SPDX-License-Identifier: MIT
# clang on an x86-64 Linux.
#
# shellcheck disable=SC2034,SC2154 # values for, and from, who sources this file
. "$targets/posix/family.sh"
title='clang, x86-64'
place=20
compiler=clang
packages='tool|clang|clang'
