#!/bin/sh
# SPDX-License-Identifier: MIT
# superframe measure and compare as their users call them: results, going on, refusals.
# Exit status: 0 all hold, 1 one does not.
set -u
cd "$(dirname "$0")/.." || exit 1
program=${SUPERFRAME:-${BUILD:-build}/sanitized/superframe}
case $program in
/*) ;;
*) program=$PWD/$program ;;
esac
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

wrong() {
    echo "$*"
    failures=$((failures + 1))
}

# expect STATUS WORDS COMMAND...: the exit status, and what standard error says.
expect() {
    status=$1
    words=$2
    shift 2
    "$program" "$@" > out.txt 2> err.txt < /dev/null
    found=$?
    [ $found -eq "$status" ] || wrong "$*: exit status $found, not $status: $(head -n 3 err.txt)"
    [ -z "$words" ] || grep -q -- "$words" err.txt || wrong "$*: says \"$(head -n 1 err.txt)\", not \"$words\""
}

cat > ball.scene << 'END'
version = 1;
size = [16, 10];
depth = 4;
camera = { eye = (0, -6, 1); look_at = (0, 0, 0); };
lights = ( { direction = (-1, 1, -1); } );
materials = { glass = { colour = [90, 40, 20]; diffuse = 0.5; specular = 0.5; ior = 1.5; }; };
objects = ( { material = "glass"; solid = { ball = { radius = 1; }; }; } );
END

# A whole measurement of few points, then the same with half of its lines and a torn one.
points='--arith fx --size 16x10 --depth 3 --quiet'
# shellcheck disable=SC2086 # a list of options
expect 0 '' measure ball.scene $points -o m
for file in points.csv table.csv report.md report.html plots.gp plots.dat; do
    [ -s "m/$file" ] || wrong "m/$file: is not there"
done
whole=$(wc -l < m/points.csv)
[ "$whole" -gt 10 ] || wrong "points.csv has $whole lines"
grep -q '^ball,fx,3,0,16,10,full,fresnel,black,0,' m/points.csv || wrong 'a point is missing'
grep -q '^ball,fx,3,0,16,10,full,fresnel,estimate,1,' m/points.csv || wrong 'no point of --error 1'
head -n 4 m/points.csv > kept.csv
{ cat kept.csv && printf 'ball,fx,3,0.0009765625,16,10,full,fresnel,black,0,12,'; } > m/points.csv
# shellcheck disable=SC2086
expect 0 '' measure ball.scene $points -o m
[ "$(head -n 4 m/points.csv)" = "$(cat kept.csv)" ] || wrong 'what was there was measured again'
[ "$(grep -c '^ball,fx,3.*,[0-9a-f]\{16\}$' m/points.csv)" -ge $((whole - 1)) ] || wrong 'points are missing'
cp m/points.csv before.csv
# shellcheck disable=SC2086
expect 0 '' measure ball.scene $points -o m
cmp -s m/points.csv before.csv || wrong 'a finished measurement was not left alone'

# Killed before the first point: the head is not there, or a part of it.
for bytes in 0 1 100; do
    mkdir early && head -c $bytes before.csv > early/points.csv
    # shellcheck disable=SC2086
    expect 0 '' measure ball.scene $points -o early
    [ "$(head -n 1 early/points.csv)" = "$(head -n 1 before.csv)" ] || wrong "$bytes bytes of points.csv: no head"
    [ "$(wc -l < early/points.csv)" -eq "$whole" ] || wrong "$bytes bytes of points.csv: points are missing"
    rm -r early
done
# shellcheck disable=SC2086
(PATH=/nonexistent && "$program" measure ball.scene $points -o m 2> err.txt) || wrong 'no gnuplot: failed'
grep -q 'gnuplot is not there' err.txt || wrong "no gnuplot: says \"$(cat err.txt)\""


# Of few points, or of an arithmetic that some machines have no entry for, there are plots too.
if command -v gnuplot > few.txt; then
    for few in '--arith fx --depth 2 --threshold 0 --tail black' '--arith f64 --error 1' '--arith fx --error 1'; do
        # shellcheck disable=SC2086
        expect 0 '' measure ball.scene $few --size 16x10 --quiet -o few
        [ ! -s err.txt ] || wrong "measure $few: says \"$(head -n 1 err.txt)\""
        [ -s few/pareto-x86_64.png ] || wrong "measure $few: no plots"
        for picture in $(sed -n "s/^set output '\(.*\)'$/\1/p" few/plots.gp); do
            [ -s "few/$picture" ] || wrong "measure $few: $picture is not drawn"
        done
        for page in few/report.md few/report.html; do
            [ "$(grep -c 'pareto-.*\.png' $page)" -eq "$(grep -c '^set output .pareto-' few/plots.gp)" ] ||
                wrong "measure $few: $page does not show each machine's plot"
        done
        rm -r few
    done
fi

# Interrupted, it says how to go on, and what was measured stays.
timeout --preserve-status -s INT 2 "$program" measure fig3 --arith f64 --size 320x200 --quiet -o interrupted 2> err.txt
[ $? -eq 130 ] || wrong 'an interrupt: not exit status 130'
grep -q 'interrupted; started again with the same -o it goes on' err.txt || wrong "an interrupt: says \"$(cat err.txt)\""
[ -s interrupted/points.csv ] || wrong 'an interrupt: no points.csv'

# A full disk, half-way: what was there stays whole.
cp -r m old
# shellcheck disable=SC2086
(ulimit -f 1 && trap '' XFSZ && "$program" measure ball.scene $points -o m > out.txt 2> err.txt)
[ $? -eq 1 ] || wrong 'a full disk: not exit status 1'
diff -r m old > differences.txt || wrong "a full disk: $(head -n 3 differences.txt)"
long=$(printf '%0200d' 0)
long=$long/$long/$long/$long/$long/$long
mkdir -p "$long"
# shellcheck disable=SC2086
expect 0 '' measure ball.scene $points -o "$long"
for file in $(cd m && ls); do
    [ -s "$long/$file" ] || wrong "in a folder with a long name: $file is not there"
done

# What was measured of a scene does not go with what it was changed into.
sed -i 's/ior = 1.5/ior = 1.6/' ball.scene
# shellcheck disable=SC2086
expect 2 'm/points.csv: its points of "ball" are of another scene' measure ball.scene $points -o m
cmp -s m/points.csv before.csv || wrong 'the points of the scene as it was were touched'
sed -i 's/ior = 1.6/ior = 1.5/; s/^version/# as it was\nversion/' ball.scene
# shellcheck disable=SC2086
expect 0 '' measure ball.scene $points -o m
cmp -s m/points.csv before.csv || wrong 'a comment made another scene'

# Nor with what an option makes of it that no column tells.
for option in '--highlight blinn' '--seed 2'; do
    # shellcheck disable=SC2086
    expect 2 'm/points.csv: its points of "ball" are of another scene' measure ball.scene $points $option -o m
done
cmp -s m/points.csv before.csv || wrong 'points with another highlight or seed were touched'

expect 0 '' measure ball.scene --arith fx --size 16x10 --error 0.7 --quiet -o e
grep -q '^ball,fx,64,0,16,10,full,fresnel,estimate,0.7,' e/points.csv || wrong '--error does not fix the accuracy'
grep -q ',estimate,1,' e/points.csv && wrong '--error leaves others'
rays=$("$program" render ball.scene --error 0.7 --size 16x10 --colour full --quiet -o e.png --stats - |
    sed -n 's/^ *"rays": \([0-9]*\),.*/\1/p')
