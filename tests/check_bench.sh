#!/bin/sh
# SPDX-License-Identifier: MIT
# The bench's own reckoning, by tables worked out by hand, and what it says of bad input.
# Exit status: 0 all hold, 1 one does not.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
bench=tests/bench
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

wrong() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

# is NAME FOUND ASKED
is() {
    [ "$2" = "$3" ] || wrong "$1: found \"$2\", not \"$3\""
}

# expect NAME STATUS WORDS COMMAND...: the exit status, and what is printed.
expect() {
    name=$1 status=$2 words=$3
    shift 3
    "$@" > "$folder/out" 2>&1 < /dev/null
    found=$?
    [ $found -eq "$status" ] || wrong "$name: exit status $found, not $status: $(head -n 3 "$folder/out")"
    grep -q -- "$words" "$folder/out" || wrong "$name: says \"$(head -n 2 "$folder/out")\", not \"$words\""
}

# table LINE...: blanks become tabs.
table() {
    printf '%s\n' "$@" | tr ' ' '\t'
}

# ---- Medians and ratios ---------------------------------------------------------------------

median_of() {
    awk -f $bench/statistics.awk -f /dev/stdin "$@" << 'END'
BEGIN {
    for (i = 1; i < ARGC; i++) values[i] = ARGV[i]
    sort_values(values, ARGC - 1)
    print median(values, ARGC - 1), values[1], values[ARGC - 1]
    exit
}
END
}
is 'one value' "$(median_of 7)" '7 7 7'
is 'an odd count' "$(median_of 9 -2 10)" '9 -2 10'
is 'an even count' "$(median_of 4 1 3 2)" '2.5 1 4'
is 'numbers, not words' "$(median_of 10 9 100)" '10 9 100'
is 'equal values' "$(median_of 5 5 5 1)" '5 1 5'

ratios() {
    awk -f $bench/statistics.awk -f $bench/ratios.awk -v keys=2 -v top=4 -v bottom=3 "$1"
}
# Ratios 2, 4 and 3 of the first; 10 of the second, whose row lies between.
table 'scene arith ours theirs' 'a f64 1 2' 'b fx 0.5 5' 'a f64 2 8' 'a f64 3 9' > "$folder/pairs.tsv"
is 'ratios' "$(ratios "$folder/pairs.tsv")" "$(table 'scene arith pairs median least largest ours theirs' \
    'a f64 3 3.000 2.000 4.000 2.0000 8.0000' 'b fx 1 10.000 10.000 10.000 0.5000 5.0000')"
table 'scene arith ours theirs' 'a f64 1' > "$folder/torn.tsv"
expect 'a torn row' 2 'torn.tsv:2: no pair of seconds' ratios "$folder/torn.tsv"
table 'scene arith ours theirs' 'a f64 0 3' > "$folder/zero.tsv"
expect 'no time at all' 2 'no pair of seconds: "3" over "0"' ratios "$folder/zero.tsv"

# ---- JSON -----------------------------------------------------------------------------------

{
    printf 'name\tvalue\n'
    printf 'a "b" \\c\t0.50\n'
    printf '1/128\t1e-3\n'
} > "$folder/table.tsv"
is 'JSON' "$(awk -f $bench/json.awk "$folder/table.tsv" | tr -d '\n')" \
    '[    {"name": "a \"b\" \\c", "value": 0.50},    {"name": "1/128", "value": 1e-3}  ]'
is 'JSON without rows' "$(table 'name value' | awk -f $bench/json.awk)" '[]'

# ---- What is asked for ----------------------------------------------------------------------

claims() {
    awk -f $bench/statistics.awk -f $bench/claims.awk "$@" < /dev/null
}
heads='scene width depth arithmetic rays shadow wall user system peak_kib first ns_a_ray'
table "$heads" 'fig3 320 5 f64 100 0 1 1 0 5000 0.002 100' 'fig3 640 5 f64 405 0 1 1 0 7812 0.0099 100' \
    'fig3 640 20 f64 900 0 1 1 0 6000 0.004 109' > "$folder/renders.tsv"
claims "$folder/renders.tsv" > "$folder/good.md"
grep -q '9.9 ms | yes' "$folder/good.md" || wrong 'first write: the largest counts'
grep -q '8.0 MB | yes' "$folder/good.md" || wrong 'peak: the largest counts, in MB of 1,000,000'
grep -q '4.05 (fig3, N = 5) | yes' "$folder/good.md" || wrong 'rays by size'
grep -q '9.0 % (fig3, f64) | yes' "$folder/good.md" || wrong 'the cost of a ray'
sed -e 's/109$/111/' -e 's/	405	/	415	/' -e 's/7812/7813/' -e 's/0.0099/0.0100/' \
    "$folder/renders.tsv" > "$folder/bad.tsv" && mv "$folder/bad.tsv" "$folder/renders.tsv"
