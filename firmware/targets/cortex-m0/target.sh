# SPDX-License-Identifier: MIT
# A Cortex-M0, the smallest: 16 KiB of memory, products of 16 by 16 bits.
. "$targets/cortex_m/family.sh"
title='Cortex-M0 (QEMU microbit)'
place=100
machine=microbit
cpu=-mcpu=cortex-m0
optimisation=-Os
fx=fx_16
memory=16384