[ "$(sed -n 's/^ball,fx,64,0,.*,estimate,0.7,\([0-9]*\),.*/\1/p' e/points.csv)" = "$rays" ] ||
    wrong "--error 0.7: not the $rays rays of render"
grep -q 'fx|0.7|' e/report.md || wrong 'the report lacks the accuracy asked for'

expect 2 'measure: -o FOLDER is missing' measure ball.scene
expect 2 'exposures is not measured' measure ball.scene --colour exposures -o n
expect 2 'allowed is: up to 320 x 200, or another colour' measure ball.scene --colour dither --size 321x1 -o n
expect 2 'nothing' measure nothing -o n
[ ! -e n ] || wrong 'a folder was made for a scene that is not there'
# Names that would end a cell of a table or begin a tag.
for name in 'a,b' 'a|b' 'a<b' 'a>b' 'a&b' "a'b" 'a"b'; do
    cp ball.scene "$name.scene"
    expect 2 'allowed are: names without' measure "$name.scene" -o n
done
[ ! -e n ] || wrong 'a folder was made for a scene whose name is invalid'
expect 2 'two scenes are called' measure ball.scene ./ball.scene -o n
expect 1 'cannot be written' measure ball.scene -o /dev/null/n
mkdir -p other && echo 'a,b' > other/points.csv
expect 2 'does not begin' measure ball.scene -o other

