#!/bin/sh
# SPDX-License-Identifier: MIT
# Has Gappa prove the stated errors of the fixed-point operations: bounds.sh
#
# Each file of bounds/ opens with what it is about. Exit status: 0 all are proved, 1 one is not.
set -u

failed=0
for file in "$(dirname "$0")"/bounds/*.gappa; do
    claim=$(sed -n '1s/^# //p' "$file")
    if said=$(timeout -k 5 60 gappa "$file" 2>&1); then
        echo "bounds: proved: $claim"
    else
        echo "$said"
        echo "bounds: NOT proved: $claim ($file)"
        failed=1
    fi
done
exit $failed
