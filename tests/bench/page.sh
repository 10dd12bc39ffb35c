# SPDX-License-Identifier: MIT
# The page of the bench, its JSON and its plots, of whatever tables are there. Read by bench.sh.

# have NAME: the table is there and has rows.
have() {
    [ -f "$out/$1" ] && [ "$(wc -l < "$out/$1")" -gt 1 ]
}

# markdown FILE: a table as Markdown.
markdown() {
    awk -F "$TAB" '{
        printf "|"
        for (i = 1; i <= NF; i++) printf " %s |", $i
        print ""
        if (NR == 1) {
            printf "|"
            for (i = 1; i <= NF; i++) printf "---|"
            print ""
        }
    }' "$1"
}

machine() {
    cpu=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2> /dev/null | head -n 1)
    echo "cpu$TAB${cpu:-$(uname -m)}"
    echo "processors$TAB$(getconf _NPROCESSORS_ONLN)"
    compiler=$(cut -d ' ' -f 1 "$build/flags")
    echo "compiler$TAB$($compiler --version | head -n 1)"
    echo "flags$TAB$(sed -e 's/^[^ ]* //' -e 's/-O1 .*//' "$build/flags")"
    echo "load$TAB$(uptime | sed 's/.*average[s]*: *//')"
    if command -v povray > /dev/null 2>&1; then
        echo "povray$TAB$(povray --version 2>&1 | sed -n 's/.*POV-Ray \([0-9.]*\).*/POV-Ray \1/p' | head -n 1)"
    fi
}

summarise() {
    for name in pairs equal; do
        have $name.tsv || continue
        awk -f "$here/statistics.awk" -f "$here/ratios.awk" -v keys=4 -v top=6 -v bottom=5 \
            "$out/$name.tsv" > "$out/$name.ratios" || exit 1
    done
    # shellcheck disable=SC2046 # names without blanks
    awk -f "$here/statistics.awk" -f "$here/claims.awk" $(for name in renders.tsv frame.tsv jobs.tsv \
        pairs.ratios equal.ratios; do
        if have $name; then echo "$out/$name"; fi
    done
    [ ! -f "$kept_instructions" ] || echo "$kept_instructions") < /dev/null > "$out/claims.md" || exit 1
}

