# SPDX-License-Identifier: MIT
# char without a sign, as on Arm and PowerPC.
. "$targets/posix/family.sh"
title='gcc -funsigned-char'
place=40
compiler='gcc -funsigned-char'
