# SPDX-License-Identifier: MIT
# The limits of images of fig3 alone, whatever figures are kept, and what fx costs against floating
# point in software: awk -f size_limits.awk SIZES
#
# Exit status: 0 they hold, 1 one does not, or an image is missing.

# limit WHAT VALUE MOST
function limit(what, value, most) {
    seen++
    if (value > most) {
        print what ": " value " bytes; the limit is " most
        failed = 1
    }
}

# 16 KiB, 4 KiB and 32 KiB were the first limits; what was measured first was less and took their place.
$1 == "cortex-m0" && $2 == "fx" && $4 == "minimal" {
    limit("cortex-m0, code and constants", $5 + $6, 12472)
    limit("cortex-m0, RAM", $7, 2920)
}
$1 == "386-flat" && $4 == "minimal" { limit("386-flat, code and constants", $5 + $6, 24364) }
$4 == "minimal" && $9 != "-" { instructions[$1, $2] = $9 }

END {
    for (target in instructions) {
        split(target, part, SUBSEP)
        if (part[2] == "f32" && (part[1], "fx") in instructions && part[1] != "cortex-m4f") {
            printf "%s: f32 in software takes %.2f times the instructions of fx\n", part[1], \
                instructions[target] / instructions[part[1], "fx"]
        }
    }
    exit failed || seen < 3
}
