# SPDX-License-Identifier: MIT
# A Cortex-M3. f32 in software takes too long for the table: `make size` measures it.
. "$targets/cortex_m/family.sh"
title='Cortex-M3 (QEMU mps2-an385)'
place=80
machine=mps2-an385
cpu=-mcpu=cortex-m3
fx=fx_m3
