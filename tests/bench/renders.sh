# SPDX-License-Identifier: MIT
# The stages of the bench that need no other renderer. Read by bench.sh.

# one_render SCENE SIZE DEPTH ARITHMETIC
one_render() {
    took=$(time_ours "$1" "$2" "$3" "$THRESHOLD" black "$4" 1 --stats "$out/stats.json") || exit 1
    times=$(times_for "$(user_of "$took")")
    [ "$times" -eq 1 ] ||
        took=$(time_ours "$1" "$2" "$3" "$THRESHOLD" black "$4" "$times") || exit 1
    # shellcheck disable=SC2086 # four numbers
    set -- "$@" $took
    rays=$(statistic rays)
    row "$out/renders.tsv" "$1" "${2%x*}" "$3" "$4" "$rays" "$(statistic shadow_rays)" \
        "$5" "$6" "$7" "$8" "$(statistic first_write_cpu_seconds)" \
        "$(awk -v u="$6" -v r="$rays" 'BEGIN { printf "%.2f", u / r * 1e9 }')"
}

# Whole renders: every scene, size, depth and arithmetic that is asked for.
stage_renders() {
    begin_table "$out/renders.tsv" scene width depth arithmetic rays shadow_rays wall_seconds \
        user_seconds system_seconds peak_kib first_write_seconds ns_a_ray
    for scene in $BENCH_SCENES; do
        for arithmetic in $BENCH_ARITHMETICS; do
            for depth in $BENCH_SMALL; do
                one_render "$scene" 320x200 "$depth" "$arithmetic"
            done
            for depth in $BENCH_LARGE; do
                one_render "$scene" 640x400 "$depth" "$arithmetic"
            done
        done
        echo "bench: renders of $scene are done"
    done
}

# Ports and board, the same with the hash, and the PNG, in a frame of 640 x 400.
stage_frame() {
    begin_table "$out/frame.tsv" scene port_writes ports_ms ports_largest_ms \
        observed_ms observed_largest_ms png_ms png_largest_ms
    for scene in $BENCH_SCENES; do
        frame=$("$tools/frame" "$scene" "$out") || exit 1
        # shellcheck disable=SC2086 # seven numbers
        row "$out/frame.tsv" "$scene" $frame
    done
}

# render_with JOBS NAME: the seconds by the clock of a render with so many workers go to $out/NAME.
render_with() {
    "$tools/timed" 1 "$superframe" render fig4a --size 640x400 --depth 10 --arith f64 \
        --colour full --quiet --jobs "$1" -o "$out/$2.png" > "$out/$2" 2>> "$out/log"
}

# One worker against two, in turn, and two renders of one worker each at once: what the machine has.
stage_jobs() {
    begin_table "$out/jobs.tsv" scene size depth arithmetic jobs1_seconds jobs2_seconds \
        two_at_once_seconds
    run=0
    while [ $run -lt "$BENCH_PAIRS" ]; do
        run=$((run + 1))
        for jobs in 1 2; do
            render_with $jobs jobs$jobs || give_up "superframe render fig4a --jobs $jobs failed; see $out/log"
        done
        render_with 1 once1 &
        render_with 1 once2 || give_up "two renders of fig4a at once failed; see $out/log"
        wait $! || give_up "two renders of fig4a at once failed; see $out/log"
        row "$out/jobs.tsv" fig4a 640x400 10 f64 "$(cut -d ' ' -f 1 "$out/jobs1")" \
            "$(cut -d ' ' -f 1 "$out/jobs2")" "$(cat "$out/once1" "$out/once2" | sort -n | tail -n 1 | cut -d ' ' -f 1)"
    done
}
