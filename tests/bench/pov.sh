# SPDX-License-Identifier: MIT
# The stages of the bench against POV-Ray. Read by bench.sh.

need_pov() {
    command -v povray > /dev/null 2>&1 && return 0
    echo 'bench: no comparison: there is no povray (sh setup.sh pov)'
    return 1
}

# rounds FILE SCENE SIZE DEPTH THRESHOLD TAIL: runs in turn, ours in each arithmetic with these
# settings, then theirs of $out/theirs.pov, so that what else the machine does meets both.
rounds() {
    table=$1
    shift
    first=$(time_theirs "$2" 1) || exit 1
    theirs_times=$(times_for "$(user_of "$first")")
    [ "$theirs_times" -le 2 ] || theirs_times=2 # each waits for most of a second by itself
    for arithmetic in $BENCH_ARITHMETICS; do
        first=$(time_ours "$1" "$2" "$3" "$4" "$5" "$arithmetic" 1) || exit 1
        times_for "$(user_of "$first")" > "$out/times-$arithmetic"
    done
    round=0
    while [ $round -lt "$BENCH_PAIRS" ]; do
        round=$((round + 1))
        for arithmetic in $BENCH_ARITHMETICS; do
            time_ours "$1" "$2" "$3" "$4" "$5" "$arithmetic" "$(cat "$out/times-$arithmetic")" \
                > "$out/took-$arithmetic" || exit 1
        done
        theirs_took=$(time_theirs "$2" "$theirs_times") || exit 1
        for arithmetic in $BENCH_ARITHMETICS; do
            row "$table" "$1" "$2" "$3" "$arithmetic" "$(user_of "$(cat "$out/took-$arithmetic")")" \
                "$(user_of "$theirs_took")"
        done
    done
}

# The same scene, N and threshold.
stage_pairs() {
    need_pov || return 0
    begin_table "$out/pairs.tsv" scene size depth arithmetic ours_user_seconds pov_user_seconds
    begin_table "$out/agreement.tsv" scene size depth psnr_db
    for match in $BENCH_MATCHES; do
        scene=${match%:*} depth=${match#*:}
        export_pov "$scene" 640x400 "$depth" "$THRESHOLD"
        rounds "$out/pairs.tsv" "$scene" 640x400 "$depth" "$THRESHOLD" black
        ours "$scene" --size 640x400 --depth "$depth" --arith f64
        row "$out/agreement.tsv" "$scene" 640x400 "$depth" \
            "$("$tools/psnr" "$out/ours.png" "$out/theirs.png")"
        echo "bench: pairs of $scene, N = $depth, are done"
    done
}

# ---- At equal error -------------------------------------------------------------------------

# Each tries a setting and sets rays, and is_near: as near to the converged picture as asked for.
try_ours() { # SCENE DEPTH THRESHOLD TAIL
    ours "$1" --size 320x200 --depth "$2" --threshold "$3" --tail "$4" --arith f64 \
        --stats "$out/stats.json"
    rays=$(statistic rays)
    judge "$out/ours.png" "$1"
}
try_theirs() { # SCENE DEPTH THRESHOLD
    export_pov "$1" 320x200 "$2" "$3"
    theirs 320x200
    rays=$(their_rays)
    judge "$out/theirs.png" "$1"
}
judge() { # PICTURE SCENE
    decibels=$("$tools/psnr" "$1" "$out/converged-$2.png") || exit 1
    is_near=$(awk -v found="$decibels" -v asked="$DECIBELS" 'BEGIN { print (found >= asked) }')
}

# least_depth TRY SCENE THRESHOLD TAIL MOST: sets depth, rays and decibels for the least N, 1..MOST,
# that is near enough; false if none is. Errors fall with N, so that halving finds it.
least_depth() {
    low=0 high=$5
    $1 "$2" "$high" "$3" "$4"
    [ "$is_near" -eq 1 ] || return 1
    found="$high $rays $decibels"
    while [ $((high - low)) -gt 1 ]; do
        middle=$(((low + high) / 2))
        $1 "$2" $middle "$3" "$4"
        if [ "$is_near" -eq 1 ]; then
            high=$middle
            found="$high $rays $decibels"
        else
            low=$middle
        fi
    done
    depth=${found%% *}
    decibels=${found##* }
    rays=${found#* }
    rays=${rays% *}
}

# cheapest TRY NAME SCENE TAIL...: the setting with the fewest rays, as a row of settings.tsv; leaves it
# in best: depth, threshold, tail. A finer threshold needs no larger N, and once it costs more
# than the one before, still finer ones do as well.
cheapest() {
    try=$1 name=$2 scene=$3
    shift 3
    least= best=
    for tail in "$@"; do
        most=60 before=
        for threshold in 1/32 1/64 1/128 1/256 1/512 1/1024 1/2048 1/4096 1/8192; do
            least_depth "$try" "$scene" "$threshold" "$tail" $most || continue
            most=$depth
            if [ -z "$least" ] || [ "$rays" -lt "$least" ]; then
                least=$rays
                best="$depth $threshold $tail $decibels"
            fi
            [ -z "$before" ] || [ "$rays" -lt "$before" ] || break
            before=$rays
        done
    done
    [ -n "$best" ] || give_up "$scene: no setting of $name is within $DECIBELS dB"
    # shellcheck disable=SC2086 # four words
    row "$out/settings.tsv" "$scene" "$name" $best "$least"
}

# kept TRY NAME SCENE: what `make bench-keep` has kept of cheapest(), as cheapest() leaves it; false if
# nothing is, or if it is no longer the least N that is near enough.
kept() {
    # shellcheck disable=SC2046 # words
    set -- "$@" $(awk -F "$TAB" -v name="$2" -v scene="$3" '$1 == scene && $2 == name { print $3, $4, $5 }' \
        "$here/../../docs/bench/settings.tsv" 2> /dev/null)
    [ $# -eq 6 ] && [ "${BENCH_SEARCH:-no}" != yes ] || return 1
    $1 "$3" $(($4 - 1)) "$5" "$6"
    [ "$is_near" -eq 0 ] || return 1
    $1 "$3" "$4" "$5" "$6"
    [ "$is_near" -eq 1 ] || return 1
    best="$4 $5 $6 $decibels"
    # shellcheck disable=SC2086 # four words
    row "$out/settings.tsv" "$3" "$2" $best "$rays"
}

stage_equal() {
    need_pov || return 0
    begin_table "$out/settings.tsv" scene program depth threshold tail psnr_db rays
    begin_table "$out/equal.tsv" scene size depth arithmetic ours_user_seconds pov_user_seconds
    for scene in $BENCH_EQUAL; do
        ours "$scene" --size 320x200 --depth 255 --threshold 1/65536 --arith f64
        mv "$out/ours.png" "$out/converged-$scene.png"
        kept try_theirs povray "$scene" || cheapest try_theirs povray "$scene" black
        # shellcheck disable=SC2086 # words
        set -- $best
        export_pov "$scene" 320x200 "$1" "$2"
        kept try_ours superframe "$scene" || cheapest try_ours superframe "$scene" black estimate
        # shellcheck disable=SC2086 # words
        set -- $best
        rounds "$out/equal.tsv" "$scene" 320x200 "$1" "$2" "$3"
        echo "bench: $scene at equal error is done"
    done
}