"$program" measure fig3 --size 160x100 --quiet -o begun 2> /dev/null &
for attempt in $(seq 100); do
    [ -s begun/points.csv ] && break
    sleep 0.1
done
[ "$(head -n 1 begun/points.csv)" = "$(head -n 1 before.csv)" ] || wrong "no head after $attempt tenths of a second"
kill -KILL $! && wait $! 2> /dev/null

# Pictures and signatures.
expect 0 '' render ball.scene -o a.png --signatures a.sig --quiet
expect 0 '' render ball.scene --arith f64 -o b.png --signatures b.sig --jobs 2 --quiet
expect 0 '' compare a.png b.png --signatures a.sig b.sig --difference d.png
grep -q '^CIEDE2000 ' out.txt || wrong 'compare: no CIEDE2000'
grep -q '^flips  *0 of 160' out.txt || wrong "compare: $(grep flips out.txt)"
[ -s d.png ] || wrong 'compare: no picture of the difference'
expect 0 '' compare --signatures a.sig b.sig --json
grep -q '"flips": 0' out.txt || wrong 'compare --json: no flips'
expect 0 '' render ball.scene --depth 0 -o c.png --signatures c.sig --quiet
expect 3 'of the signatures are equal' compare --signatures a.sig c.sig
expect 2 'is missing' compare --signatures a.sig
expect 2 'B.sig is missing' compare a.png b.png --signatures a.sig
expect 2 'B.png is missing' compare a.png
expect 2 'one too many' compare a.png b.png c.png
expect 2 'two pictures only' compare --signatures a.sig b.sig --difference e.png
# Also from pipes, and in any place; a file that is damaged is what is complained about.
mkfifo pipe.sig pipe.png
cat b.sig > pipe.sig &
expect 0 '' compare --signatures a.sig pipe.sig
cat b.sig > pipe.sig &
cat a.png > pipe.png &
expect 0 '' compare pipe.sig pipe.png b.png --signatures a.sig
echo 'superframe' > damaged.sig
expect 2 'damaged.sig: is no file of signatures' compare --signatures a.sig damaged.sig
echo 'other' > damaged.sig
expect 2 'damaged.sig: is no file of signatures' compare --signatures a.sig damaged.sig
expect 2 'damaged.sig: is no file of signatures' compare a.png b.png damaged.sig --signatures a.sig
head -c 100 a.sig > torn.sig
expect 2 'ends too early' compare --signatures a.sig torn.sig
expect 2 'is no file of signatures' compare a.png b.png --signatures a.png b.sig
expect 1 'cannot be written' compare a.png b.png --difference nowhere/d.png
expect 1 'full' render ball.scene -o /dev/null --signatures /dev/full --quiet
expect 2 'same place' render ball.scene -o x --signatures x --quiet

echo "measure: $failures wrong"
[ $failures -eq 0 ]