write_json() {
    printf '{\n  "machine": {'
    machine | awk -F "$TAB" '{
        gsub(/["\\]/, "\\\\&", $2)
        printf "%s\n    \"%s\": \"%s\"", (NR > 1 ? "," : ""), $1, $2
    }'
    printf '\n  }'
    for name in renders frame jobs pairs agreement settings equal; do
        have $name.tsv || continue
        printf ',\n  "%s": ' $name
        awk -f "$here/json.awk" "$out/$name.tsv" || return 1
    done
    for name in pairs equal; do
        have $name.ratios || continue
        printf ',\n  "%s_ratio": ' $name
        awk -f "$here/json.awk" "$out/$name.ratios" || return 1
    done
    printf '\n}\n'
}

# section FILE TITLE TEXT: a table of the page.
section() {
    have "$1" || return 0
    printf '\n## %s\n\n%s\n\n' "$2" "$3"
    markdown "$out/$1"
}

write_page() {
    cat << 'END'
# What a render costs

Made by `make bench`, kept by `make bench-keep`; `bench/bench.json` beside this page has every run.
Where povray is installed (`sh setup.sh pov`), it is compared with. `make bench BENCH=all` takes every
scene and N = 1..20; `tests/bench/settings.sh` lists what else can be set, and `make bench
STAGES='pairs page'` runs some stages only. A machine that does something else meanwhile makes the
times worse; instructions and rays stay.

END
    echo 'Measured on:'
    echo
    machine | sed 's/^\([^	]*\)	\(.*\)/- \1: \2/'
    printf '\n## What is asked for\n\n'
    cat "$out/claims.md"
    [ ! -f "$out/ratio.png" ] || printf '\n![POV-Ray over superframe](bench/ratio.png)\n'
    [ ! -f "$out/rays.png" ] || printf '\n![Nanoseconds a ray](bench/rays.png)\n'
    section pairs.ratios 'Against POV-Ray, the same N and threshold' \
        "User CPU seconds of the whole process: POV-Ray's over ours, in pairs, with the ratio's median, least and largest. POV-Ray renders the exported scene with the options +WT1 -A -D and the same \`max_trace_level\` and \`adc_bailout\` ($THRESHOLD); both write a PNG file. The runs go in turn: ours in each arithmetic, then POV-Ray, then again."
    section agreement.tsv 'The same picture' \
        'PSNR between the two programs of those pictures, ours in f64.'
    section settings.tsv 'At equal error: the settings' \
        "The setting with the fewest rays whose picture of 320 x 200 is within $DECIBELS dB of the converged one: for thresholds 1/32 to 1/8192 the least N up to 60, for ours with cut branches as black and as an estimate. The converged picture is ours for both, in f64 with N = 255 and threshold 1/65536: the two programs agree far better than $DECIBELS dB (above)."
    section equal.ratios 'At equal error: user CPU' "POV-Ray's over ours with those settings; N is ours."
    section frame.tsv 'Ports, board and PNG' \
        'CPU milliseconds of a frame of 640 x 400 whose rows are ready-made: 1,024,432 port writes to the board; the same through the hash of --stats (observed); the PNG with its file. Median and largest of 15.'
    section jobs.tsv 'Two workers' 'Seconds by the clock, in turn; two renders of one worker each at once tell what the two processors are worth.'
    section renders.tsv 'Whole renders' \
        'A render as it is called by the shell; user CPU and peak memory of the process. A ray is one of the tree (`rays` of --stats); shadow rays come on top. ns_a_ray is user CPU over rays; first_write_seconds is CPU time, the loading of the program included.'
    if [ -f "$kept_instructions" ]; then
        printf '\n## Instructions a ray\n\n'
        echo "Kept in \`bench/instructions.txt\`; \`make bench-check\` fails where one grows by more than 2 %. Counted by callgrind, all that a render does between the scene's loading and the PNG."
        printf '\n```\n'
        cat "$kept_instructions"
        printf '```\n'
    fi
}

# Data for gnuplot: a block for each arithmetic.
write_plot_data() {
    for arithmetic in $BENCH_ARITHMETICS; do
        awk -F "$TAB" -v a="$arithmetic" 'FNR > 1 && $4 == a && $1 == "fig4a" && $2 == 640 { print $3, $12 }' \
            "$out/renders.tsv" > "$out/rays-$arithmetic.dat"
        [ ! -f "$out/pairs.ratios" ] || awk -F "$TAB" -v a="$arithmetic" \
            'FNR > 1 && $4 == a { print "\"" $1 "\\nN = " $3 "\"", $6, $7, $8 }' \
            "$out/pairs.ratios" > "$out/ratio-$arithmetic.dat"
    done
}

plot() {
    if ! command -v gnuplot > /dev/null 2>&1; then
        echo 'bench: no plots: there is no gnuplot (sh setup.sh paper)'
        return 0
    fi
    ! have renders.tsv || write_plot_data
    rm -f "$out/ratio.png" "$out/rays.png"
    for name in rays ratio; do
        if [ -s "$out/$name-f64.dat" ]; then
            gnuplot -e "folder='$out'; arithmetics='$BENCH_ARITHMETICS'" "$here/$name.gp" ||
                give_up "gnuplot failed on $name.gp"
        fi
    done
}

stage_page() {
    kept_instructions=$here/../../docs/bench/instructions.txt
    summarise
    plot
    write_json > "$out/bench.json" || exit 1
    write_page > "$out/bench.md" || exit 1
    cat "$out/claims.md"
    echo "bench: the page is $out/bench.md"
}
