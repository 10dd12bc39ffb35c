# SPDX-License-Identifier: MIT
# Prints the programs that can see a file, those first that promise the most for their time:
# order.awk -v file=FILE SIGHT COSTS HISTORY
#
# SIGHT is what sees.awk prints. COSTS has "program seconds" for each run that was green; the last one counts.
# HISTORY has "file program" for each mutant that was caught. Nothing known of a program yet, one that sees
# few other files goes first.

function folder(path) {
    sub(/[^\/]*$/, "", path)
    return path
}
FILENAME == ARGV[1] {
    seen[$1]++
    if ($2 == file) {
        is_asked[$1] = 1
    }
}
FILENAME == ARGV[2] { seconds[$1] = $2 }
FILENAME == ARGV[3] { caught[$2] += $1 == file ? 4 : folder($1) == folder(file) ? 0.25 : 0 }
END {
    for (program in is_asked) {
        cost = program in seconds ? seconds[program] : 2
        worth = (caught[program] + 10 / seen[program]) / (cost + 0.5)
        printf "%.6f %s\n", worth, program | "sort -k1,1gr -k2 | cut -d ' ' -f 2"
    }
}