is 'four that do not hold' "$(claims "$folder/renders.tsv" | grep -c '\*\*no\*\*')" 4
table 'scene size depth arithmetic pairs median least largest ours theirs' \
    'fig3 640x400 10 fx 5 4.1 4 5 1 4' 'fig3 640x400 10 f32 5 19 18 21 1 19' \
    'fig3 640x400 10 f64 5 22 21 23 1 22' 'figA 640x400 10 f64 5 9 8 10 1 9' > "$folder/pairs.ratios"
claims "$folder/pairs.ratios" > "$folder/pairs.md"
grep -q '20 | 22.00 (fig3, N = 10) | yes' "$folder/pairs.md" || wrong 'the faster of f32 and f64 counts'
grep -q '4 | 4.10 (fig3, N = 10) | yes' "$folder/pairs.md" || wrong 'fx counts by itself'
grep -q '10 | 9.00 (figA, N = 10) | \*\*no\*\*' "$folder/pairs.md" || wrong 'the small scenes'

# Speedups 2, 1.5 and 1.8; two renders at once take as long as one, twice as long, and 1.25 times.
table 'scene size depth arithmetic jobs1 jobs2 at_once' 'a b 1 f64 2 1 2' 'a b 1 f64 3 2 6' \
    'a b 1 f64 1.8 1 2.25' > "$folder/jobs.tsv"
claims "$folder/jobs.tsv" > "$folder/jobs.md"
grep -q '1.9 | 1.80 (1.50 to 2.00) | \*\*no\*\*' "$folder/jobs.md" || wrong 'two workers'
grep -q '|  | 1.60 (1.00 to 2.00) |  |' "$folder/jobs.md" || wrong 'two renders at once'
printf '# kept\n%s\n%s\n%s\n%s\n' 'fig3 f64 5 640x400 0:8 10 1000 100.00' \
    'fig3 f64 20 640x400 0:8 10 1090 109.00' 'fig5 f64 5 640x400 0:8 10 1000 100.00' \
    'fig5 f64 5 320x200 0:8 10 1000 200.00' > "$folder/instructions.txt"
claims "$folder/instructions.txt" > "$folder/counted.md"
grep -q '9.0 % (fig3, f64) | yes' "$folder/counted.md" || wrong 'a ray in instructions, of the large size alone'

# ---- Instructions a ray ---------------------------------------------------------------------

growth() {
    awk -v percent=2 -v kept=kept.txt -f $bench/growth.awk "$@"
}
kept='# kept\nfig3 fx 10 320x200 8:9 10 1000 100.00\nfig5 f64 10 320x200 8:9 10 500 50.00\n'
# shellcheck disable=SC2059 # the format is the text
printf "$kept" > "$folder/kept.txt"
sed 's/100.00/102.00/' "$folder/kept.txt" > "$folder/found.txt"
expect 'two per cent more' 0 ' 0 wrong against kept.txt' growth "$folder/kept.txt" "$folder/found.txt"
sed 's/100.00/102.01/' "$folder/kept.txt" > "$folder/found.txt"
expect 'more than two' 1 'fig3 fx N=10 .*has grown by more than 2 %' growth "$folder/kept.txt" "$folder/found.txt"
sed 's/50.00/30.00/' "$folder/kept.txt" > "$folder/found.txt"
expect 'fewer' 0 'better: make bench-instructions-keep' growth "$folder/kept.txt" "$folder/found.txt"
head -n 2 "$folder/kept.txt" > "$folder/found.txt"
expect 'one less' 1 'fig5 f64 .*is kept and was not measured' growth "$folder/kept.txt" "$folder/found.txt"
expect 'one more' 1 'fig5 f64 .*nothing is kept of it' growth "$folder/found.txt" "$folder/kept.txt"
echo 'fig5 f64 10 320x200' >> "$folder/found.txt"
expect 'a torn line' 1 'found.txt:3: no row of eight columns' growth "$folder/kept.txt" "$folder/found.txt"

# ---- Bad usage ------------------------------------------------------------------------------

