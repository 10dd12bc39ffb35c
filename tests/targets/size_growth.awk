# SPDX-License-Identifier: MIT
# Holds measured sizes against kept ones: awk -f size_growth.awk KEPT NOW
#
# Exit status: 0 nothing grew by more than 2 per cent, 1 something did, or has no kept figures, or is
# measured no more.

/^#/ { next }
{ image = $1 " " $2 " " $3 " " $4 }
NR == FNR { before[image] = $0; next }
!(image in before) { print image ": no kept figures; make size-keep keeps them"; failed = 1; next }
{
    split(before[image], was, " ")
    split("code constants RAM stack instructions", what, " ")
    delete before[image]
    for (i = 5; i <= 9; i++) {
        if (was[i] != "-" && ($i == "-" || $i > was[i] * 1.02)) {
            printf "%s: %s grew from %s to %s; make size-keep keeps it\n", image, what[i - 4], was[i], $i
            failed = 1
        }
    }
}
END {
    for (image in before) {
        print image ": has kept figures and was not measured"
        failed = 1
    }
    exit failed
}
