# SPDX-License-Identifier: MIT
# A table as a JSON array of objects: awk -f json.awk TABLE.tsv. The first row names the columns; what
# looks like a number is one. An empty table is an empty array.
BEGIN { FS = "\t"; printf "[" }

FNR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

function quoted(text) {
    gsub(/["\\]/, "\\\\&", text)
    return "\"" text "\""
}

{
    printf "%s\n    {", (rows++ ? "," : "")
    for (i = 1; i <= NF; i++) {
        is_number = $i ~ /^-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?$/
        printf "%s%s: %s", (i > 1 ? ", " : ""), quoted(name[i]), (is_number ? $i : quoted($i))
    }
    printf "}"
}

END { print (rows ? "\n  ]" : "]") }
