#!/bin/sh
# SPDX-License-Identifier: MIT
# Breaks the source in small ways, one at a time, and sees whether the tests notice.
#
# usage: tests/mutants/run.sh BUILD PROGRAM...      (from the project's folder, as `make mutants` does)
#
# PROGRAMs are paths below BUILD: cmocka suites, or anything else whose exit status tells; arguments stand
# behind commas, as in release/x,some,more. A path that ends in .sh is a script of the source, which runs the command.
# Everything happens in BUILD/mutants/release, a copy of the source as it stands, committed or not.
#
# Environment: SEED (1); FIRST, the number of the first draw (1); COUNT of mutants that change code (20);
# LIMIT in seconds from the first mutant on (1800); FILES to draw from, as a shell's patterns (all that the
# programs are made of); SANITIZED=yes to run what `make test` runs, under the sanitizers (no: as released).
#
# Exit status: 0 no mutant survived but those of tests/mutants/equivalent, 1 one did, 2 it can't be told.
set -u

[ $# -ge 2 ] || {
    echo 'usage: tests/mutants/run.sh BUILD PROGRAM...' >&2
    exit 2
}
# What make was called with is not for the copy's make.
unset MAKEFLAGS MFLAGS MAKEOVERRIDES MAKELEVEL
mkdir -p "$1" || exit 2
build=$(cd "$1" && pwd)
work=$build/mutants
shift
here=tests/mutants
source=$PWD
# The code of the release is quicker by far than that under the sanitizers, which find a little more.
if [ "${SANITIZED:-no}" = yes ]; then
    built=sanitized
else
    built=release
fi
tree=$work/$built
costs=$work/costs_$built
seed=${SEED:-1}
first=${FIRST:-1}
count=${COUNT:-20}
limit=${LIMIT:-1800}
CC=${CC:-gcc}
superframe=$built/superframe

if kill -0 "$(cat "$work/running" 2> /dev/null)" 2> /dev/null; then
    echo "mutants: process $(cat "$work/running") is at work in $work" >&2
    exit 2
fi
# A run that was ended amid a mutant may have left objects of the mutant, or a compiler that still writes one.
[ ! -e "$tree/mutated" ] || rm -rf "$tree"
rm -rf "$work/saved"
mkdir -p "$tree/build/release" "$tree/build/sanitized" "$work/saved" || exit 2
printf '%s\n' $$ > "$work/running"
trap 'rm -f "$work/running"' EXIT
trap 'exit 130' INT TERM
: > "$work/green"
: > "$work/red"
: > "$work/tried"
: > "$work/results"
touch "$work/history" "$costs"
printf '%s\n' "$@" > "$work/programs"
for number in "$seed" "$first" "$count" "$limit"; do
    case $number in
    '' | *[!0-9]*)
        echo "mutants: \"$number\" is no number; SEED, FIRST, COUNT and SECONDS are whole numbers" >&2
        exit 2
        ;;
    esac
done

# Makes the copy what the source is. A file that is the same keeps its time, and its objects.
copy_source() {
    find . \( -path ./build -o -path ./.git -o -path "./${build#"$PWD"/}" \) -prune -o -type f -print |
        sort > "$work/files"
    (cd "$tree" && find . -path ./build -prune -o -type f -print) | sort > "$work/copied"
    comm -13 "$work/files" "$work/copied" | (cd "$tree" && xargs -r rm -f) || return 1
    while IFS= read -r file; do
        cmp -s "$file" "$tree/$file" && continue
        mkdir -p "$tree/${file%/*}" && cp "$file" "$tree/$file" || return 1
    done < "$work/files"
}

# Makes targets, paths below the copy's build/.
make_targets() {
    for target; do
        set -- "$@" "build/$target"
        shift
    done
    [ $built = sanitized ] || set -- 'CFLAGS_sanitized=-O1 -Wno-maybe-uninitialized' TESTED=release "$@"
    (cd "$tree" && timeout -k 10 1800 make -j2 -s CC="$CC" SETUP=no BUILD=build "$@") > "$work/make.log" 2>&1
}

# Prints the objects, paths below the copy's build/, that a file is compiled into. The compiler may call the
# file firmware/real/fx/../fixed.h.
objects_of() {
    pattern="(^| )${1%/*}/([^ ]*/\\.\\./)?${1##*/}( |:|\$)"
    (cd "$tree/build" && find release sanitized -name '*.d' -exec grep -lE "$pattern" {} + |
        sed 's/\.d$/.o/')
}

