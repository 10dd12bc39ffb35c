# SPDX-License-Identifier: MIT
# A Linux of 32 bits on x86.
. "$targets/posix/family.sh"
title='gcc -m32'
place=30
compiler='gcc -m32'
packages='m32|stdio.h|gcc-multilib'
fx=fx_32
