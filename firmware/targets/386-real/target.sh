# SPDX-License-Identifier: MIT
# A PC-9801's floppy that stays in real mode: one segment for all.
. "$targets/pc98/family.sh"
title='386, real mode (PC-98 floppy on Unicorn)'
place=140
mode=real
cpu=-m16
optimisation=-Os
load_address=0
memory=65532
sizes=fx/minimal
