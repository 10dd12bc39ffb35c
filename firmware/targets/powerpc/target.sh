# SPDX-License-Identifier: MIT
# A big-endian CPU, by qemu-user.
. "$targets/posix/family.sh"
title='PowerPC, big-endian (qemu-user)'
place=60
compiler=powerpc-linux-gnu-gcc
link_options=-static
packages='tool|powerpc-linux-gnu-gcc|gcc-powerpc-linux-gnu
file|/usr/powerpc-linux-gnu/include/stdio.h|libc6-dev-powerpc-cross
tool|qemu-ppc|qemu-user'
fx=fx_32

run() {
    $limit qemu-ppc ./image.elf
}
