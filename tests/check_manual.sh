#!/bin/sh
# SPDX-License-Identifier: MIT
# Looks at the manual page as man shows it: `superframe manual`, and docs/superframe.roff behind it. troff warns
# of nothing; each command and each option of its --help begins a line, and no escape is left over. What
# docs/superframe.roff explains are options that some command has. The keys of --stats are those of the page,
# both ways.
#
# SUPERFRAME  the program (default: $BUILD/superframe). groff and mandoc are left out where they are not there.
# Exit status: 0 all holds, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
SUPERFRAME=${SUPERFRAME:-${BUILD:-build}/superframe}
prose=docs/superframe.roff
folder=${BUILD:-build}/check-manual
failures=0
rm -rf "$folder"
mkdir -p "$folder" || exit 1

complain() {
    echo "check_manual: $*"
    failures=$((failures + 1))
}

"$SUPERFRAME" manual > "$folder/page" || complain "manual: exit status $?"
cat "$prose" >> "$folder/page"

# Prints the options of a command as its help begins their lines: "-o, --output".
options_of() {
    "$SUPERFRAME" "$1" --help | sed -n 's|^ *\(-., \)\{0,1\}\(--[a-z-]*\).*|\1\2|p' | sort -u
}

commands=$("$SUPERFRAME" --help | sed -n '/^superframe help/q; s/^  \([a-z]*\) .*/\1/p')
[ -n "$commands" ] || complain '--help lists no command'

# ---- The page as man shows it ----

if command -v groff > /dev/null; then
    groff -man -ww -Tascii -P-cbou -rLL=80n "$folder/page" > "$folder/shown" 2> "$folder/warnings"
    [ ! -s "$folder/warnings" ] || complain "groff: $(head -n 3 "$folder/warnings")"
    for command in $commands; do
        grep -qE "^   superframe $command( |\$)" "$folder/shown" || complain "no heading for $command"
        options_of "$command" > "$folder/options"
        while read -r option; do
            grep -q -e "^ *$option\([^a-z-]\|\$\)" "$folder/shown" ||
                complain "the page shows no $option, which $command has"
        done < "$folder/options"
    done
    grep -nE '\\|[.][A-Z]{2} |%$' "$folder/shown" && complain 'an escape or a request is shown'
    # What is copied from the page is what the shell takes: a hyphen may end a line only.
    groff -man -Tutf8 -P-cbou "$folder/page" | grep '‐.' && complain 'a hyphen is shown for a dash'
    awk 'length($0) > 80' "$folder/shown" | grep . && complain 'a line of more than 80 columns is shown'
else
    echo 'check_manual: groff is not installed: left out'
fi
if command -v mandoc > /dev/null; then
    mandoc -T lint -W warning "$folder/page" || complain 'mandoc warns'
fi

# ---- Options that are explained ----

for command in $commands; do
    options_of "$command"
done | sed 's/.*--/--/; $s/$/\n--version/' > "$folder/known"
sed '/^\.\\"/d; s/\\-/-/g' "$prose" | grep -oE -e '--[a-z][a-z-]*[a-z]' | sort -u > "$folder/explained"
[ "$(grep -c . "$folder/explained")" -gt 20 ] || complain "$prose explains next to nothing"
while read -r option; do
    grep -q -x -e "$option" "$folder/known" || complain "$prose: $option is no option of any command"
done < "$folder/explained"

# ---- Keys of --stats ----

# What the page's STATISTICS call keys: the words in bold that are neither options nor commands.
keys_of_page() {
    sed -n '/^\.SH STATISTICS/,/^\.SH ENV/p' $prose | tr '\n' ' ' | grep -o '\\fB[^\\]*\\fR' |
        sed 's/^\\fB//; s/\\fR$//' | tr ' ' '\n' | grep -E '^[a-zA-Z0-9_]+$' |
        grep -vxE 'replay|boot|render|hid' | sort -u
}

keys_of_run() {
    grep -oE '"[a-zA-Z0-9_]+":' | tr -d '":' | grep -vxE 'VM2|VX2|RA2' | sort -u
}

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
keys_of_page > "$folder/told"
# What takes an adapter or a processor is held by their own tests, against the same page.
keys_of_run < "$folder/printed" > "$folder/run"
for key in $(comm -13 "$folder/told" "$folder/run"); do
    complain "$prose: nothing about $key of --stats"
done
for key in $(comm -23 "$folder/told" "$folder/run"); do
    case " adapter bus bytes_out bytes_in transfers frames resent timeouts stalls reconnects restarts \
verified_pixels repaired_pixels instructions predicted_seconds_RA2 predicted_seconds_RA2_NP2kai \
predicted_source_RA2 predicted_source_RA2_NP2kai " in
    *" $key "*) ;;
    *) complain "$prose: --stats has no $key" ;;
    esac
done
[ $failures -eq 0 ]
