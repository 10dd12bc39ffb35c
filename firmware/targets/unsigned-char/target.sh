# SPDX-License-Identifier: MIT
# char without a sign, as on Arm and PowerPC.
#
# shellcheck disable=SC2034,SC2154 # values for, and from, who sources this file
. "$targets/posix/family.sh"
title='gcc -funsigned-char'
place=40
compiler='gcc -funsigned-char'
