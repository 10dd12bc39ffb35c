# SPDX-License-Identifier: MIT
# The protected-mode floppy once more, on a 486 of another emulator.
. "$targets/386-flat/target.sh"
. "$targets/isapc/family.sh"
title='486, protected mode (the same floppy on QEMU isapc)'
place=110