# Prints the objects of a list, and those that they are joined to: arithmetics and stream engines.
with_joined() {
    sed -n -e 'p' -e 's#^\([a-z]*/[a-z0-9_]*\)/\(firmware\|host\)/.*#\1.o#p' "$1" | sort -u
}

# Notes which file makes a difference to which program, by what their objects need of each other.
find_sight() {
    (
        cd "$tree/build" || exit 2
        find release sanitized -name '*.d' -exec cat {} + |
            awk -f "$source/$here/dependencies.awk" > "$work/files_of"
        find release sanitized -name '*.o' ! -path '*/arithmetic_*/firmware/*' \
            ! -path '*/arithmetic_*/host/*' ! -path '*/stream_engine_*/*' -exec nm -A -g -P {} + > "$work/symbols"
        find sanitized/tests -name '*.o' -exec grep -lF SUPERFRAME {} + |
            sed 's/\.o$//' > "$work/runners"
    )
    awk -f $here/sees.awk "$work/programs" "$work/symbols" "$work/files_of" "$work/runners" \
        > "$work/sight"
}

# Puts the file and its objects back, and takes away what was linked with the mutant.
restore() {
    cp -p "$work/original" "$tree/$1"
    (cd "$tree/build" && xargs -r rm -f) < "$work/affected"
    (cd "$work/saved" && find . -type f) | while IFS= read -r object; do
        mv "$work/saved/$object" "$tree/build/$object"
    done
    (cd "$tree/build" && xargs -r rm -f) < "$work/linked"
    : > "$work/linked"
    rm -f "$tree/mutated"
}

# Saves a file and its objects, before the mutant of the file is put in its place.
save() {
    : > "$tree/mutated"
    cp -p "$tree/$1" "$work/original"
    while IFS= read -r object; do
        [ -e "$tree/build/$object" ] || continue
        mkdir -p "$work/saved/${object%/*}" && mv "$tree/build/$object" "$work/saved/$object"
    done < "$work/affected"
    printf '%s\n' "$superframe" $built/library.a > "$work/linked"
}

# Compares the mutant's code with the original's, as released and without what is for debuggers.
# 0: it differs; 1: it does not; 2: the mutant does not compile.
changes_code() {
    while IFS= read -r object; do
        make_targets "$object" || return 2
        strip -g -o "$work/code" "$tree/build/$object" &&
            strip -g -o "$work/code_before" "$work/saved/$object" || return 2
        cmp -s "$work/code" "$work/code_before" || return 0
    done < "$work/compared"
    return 1
}

# Makes a program, and the command where the program starts the command.
make_program() {
    case $1 in
    *.sh) make_targets $superframe ;;
    *)
        if grep -qxF "$1" "$work/runners"; then
            make_targets "$1" $superframe
        else
            make_targets "${1%%,*}"
        fi
        ;;
    esac
}

# Runs a program of the copy for at most some seconds. Notes that it can be green, and what it took.
run_program() {
    run_began=$(date +%s)
    (
        cd "$tree" || exit 2
        # A mutant may write or allocate without an end.
        ulimit -f 4000000
        patience=$2
        IFS=,
        # shellcheck disable=SC2086 # the program and its arguments
        set -- $1
        unset IFS
        case $1 in
        *.sh) set -- sh "$@" ;;
        *)
            program=build/$1
            shift
            set -- "$program" "$@"
            ;;
        esac
        BUILD=build SUPERFRAME=build/$superframe ASAN_OPTIONS=hard_rss_limit_mb=3000 \
            exec timeout -k 5 "$patience" "$@"
    ) > "$work/run.log" 2>&1 || return
    printf '%s %s\n' "$1" $(($(date +%s) - run_began)) >> "$costs"
    printf '%s\n' "$1" >> "$work/green"
}

# Prints the programs to run for a file, the most promising for their time first.
in_order() {
    awk -v file="$1" -f $here/order.awk "$work/sight" "$costs" "$work/history"
}

# Prints the seconds that a program may take: ten times what it took last, and twenty more.
seconds_of() {
    awk -v program="$1" '$1 == program { seconds = 10 * $2 + 20 }
        END { print (seconds > 0 ? seconds : 300) }' "$costs"
}

# Runs programs until one is red twice in a row. Sets `outcome` to caught, survived, open (the time
# is up) or broken (it can't be linked), and `by` to the program.
judge() {
    outcome=survived
    for by in $(in_order "$1"); do
        ! grep -qxF "$by" "$work/red" || continue
        [ "${by%.sh}" != "$by" ] || printf '%s\n' "${by%%,*}" >> "$work/linked"
        make_program "$by" || {
            outcome=broken
            return
        }
        patience=$(seconds_of "$by")
        left=$((deadline - $(date +%s)))
        [ $left -gt 0 ] || {
            outcome=open
            return
        }
        run_program "$by" $((patience < left ? patience : left)) && continue
        case $? in
        124 | 137) [ "$patience" -le $left ] && outcome=caught || outcome=open ;;
        *) run_program "$by" "$patience" || outcome=caught ;;
        esac
        [ $outcome = survived ] || return
    done
}