bench() {
    env "$1" sh $bench/bench.sh "$BUILD" renders
}
[ -x "$BUILD/release/tests/bench/timed" ] && [ -x "$BUILD/superframe" ] || wrong "$BUILD: make bench has built nothing"
expect 'no folder' 2 'usage' sh $bench/bench.sh
expect 'an empty folder' 2 'holds no bench' sh $bench/bench.sh "$folder"
expect 'an unknown stage' 2 'no stage "rendering"; allowed are' sh $bench/bench.sh "$BUILD" rendering
expect 'an unknown scene' 2 'no built-in scene "fig9"' bench BENCH_SCENES=fig9
expect 'an unknown arithmetic' 2 'no arithmetic "f16"' bench BENCH_ARITHMETICS=f16
expect 'no depth' 2 'no depth level "ten"' bench BENCH_SMALL=ten
expect 'no pair' 2 'allowed is: 1..999' bench BENCH_PAIRS=0
expect 'a match without N' 2 '"fig3" is no SCENE:DEPTH' bench BENCH_MATCHES=fig3
expect 'instructions without what' 2 usage sh $bench/instructions.sh "$BUILD"
expect 'nothing kept' 2 'none.txt cannot be read' sh $bench/instructions.sh "$BUILD" check "$folder/none.txt"

# A program that knows its scenes and renders none.
mkdir -p "$folder/broken/release/tests"
ln -s "$(cd "$BUILD" && pwd)/release/tests/bench" "$folder/broken/release/tests/bench"
printf '#!/bin/sh\n[ "$1" = scenes ] && "%s" scenes && exit 0\necho no >&2\nexit 1\n' \
    "$(cd "$BUILD" && pwd)/superframe" > "$folder/broken/superframe"
chmod +x "$folder/broken/superframe"
expect 'a render that fails' 1 'superframe render fig3 --depth 1 failed' \
    sh $bench/bench.sh "$folder/broken" renders

# Where there is no povray, that is said and no more.
mkdir "$folder/bin"
for tool in sh awk sed cut tr date mkdir dirname cat; do
    ln -s "$(command -v $tool)" "$folder/bin/$tool"
done
expect 'no povray' 0 'there is no povray' env "PATH=$folder/bin" sh $bench/bench.sh "$BUILD" pairs equal

# ---- The tools ------------------------------------------------------------------------------

timed=$BUILD/release/tests/bench/timed
expect 'a run' 0 '^[0-9.]* [0-9.]* [0-9.]* [0-9]*$' "$timed" 2 true
expect 'a run that fails' 1 'exit status 1' "$timed" 1 false
expect 'a program that is not there' 1 'No such file' "$timed" 1 "$folder/none"
expect 'no times' 2 usage "$timed" 0 true
# Two runs that each sleep for 50 ms: the mean is one of them, and little CPU.
is 'the mean of runs' "$("$timed" 2 sleep 0.05 | awk '{ print ($1 >= 0.05 && $1 < 1 && $2 + $3 < 0.05) }')" 1
is 'user CPU' "$("$timed" 1 awk 'BEGIN { for (i = 0; i < 3000000; i++) n += i }' |
    awk '{ print ($2 > 0.01 && $2 > $3 && $4 > 500) }')" 1

psnr=$BUILD/release/tests/bench/psnr
"$BUILD/superframe" render figA --size 8x6 --depth 0 --quiet -o "$folder/a.png" || wrong 'no picture'
is 'the same picture' "$("$psnr" "$folder/a.png" "$folder/a.png")" 999.000
expect 'no picture' 2 'cannot be read' "$psnr" "$folder/a.png" "$folder/none.png"
expect 'no PNG' 2 'psnr: ' "$psnr" "$folder/a.png" "$0"
expect 'one picture only' 2 usage "$psnr" "$folder/a.png"
"$BUILD/superframe" render fig3 --size 8x6 --depth 0 --quiet -o "$folder/b.png" || wrong 'no picture'
is 'as superframe compare' "$("$psnr" "$folder/a.png" "$folder/b.png")" \
    "$("$BUILD/superframe" compare "$folder/a.png" "$folder/b.png" --within 255 --json |
        awk '/"psnr"/ { printf "%.3f", $2 + 0 }')"
# Black and white; then the same with 2 x 2 dots a pixel, of which the red of one is 51 off: of 24
# values one, 10 log10(255^2 / (51^2 / 24)) = 27.782 dB.
pixels=iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR42mNgYGD4//8/AAYBAv67yYXpAAAAAElFTkSuQmCC
dots=iVBORw0KGgoAAAANSUhEUgAAAAQAAAACCAIAAADwyuo0AAAAFklEQVR42mNgYGAwZmD4DwYMEADhAAB8BAwoMBNWRQAAAABJRU5ErkJggg==
echo $pixels | base64 -d > "$folder/pixels.png"
echo $dots | base64 -d > "$folder/dots.png"
is 'dots against pixels' "$("$psnr" "$folder/dots.png" "$folder/pixels.png")" 27.782
is 'pixels against dots' "$("$psnr" "$folder/pixels.png" "$folder/dots.png")" 27.782
expect 'sizes that do not go together' 2 'is 2 x 1 and .* 640 x 400' "$psnr" "$folder/pixels.png" "$folder/a.png"

echo "bench: $failures wrong"
[ $failures -eq 0 ]
