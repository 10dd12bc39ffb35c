# SPDX-License-Identifier: MIT
# clang on an x86-64 Linux.
. "$targets/posix/family.sh"
title='clang, x86-64'
place=20
compiler=clang
packages='tool|clang|clang'
