# SPDX-License-Identifier: MIT
# gcc on an x86-64 Linux.
. "$targets/posix/family.sh"
title='gcc, x86-64'
place=10
compiler=gcc
