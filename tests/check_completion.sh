#!/bin/sh
# SPDX-License-Identifier: MIT
# Completes command lines as bash, zsh and fish would, from what `superframe completion` prints, and looks at
# every page of help: two examples that are no bad usage, and at most 80 columns.
#
# SUPERFRAME  the program (default: $BUILD/superframe). A shell that is not installed is named and left out.
# Exit status: 0 all holds, 1 not.
set -u
cd "$(dirname "$0")/.." || exit 1
SUPERFRAME=${SUPERFRAME:-${BUILD:-build}/superframe}
SUPERFRAME=$(cd "$(dirname "$SUPERFRAME")" && pwd)/$(basename "$SUPERFRAME")
folder=${BUILD:-build}/check-completion
rm -rf "$folder"
mkdir -p "$folder" || exit 1
failures=0

complain() {
    echo "check_completion: $*"
    failures=$((failures + 1))
}

# expect SHELL LINE WORD...: what the shell offers for the line has each word; -WORD: has it not.
expect() {
    shell=$1 line=$2
    shift 2
    offered=$(complete_in "$shell" "$line" 2>&1)
    for word in "$@"; do
        case $word in
        !*) printf '%s\n' "$offered" | grep -q -x -e "${word#!}" &&
            complain "$shell: \"$line\" offers ${word#!}" ;;
        *) printf '%s\n' "$offered" | grep -q -x -e "$word" ||
            complain "$shell: \"$line\" does not offer $word, but: $(printf '%s' "$offered" | tr '\n' ' ' | cut -c 1-200)" ;;
        esac
    done
}

# Prints what a shell offers for a line, one word a line.
complete_in() {
    case $1 in
    bash)
        bash --norc -c '. "$1"; line=$2; read -r -a COMP_WORDS <<< "$line"
            case $line in *" ") COMP_WORDS+=("") ;; esac
            COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
            _superframe superframe "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
            printf "%s\n" "${COMPREPLY[@]}"' bash "$folder/bash" "$2"
        ;;
    fish) fish --no-config -c "source $folder/fish; complete -C '$2'" | cut -f 1 ;;
    esac
}

for shell in bash zsh fish; do
    "$SUPERFRAME" completion $shell > "$folder/$shell" || complain "completion $shell: exit status $?"
    [ "$(grep -c . "$folder/$shell")" -gt 20 ] || complain "completion $shell: next to nothing"
done
for shell in bash fish; do
    command -v $shell > /dev/null || {
        echo "check_completion: $shell is not installed: left out"
        continue
    }
    expect $shell 'superframe re' render replay '!trace'
    expect $shell 'superframe render --co' --colour '!--compare'
    expect $shell 'superframe render --highlight ' phong blinn
    expect $shell 'superframe trace a --to ' binary text
    expect $shell 'superframe render fig4' fig4a fig4b
    expect $shell 'superframe trace --com' --compare
    expect $shell 'superframe compare --d' --difference '!--depth'
done
# zsh completes within its line editor only: the script is parsed, and its functions are asked for.
if command -v zsh > /dev/null; then
    zsh -f -n "$folder/zsh" || complain 'zsh: the script is not well formed'
    zsh -f -c "autoload -U compinit; compinit -D -d $folder/dump; . $folder/zsh
        [ \"\${_comps[superframe]}\" = _superframe ]" || complain 'zsh: superframe has no completion'
else
    echo 'check_completion: zsh is not installed: left out'
fi

commands=$("$SUPERFRAME" --help | sed -n '/^usage/,/^$/d; /^superframe help/q; s/^  \([a-z]*\) .*/\1/p')
[ "$(echo "$commands" | wc -w)" -ge 16 ] || complain "--help lists: $commands"
for command in '' $commands; do
    # shellcheck disable=SC2086 # nothing, or one word
    "$SUPERFRAME" help $command > "$folder/help" || complain "help $command: exit status $?"
    awk -v command="$command" 'length($0) > 80 {
        print "check_completion: help " command ": " length($0) " columns: " $0
        long++
    }
    END { exit long > 0 }' "$folder/help" || failures=$((failures + 1))
    [ -z "$command" ] || {
        "$SUPERFRAME" "$command" -h | cmp -s - "$folder/help" || complain "$command -h is another text"
        grep -q "^  superframe $command" "$folder/help" || complain "help $command: no example"
    }
    sed -n '/^For example/,$s/^  superframe //p' "$folder/help" >> "$folder/examples"
done
# An example may lack its file; it may not be refused as a command line.
while read -r line; do
    # shellcheck disable=SC2086 # words
    set -- $(printf '%s\n' "$line" | sed 's/ [|>].*//')
    case $1 in measure | paper | adapter | devices) continue ;; esac
    (cd "$folder" && timeout 60 "$SUPERFRAME" "$@" > out 2> err)
    grep -E 'no option|is missing|is invalid|one too many|goes with|exclude|no command' "$folder/err" &&
        complain "the example \"superframe $line\" is refused"
done < "$folder/examples"
[ $failures -eq 0 ]
