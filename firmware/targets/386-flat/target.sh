# SPDX-License-Identifier: MIT
# A PC-9801's floppy that goes to protected mode.
. "$targets/pc98/family.sh"
title='386, protected mode (PC-98 floppy on Unicorn)'
place=130
mode=flat
cpu=-m32
optimisation=-O2
load_address=0x20000
memory=192512 # 188 of the 192 KiB up to the stack's top
sizes='fx/minimal/count fx/full'
