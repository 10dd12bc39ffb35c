# SPDX-License-Identifier: MIT
# Sums up paired runs: awk -f statistics.awk -f ratios.awk -v keys=3 -v top=5 -v bottom=4 TABLE.tsv
#
# Rows whose first `keys` columns are the same are pairs of one comparison; each pair is its column
# `top` over its column `bottom`. A row for each comparison comes out, in the order of the first:
# its key, pairs, the ratio's median, least and largest, the medians of bottom and of top. The
# table's first row names its columns. Exit status 2: a row does not hold such a pair.
BEGIN { FS = OFS = "\t" }

FNR == 1 {
    key = $1
    for (i = 2; i <= keys; i++) key = key OFS $i
    print key, "pairs", "median", "least", "largest", $bottom, $top
    next
}

{
    if ($top !~ /^[0-9.]+(e[-+]?[0-9]+)?$/ || $bottom !~ /^[0-9.]+(e[-+]?[0-9]+)?$/ || $bottom <= 0) {
        print FILENAME ":" FNR ": no pair of seconds: \"" $top "\" over \"" $bottom "\"" > "/dev/stderr"
        failed = 1
        exit 2
    }
    key = $1
    for (i = 2; i <= keys; i++) key = key OFS $i
    if (!(key in count)) order[++kinds] = key
    n = ++count[key]
    ratio[key, n] = $top / $bottom
    tops[key, n] = $top
    bottoms[key, n] = $bottom
}

function collect(from, key,    i) {
    for (i = 1; i <= count[key]; i++) sorted[i] = from[key, i]
    sort_values(sorted, count[key])
    return median(sorted, count[key])
}

END {
    if (failed) exit 2
    for (k = 1; k <= kinds; k++) {
        key = order[k]
        of_bottom = collect(bottoms, key)
        of_top = collect(tops, key)
        middle = collect(ratio, key)
        printf "%s\t%d\t%.3f\t%.3f\t%.3f\t%.4f\t%.4f\n", key, count[key], middle, sorted[1],
            sorted[count[key]], of_bottom, of_top
    }
}
