# SPDX-License-Identifier: MIT
# Median, least, largest; awk -f statistics.awk -f another.awk.

# Sorts values[1..count]; few values, so the simplest way.
function sort_values(values, count,    i, j, value) {
    for (i = 2; i <= count; i++) {
        value = values[i] + 0
        for (j = i - 1; j >= 1 && values[j] + 0 > value; j--) values[j + 1] = values[j]
        values[j + 1] = value
    }
}

# Of values[1..count], sorted; of an even count the mean of the middle two.
function median(values, count,    half) {
    half = int(count / 2)
    return count % 2 ? values[half + 1] + 0 : (values[half] + values[half + 1]) / 2
}
