# SPDX-License-Identifier: MIT
# What the stages of the bench share: settings, runs of the two programs. Read by bench.sh.
#
# Settings come from the environment; the defaults are a part that takes less than ten minutes.
# BENCH=all          every scene, N = 1..20, f128 too; against POV-Ray N = 15 as well: hours
# BENCH_SCENES       of the whole renders
# BENCH_ARITHMETICS  of the whole renders and of the pairs
# BENCH_SMALL        depth levels at 320x200
# BENCH_LARGE        depth levels at 640x400
# BENCH_PAIRS        runs of each program against POV-Ray, at least 1
# BENCH_MATCHES      comparisons at the same N: scene:depth
# BENCH_EQUAL        scenes compared at equal error
# BENCH_SEARCH=yes   looks for the cheapest settings at equal error though docs/bench/settings.tsv has some

if [ "${BENCH:-part}" = all ]; then
    : "${BENCH_SCENES:=fig3 fig4a fig4b fig5 fig6a fig6b fig7-isolated fig7-frustum figA}"
    : "${BENCH_ARITHMETICS:=fx f32 f64 f128}"
    : "${BENCH_SMALL:=1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20}"
    : "${BENCH_LARGE:=$BENCH_SMALL}"
    : "${BENCH_MATCHES:=fig3:10 fig3:15 fig4a:10 fig4a:15 fig5:10 fig5:15 fig7-isolated:10 figA:10}"
fi
: "${BENCH_SCENES:=fig3 fig4a fig5 fig7-isolated figA}"
: "${BENCH_ARITHMETICS:=fx f32 f64}"
: "${BENCH_SMALL:=1 2 3 5 7 10 15 20}"
: "${BENCH_LARGE:=5 10 20}"
: "${BENCH_PAIRS:=5}"
: "${BENCH_MATCHES:=fig3:10 fig4a:10 fig5:10 fig7-isolated:10 figA:10}"
: "${BENCH_EQUAL:=fig3 fig4a fig5}"
THRESHOLD=1/4096 # the scenes' own
DECIBELS=45
TAB=$(printf '\t')

complain() {
    echo "bench: $*" >&2
    exit 2
}

# As complain(), for what went wrong while working.
give_up() {
    echo "bench: $*" >&2
    exit 1
}

# check_settings: all are what the stages can work with.
check_settings() {
    known=$("$superframe" scenes | cut -f 1 | tr '\n' ' ')
    for name in $BENCH_SCENES $BENCH_EQUAL; do
        case " $known" in
        *" $name "*) ;;
        *) complain "no built-in scene \"$name\"; allowed are: $known" ;;
        esac
    done
    for name in $BENCH_ARITHMETICS; do
        case $name in
        fx | f32 | f64 | f128) ;;
        *) complain "no arithmetic \"$name\"; allowed are: fx f32 f64 f128" ;;
        esac
    done
    for match in $BENCH_MATCHES; do
        case $match in
        *:*) BENCH_SMALL_CHECK="$BENCH_SMALL_CHECK ${match#*:}" ;;
        *) complain "BENCH_MATCHES: \"$match\" is no SCENE:DEPTH" ;;
        esac
    done
    for depth in $BENCH_SMALL $BENCH_LARGE $BENCH_SMALL_CHECK; do
        case $depth in
        *[!0-9]* | ????*) complain "no depth level \"$depth\"; allowed is: 0..255" ;;
        esac
    done
    case $BENCH_PAIRS in
    '' | 0* | *[!0-9]* | ????*) complain "BENCH_PAIRS: \"$BENCH_PAIRS\"; allowed is: 1..999" ;;
    esac
}
BENCH_SMALL_CHECK=

# times_for SECONDS: how many runs make up a third of a second, so that the kernel's clock of user
# time, which goes by samples, has enough of them.
times_for() {
    awk -v one="$1" 'BEGIN { n = one > 0 ? int(0.33 / one) + 1 : 20; print (n > 20 ? 20 : n) }'
}

# statistic NAME: a number of $out/stats.json.
statistic() {
    sed -n "s/^  \"$1\": \([-0-9.e+]*\),*\$/\1/p" "$out/stats.json"
}

# row FILE VALUE...: a line of a table.
row() {
    row_file=$1
    shift
    row_line=$1
    shift
    for row_value in "$@"; do
        row_line="$row_line$TAB$row_value"
    done
    printf '%s\n' "$row_line" >> "$row_file"
}

# begin_table FILE COLUMN...
begin_table() {
    rm -f "$1"
    row "$@"
}

# ours OPTION...: renders to $out/ours.png; its settings are those of `superframe render`.
ours() {
    "$superframe" render "$@" --colour full --quiet -o "$out/ours.png" 2>> "$out/log" ||
        give_up "superframe render $* failed; see $out/log"
}

# export_pov SCENE SIZE DEPTH THRESHOLD: to $out/theirs.pov.
export_pov() {
    "$superframe" export "$1" --pov --size "$2" --depth "$3" --threshold "$4" --colour full \
        -o "$out/theirs.pov" || give_up "superframe export $1 failed"
}

# POV-Ray's command line for SIZE: one thread, no antialiasing, no display, a PNG, as ours.
pov_options() {
    echo "+I$out/theirs.pov +O$out/theirs.png +W${1%x*} +H${1#*x} -A -D -V +WT1 File_Gamma=1.0"
}

# theirs SIZE: renders $out/theirs.pov to $out/theirs.png; its messages go to $out/povray.log.
theirs() {
    # shellcheck disable=SC2046 # a list of options
    timeout -k 10 300 povray $(pov_options "$1") < /dev/null > "$out/povray.log" 2>&1 ||
        give_up "povray failed or took more than 300 s; see $out/povray.log"
}

# Rays that POV-Ray has followed, of its last run.
their_rays() {
    sed -n 's/^Rays: *\([0-9]*\).*/\1/p' "$out/povray.log"
}

# user_of TIMES: the user CPU seconds of a line that `timed` has printed.
user_of() {
    # shellcheck disable=SC2086 # four numbers
    set -- $1
    echo "$2"
}

# time_ours SCENE SIZE DEPTH THRESHOLD TAIL ARITHMETIC TIMES OPTION...: wall, user, system seconds of
# one run on the average, memory in KiB.
time_ours() {
    time_scene=$1 time_size=$2 time_depth=$3 time_threshold=$4 time_tail=$5 time_arithmetic=$6
    time_times=$7
    shift 7
    "$tools/timed" "$time_times" "$superframe" render "$time_scene" --size "$time_size" \
        --depth "$time_depth" --threshold "$time_threshold" --tail "$time_tail" \
        --arith "$time_arithmetic" --colour full --quiet -o "$out/ours.png" "$@" 2>> "$out/log" ||
        give_up "superframe render $time_scene --depth $time_depth failed; see $out/log"
}

# time_theirs SIZE TIMES: of $out/theirs.pov.
time_theirs() {
    # shellcheck disable=SC2046 # a list of options
    "$tools/timed" "$2" timeout -k 10 600 povray $(pov_options "$1") < /dev/null 2> "$out/povray.log" ||
        give_up "povray failed or took more than 600 s; see $out/povray.log"
}
