# SPDX-License-Identifier: MIT
# What is asked for and what was found, as rows of a Markdown table: awk -f statistics.awk -f claims.awk
# renders.tsv frame.tsv jobs.tsv pairs.ratios equal.ratios instructions.txt; those that are not there are
# left out.
BEGIN { FS = "\t" }

FNR == 1 {
    table = FILENAME
    sub(/.*\//, "", table)
    next
}

table == "renders.tsv" {
    if ($10 + 0 > peak) peak = $10 + 0
    if ($11 + 0 > first) first = $11 + 0
    rays[$1, $2, $3] = $5
    scenes[$1] = depths[$3] = 1
    if ($2 == 640 && $3 >= 5 && $3 <= 20) {
        key = $1 ", " $4
        if (!(key in least) || $12 < least[key]) least[key] = $12 + 0
        if (!(key in most) || $12 > most[key]) most[key] = $12 + 0
        points[key]++
    }
}

table == "frame.tsv" {
    if ($3 + 0 > ports) ports = $3 + 0
    if ($5 + 0 > observed) observed = $5 + 0
    if ($7 + 0 > png) png = $7 + 0
}

table == "jobs.tsv" {
    speedup[++runs] = $5 / $6
    apart[runs] = 2 * $5 / $7
}

# Rows of a whole band of pixels and more: scene arithmetic N size rows rays instructions, by blanks.
table == "instructions.txt" && split($0, column, " ") == 8 && column[4] == "640x400" {
    key = column[1] ", " column[2]
    counted = column[8] + 0
    if (!(key in fewest) || counted < fewest[key]) fewest[key] = counted
    if (counted > largest[key] + 0) largest[key] = counted
}

# key: scene, size, N, arithmetic; $6: the median of the ratio
table == "pairs.ratios" || table == "equal.ratios" {
    name = table == "pairs.ratios" ? "pairs" : "equal"
    class = name == "equal" ? name : $1 ~ /^fig(3|4a|5)$/ ? ($4 == "fx" ? "fx" : "float") : "small"
    if ($4 == "f128" || ($4 == "fx" && class != "fx")) next
    group = class SUBSEP $1 SUBSEP $3
    if (!(group in best) || $6 + 0 > best[group]) best[group] = $6 + 0
}

function show(what, asked, found, holds) {
    printf "| %s | %s | %s | %s |\n", what, asked, found, (holds == "" ? "" : holds ? "yes" : "**no**")
}

function show_ratio(class, what, asked,    group, part, worst, where) {
    worst = -1
    for (group in best) {
        split(group, part, SUBSEP)
        if (part[1] == class && (worst < 0 || best[group] < worst)) {
            worst = best[group]
            where = part[2] ", N = " part[3]
        }
    }
    if (worst >= 0) show(what, "at least " asked, sprintf("%.2f (%s)", worst, where), worst >= asked)
}

END {
    print "| what | asked for | found, the worst | holds |"
    print "|---|---|---|---|"
    show_ratio("float", "POV-Ray's user CPU over ours: fig3, fig4a, fig5, the faster of f32 and f64", 20)
    show_ratio("fx", "the same with fx", 4)
    show_ratio("small", "the same: fig7-isolated, figA, the faster of f32 and f64", 10)
    show_ratio("equal", "the same at equal error, 45 dB", 20)
    if (peak) {
        show("CPU time from the start to the first port write", "below 10 ms", sprintf("%.1f ms", first * 1e3), first < 0.01)
        show("peak memory", "below 8 MB", sprintf("%.1f MB", peak * 1024 / 1e6), peak * 1024 < 8e6)
    }
    if (ports) {
        show("ports and board in a frame of 640 x 400", "at most 8 ms", sprintf("%.1f ms", ports), ports <= 8)
        show("the same with the hash of --stats", "at most 8 ms", sprintf("%.1f ms", observed), observed <= 8)
        show("its PNG", "at most 4 ms", sprintf("%.1f ms", png), png <= 4)
    }
    if (runs) {
        sort_values(speedup, runs)
        sort_values(apart, runs)
        found = median(speedup, runs)
        show("`--jobs 2` against 1, fig4a, by the clock", "at least 1.9", sprintf("%.2f (%.2f to %.2f)", found, speedup[1], speedup[runs]), found >= 1.9)
        show("two renders at once against one after the other: what the machine's two processors are worth", "", sprintf("%.2f (%.2f to %.2f)", median(apart, runs), apart[1], apart[runs]), "")
    }
    for (scene in scenes) for (depth in depths) {
        if (rays[scene, 320, depth] && rays[scene, 640, depth]) {
            ratio = rays[scene, 640, depth] / rays[scene, 320, depth]
            if (!seen++ || (ratio - 4) ^ 2 > (worst_ratio - 4) ^ 2) {
                worst_ratio = ratio
                where_ratio = scene ", N = " depth
            }
        }
    }
    if (seen) show("rays of 640 x 400 over those of 320 x 200", "3.9 to 4.1", sprintf("%.2f (%s)", worst_ratio, where_ratio), worst_ratio >= 3.9 && worst_ratio <= 4.1)
    for (key in least) {
        rise = (most[key] / least[key] - 1) * 100
        if (points[key] > 1 && rise >= worst_rise + 0) {
            worst_rise = rise
            where_rise = key
        }
    }
    if (where_rise != "") show("cost of a ray, N = 5 to 20, as user CPU of the whole process: the largest over the least", "within 10 %", sprintf("%.1f %% (%s)", worst_rise, where_rise), worst_rise <= 10)
    for (key in fewest) {
        rise = (largest[key] / fewest[key] - 1) * 100
        if (rise >= worst_count + 0) {
            worst_count = rise
            where_count = key
        }
    }
    if (where_count != "") show("the same in instructions, what draws alone", "within 10 %", sprintf("%.1f %% (%s)", worst_count, where_count), worst_count <= 10)
}
