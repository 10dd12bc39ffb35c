# SPDX-License-Identifier: MIT
# The real-mode floppy once more, on a 486 of another emulator.
. "$targets/386-real/target.sh"
. "$targets/isapc/family.sh"
title='486, real mode (the same floppy on QEMU isapc)'
place=120
