# SPDX-License-Identifier: MIT
# A Cortex-M4 with a floating-point unit of single precision.
. "$targets/cortex_m/family.sh"
title='Cortex-M4F (QEMU mps2-an386)'
place=70
machine=mps2-an386
cpu='-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16'
coprocessor=coprocessor_fpu
arithmetics='fx f32'
fx=fx_32
square_root=$targets/cortex_m/square_root_fpu.c
