#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds what `make mutants` draws to a list written by hand: check_mutants.sh
#
# Environment: BUILD, the build folder; CC. Exit status: 0 as it should be, 1 not, 2 it can't be told.
set -u
cd "$(dirname "$0")/.." || exit 2
folder=${BUILD:-build}/check-mutants
mkdir -p "$folder" || exit 2
failures=0

wrong() {
    echo "$*"
    failures=$((failures + 1))
}

${CC:-gcc} -std=c99 -D_POSIX_C_SOURCE=200809L -Ihal -o "$folder/mutate" tests/mutants/*.c || exit 2

cat > "$folder/sample.c" << 'END'
#include <none < 1>
enum colour { RED, GREEN };
/* Neither a comment, a < 1, nor a text is changed. */
static const char text[] = "a < 1";
int f(int a) {
    if (a < 3 && g(text)) {
        a -= 0x1FU;
        h(a,
          RED);
    }
    for (int i = 0; i < a; i++) {
        continue;
    }
    return a - 1;
}
END
sort > "$folder/expected" << 'END'
6 f if (!(a < 3 && g(text))) {
6 f if (a <= 3 && g(text)) {
6 f if (a > 3 && g(text)) {
6 f if (a < 4 && g(text)) {
6 f if (a < 2 && g(text)) {
6 f if (a < 3 || g(text)) {
7 f a += 0x1FU;
7 f a = 0x1FU;
7 f a -= 0x20U;
7 f a -= 0x1EU;
7 f ;
8 f ;
9 f GREEN);
11 f for (int i = 1; i < a; i++) {
11 f for (int i = 0; i <= a; i++) {
11 f for (int i = 0; i > a; i++) {
11 f for (int i = 0; i < a - 1; i++) {
11 f for (int i = 0; i < a + 1; i++) {
11 f for (int i = 0; i < a; i--) {
12 f ;
14 f return 0;
14 f return a + 1;
14 f return a - 2;
14 f return a - 0;
END

# draw NUMBER PATTERN
draw() {
    "$folder/mutate" 1 "$1" "$2" "$folder/copy.c" "$folder/sample.c" > "$folder/drawn"
}

number=0
: > "$folder/all"
while [ $number -lt 400 ]; do
    number=$((number + 1))
    draw $number '*sample.c' || wrong "draw $number failed"
    ! cmp -s "$folder/copy.c" "$folder/sample.c" || wrong "draw $number changes nothing"
    sed -n '2h; 3H; 5{ H; g; s/\n/ /g; p; }' "$folder/drawn" >> "$folder/all"
done
sort -u "$folder/all" | diff "$folder/expected" - || wrong 'other changes are drawn'

! draw 1 'none' 2> "$folder/message" || wrong 'a pattern that matches no file is no error'
draw 17 '*sample.c' && cp "$folder/copy.c" "$folder/again.c" && draw 17 'none *sample.c'
cmp "$folder/copy.c" "$folder/again.c" || wrong 'a draw is not repeated by its number'

# An entry counts for its function and both texts only.
{
    printf '@ %s %s\n' "$(sed -n 1p "$folder/drawn")" "$(sed -n 3p "$folder/drawn")"
    printf -- '- %s\n+ %s\n= a reason\n' "$(sed -n 4p "$folder/drawn")" "$(sed -n 5p "$folder/drawn")"
} > "$folder/equivalent"
for change in '' 's/^@ .*/@ sample.c g/' 's/^- /- not /' 's/^+ /+ not /'; do
    reason=$(sed "$change" "$folder/equivalent" | awk -f tests/mutants/listed.awk "$folder/drawn" -)
    expected=
    [ -n "$change" ] || expected='a reason'
    [ "$reason" = "$expected" ] || wrong "listed as \"$reason\" after \"$change\""
done

echo "mutants: $failures wrong"
[ $failures -eq 0 ]
