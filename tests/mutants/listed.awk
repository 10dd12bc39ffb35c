# SPDX-License-Identifier: MIT
# Prints why a mutant changes nothing that can be seen, if tests/mutants/equivalent says so: listed.awk DRAWN EQUIVALENT
# An entry counts wherever its line stands: file, function and both texts are compared, no line number.

NR == FNR {
    drawn[FNR] = $0
    next
}
/^@ / {
    place = substr($0, 3)
    is_same = place == drawn[1] " " drawn[3]
    reason = ""
}
/^- / { is_same = is_same && substr($0, 3) == drawn[4] }
/^\+/ { is_same = is_same && substr($0, 3) == drawn[5] }
/^= / && is_same {
    print substr($0, 3)
    exit
}
