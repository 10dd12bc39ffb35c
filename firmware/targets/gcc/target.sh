# SPDX-License-Identifier: MIT
# gcc on an x86-64 Linux.
#
# shellcheck disable=SC2034,SC2154 # values for, and from, who sources this file
. "$targets/posix/family.sh"
title='gcc, x86-64'
place=10
compiler=gcc
