#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures what renders cost, alone and against POV-Ray: tests/bench/bench.sh BUILD [STAGE...]
#
# Stages: renders, frame, jobs, pairs, equal, page; without one all of them. Each leaves its tables in
# BUILD/bench; `page` makes the JSON, the plots and the page of what is there. tests/bench/settings.sh
# says what the environment may set. Exit status: 0 done, 1 a run failed, 2 bad usage or settings.
set -u

here=$(dirname "$0")
stages='renders frame jobs pairs equal page'
[ $# -ge 1 ] || {
    echo "usage: tests/bench/bench.sh BUILD [STAGE...]; stages are: $stages" >&2
    exit 2
}
build=$1
shift
superframe=$build/superframe
tools=$build/release/tests/bench
out=$build/bench

# shellcheck source=tests/bench/settings.sh
. "$here/settings.sh"
# shellcheck source=tests/bench/renders.sh
. "$here/renders.sh"
# shellcheck source=tests/bench/pov.sh
. "$here/pov.sh"
# shellcheck source=tests/bench/page.sh
. "$here/page.sh"

for stage in ${*:-$stages}; do
    case " $stages " in
    *" $stage "*) ;;
    *) complain "no stage \"$stage\"; allowed are: $stages" ;;
    esac
done
[ -x "$superframe" ] && [ -x "$tools/timed" ] || complain "$build holds no bench; make bench builds it"
check_settings
mkdir -p "$out" && : > "$out/log" || exit 1
for stage in ${*:-$stages}; do
    began=$(date +%s)
    "stage_$stage" || exit 1
    echo "bench: $stage is done, $(($(date +%s) - began)) s"
done