# Tells if a program is green without a mutant; one that is not is left out from then on.
is_green() {
    ! grep -qxF "$1" "$work/green" || return 0
    ! { make_program "$1" && run_program "$1" "$(seconds_of "$1")"; } || return 0
    printf '%s\n' "$1" >> "$work/red"
    echo "left out, for it fails without a mutant: $1"
    return 1
}

# Draws a mutant into $work/mutant, and sets file, line, function, old and new.
draw() {
    xargs "$work/mutate" "$seed" "$1" "${FILES:-*}" "$work/mutant" < "$work/sources" \
        > "$work/drawn" || exit 2
    {
        IFS= read -r file
        IFS= read -r line
        IFS= read -r function
        IFS= read -r old
        IFS= read -r new
    } < "$work/drawn"
}

# Prints the reason for which the drawn mutant is listed as equivalent.
listed_reason() {
    awk -f $here/listed.awk "$work/drawn" $here/equivalent
}

# Sets `outcome` for the drawn mutant, with the copy as it was before and after.
try_mutant() {
    objects_of "$file" | grep -vE '^sanitized/(.*/)?tests/' | sed 's|^sanitized/|release/|' | sort -u > "$work/compared"
    outcome=broken
    [ -s "$work/compared" ] || return
    # shellcheck disable=SC2046 # paths without spaces
    make_targets $(cat "$work/compared") || return
    objects_of "$file" > "$work/objects"
    with_joined "$work/objects" > "$work/affected"
    save "$file"
    # A mutant may leave something unused, or && beside ||.
    { printf "%s" "$lenient" && cat "$work/mutant"; } > "$tree/$file"
    changes_code
    case $? in
    0) judge "$file" ;;
    1) outcome=equal ;;
    esac
    restore "$file"
}

# Counts an outcome, and prints and notes it where it is of interest.
note() {
    case $outcome in
    caught) words="caught by ${by##*/}" ;;
    survived) words="SURVIVED (number $number)" ;;
    open) words='not settled, the time is up' ;;
    listed) words="equivalent ($(listed_reason))" ;;
    esac
    [ "$outcome" != caught ] || printf '%s %s\n' "$file" "$by" >> "$work/history"
    printf '%s\t%s\n' "$outcome" "$file" >> "$work/results"
    [ $outcome = equal ] || [ $outcome = broken ] ||
        printf '%s: %s:%s: %s -> %s\n' "$words" "$file" "$line" "$old" "$new"
}

copy_source || exit 2
$CC -std=c99 -D_POSIX_C_SOURCE=200809L -O1 -Ihal -o "$work/mutate" $here/*.c || exit 2
lenient=$(printf '_Pragma("GCC diagnostic ignored \\"-W%s\\"") ' parentheses unused-function unused-parameter \
    unused-variable unused-but-set-variable)
objects=$(grep -v '\.sh$' "$work/programs" | sed 's/,.*//; /\/usb\/\|testkit/!s/_test[a-z0-9_]*$/&.o/')
echo 'mutants: building what the programs are made of'
# shellcheck disable=SC2086 # paths without spaces
make_targets $superframe $objects || {
    tail -n 20 "$work/make.log" | cut -c 1-300 >&2
    exit 2
}
find_sight
cut -d " " -f 2 "$work/sight" | sort -u > "$work/sources"

began=$(date +%s)
deadline=$((began + limit))
number=$((first - 1))
judged=0
while [ $judged -lt "$count" ] && [ "$(date +%s)" -lt $deadline ] &&
    [ $number -lt $((first + 20 * count + 100)) ]; do
    number=$((number + 1))
    draw $number
    ! grep -qxF "$file $line $new" "$work/tried" || continue
    outcome=listed
    [ -n "$(listed_reason)" ] || try_mutant
    [ "$outcome" != caught ] || is_green "$by" || {
        number=$((number - 1))
        continue
    }
    printf '%s\n' "$file $line $new" >> "$work/tried"
    note
    case $outcome in
    caught | survived) judged=$((judged + 1)) ;;
    esac
done

awk -F '\t' -v draws="$first to $number of SEED=$seed" -v seconds=$(($(date +%s) - began)) -f $here/summary.awk "$work/results"
! grep -q '^survived' "$work/results"
