#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds the man pages to the program: each command stands in the synopsis, each option that a
# command's --help lists has an entry of its own, and no entry is about an option that is none. The
# keys of --stats are those of the page, both ways.
#
# SUPERFRAME  the program (default: $BUILD/superframe). Exit status: 0 all are there, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
SUPERFRAME=${SUPERFRAME:-${BUILD:-build}/superframe}
page=docs/superframe.1
failures=0

complain() {
    echo "check_manual: $*"
    failures=$((failures + 1))
}

# The options that an entry begins with: the line behind a .TP, without roff's backslashes.
entries() {
    sed 's/\\-/-/g' "$@" | grep -A 1 '^\.TP' | grep '^\.B' |
        grep -o -- '--[a-z][a-z-]*[a-z]' | sort -u
}

commands=$("$SUPERFRAME" --help | sed -n '/^superframe help/q; s/^  \([a-z]*\) .*/\1/p')
[ -n "$commands" ] || complain "$SUPERFRAME --help lists no command"
known=$(entries $page docs/superframe-trace.1)
all=
for command in $commands; do
    grep -q "^\.B superframe $command" $page || complain "$page: no synopsis of $command"
    options=$("$SUPERFRAME" "$command" --help | sed -n 's|^ *\(-., \)\{0,1\}\(--[a-z-]*\).*|\2|p')
    [ -n "$options" ] || complain "$command --help lists no option"
    all="$all $options"
    for option in $options; do
        printf '%s\n' "$known" | grep -q -x -e "$option" ||
            complain "$page: --help of $command lists $option, which has no entry"
    done
done
for option in $known; do
    case " $(echo $all) " in
    *" $option "*) ;;
    *) complain "man page: $option is no option of any command" ;;
    esac
done

# What the page's STATISTICS call keys: the words in bold that are neither options nor commands.
keys_of_page() {
    sed -n '/^\.SH STATISTICS/,/^\.SH EXIT/p' $page | tr '\n' ' ' | grep -o '\\fB[^\\]*\\fR' |
        sed 's/^\\fB//; s/\\fR$//' | tr ' ' '\n' | grep -E '^[a-zA-Z0-9_]+$' |
        grep -vxE 'replay|boot|render|hid' | sort -u
}

keys_of_run() {
    grep -oE '"[a-zA-Z0-9_]+":' | tr -d '":' | grep -vxE 'VM2|VX2|RA2' | sort -u
}

folder=${BUILD:-build}/check-manual
rm -rf "$folder"
mkdir -p "$folder" || exit 1
for arguments in '' '--tail estimate' '--error 2' '--colour exposures'; do
    # shellcheck disable=SC2086 # options
    "$SUPERFRAME" render fig3 --size 20x12 $arguments --stats "$folder/printed.part" -o "$folder/x.png" ||
        complain "render --stats $arguments: exit status $?"
    cat "$folder/printed.part" >> "$folder/printed"
done
"$SUPERFRAME" render fig3 --size 20x12 --bus "trace:$folder/x.trace" > /dev/null ||
    complain "render --bus trace: exit status $?"
"$SUPERFRAME" replay "$folder/x.trace" -o "$folder/x.png" --stats - >> "$folder/printed" 2> /dev/null ||
    complain "replay --stats: exit status $?"
keys_of_page > "$folder/page"
# What takes an adapter or a processor is held by their own tests, against the same page.
keys_of_run < "$folder/printed" > "$folder/run"
for key in $(comm -13 "$folder/page" "$folder/run"); do
    complain "$page: nothing about $key of --stats"
done
for key in $(comm -23 "$folder/page" "$folder/run"); do
    case " adapter bus bytes_out bytes_in transfers frames resent timeouts stalls reconnects restarts \
verified_pixels repaired_pixels instructions predicted_seconds_RA2 " in
    *" $key "*) ;;
    *) complain "$page: --stats has no $key" ;;
    esac
done
[ $failures -eq 0 ]
