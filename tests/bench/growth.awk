# SPDX-License-Identifier: MIT
# Holds instructions a ray against those that are kept: awk -v percent=2 -v kept=NAME -f growth.awk KEPT FOUND
#
# Rows: scene arithmetic N size rows rays instructions instructions_a_ray. Exit status: 0 nothing has
# grown by more than so many per cent; 1 something has, or what is kept was not measured.
/^#/ { next }

{ key = $1 " " $2 " N=" $3 " " $4 " " $5 }

NF != 8 || $8 <= 0 {
    print FILENAME ":" FNR ": no row of eight columns: " $0
    wrong++
    next
}

FNR == NR {
    before[key] = $8
    next
}

{
    now[key] = $8
    if (!(key in before)) {
        print key ": " $8 " a ray, and nothing is kept of it: make bench-instructions-keep"
        wrong++
        next
    }
    change = ($8 / before[key] - 1) * 100
    verdict = "good"
    if ($8 * 100 > before[key] * (100 + percent)) {
        verdict = "has grown by more than " percent " %"
        wrong++
    } else if (change < -percent) {
        verdict = "better: make bench-instructions-keep"
    }
    printf "%-40s %10.2f a ray, kept %10.2f, %+6.2f %%: %s\n", key, $8, before[key], change, verdict
}

END {
    for (key in before) {
        if (!(key in now)) {
            print key ": is kept and was not measured"
            wrong++
        }
    }
    print "bench: instructions a ray: " wrong + 0 " wrong against " kept
    exit wrong > 0
}
