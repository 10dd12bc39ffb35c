# SPDX-License-Identifier: MIT
# Prints which file can make a difference to which program, as pairs "program file":
# sees.awk PROGRAMS SYMBOLS DEPENDENCIES RUNNERS
#
# PROGRAMS      a program on each line; its own object is the program's path with .o behind
# SYMBOLS       `nm -A -g -P` of all objects that programs are linked from
# DEPENDENCIES  "object file" for each file that an object is compiled from
# RUNNERS       a program on each line that starts the command, which is made of everything
#
# Names lead from an object to those that define them. What is no suite, or has no object of its
# own, is taken to see everything.

FNR == 1 { part++ }
part == 1 { programs[++program_count] = $1 }
part == 2 {
    object = substr($1, 1, length($1) - 1)
    if ($3 == "U" || $3 == "w" || $3 == "v") {
        needed[object] = needed[object] " " $2
    } else {
        definer[$2] = object
    }
}
part == 3 {
    files[$1] = files[$1] " " $2
    everything[$2] = 1
}
part == 4 { sees_all[$1] = 1 }
END {
    for (p = 1; p <= program_count; p++) {
        program = programs[p]
        split("", found)
        if (program in sees_all || program !~ /_test[a-z0-9_]*$/ || !((program ".o") in needed)) {
            for (file in everything) {
                found[file] = 1
            }
        } else {
            follow(program ".o")
        }
        for (file in found) {
            print program, file
        }
    }
}

# Puts the files of an object, and of all that it leads to, into `found`.
function follow(start, waiting, count, reached, object, names, list, i) {
    split("", reached)
    waiting[count = 1] = start
    reached[start] = 1
    while (count > 0) {
        object = waiting[count--]
        split(files[object], list, " ")
        for (i in list) {
            found[list[i]] = 1
        }
        split(needed[object], names, " ")
        for (i in names) {
            if (names[i] in definer && !(definer[names[i]] in reached)) {
                reached[definer[names[i]]] = 1
                waiting[++count] = definer[names[i]]
            }
        }
    }
}
