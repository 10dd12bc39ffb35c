#!/bin/sh
# SPDX-License-Identifier: MIT
# Holds comments and pages to two rules of docs/changing.md, which a script can see: check_english.sh [FILE...]
#
# 1. What stands before a function begins with a verb in the third person: "Returns", "Appends".
# 2. A sentence has at most 22 words. Of a page, tables and code are left out.
#
# Without arguments, of all source files and pages; docs/bench.md and docs/usb-bytes.md are made by programs. Exit status: 0 all hold, 1 one does not, 2 no file was found.
set -u
cd "$(dirname "$0")/.." || exit 2
# shellcheck disable=SC2046 # names without blanks
[ $# -gt 0 ] || set -- $(find hal emulator firmware host -name '*.[ch]' | sort) \
    README.md $(find docs -maxdepth 1 -name '*.md' ! -name bench.md ! -name usb-bytes.md | sort)
[ $# -gt 0 ] || exit 2

awk '
BEGIN {
    WORDS_MOST = 22
    # Words that end as a verb does, and are none.
    split("This Its As Yes Less Always Perhaps Besides Thus Axes Bits Bytes Others Sometimes Colours Words " \
        "Pixels Indices Forms Primitives Faults Seconds Clocks Bus Accesses Requests Slopes Cells Lanes Harmless " \
        "Rays Planes Objects Solids Materials Tables Vectors Options Results Files Columns", list, " ")
    for (i in list) {
        is_noun[list[i]] = 1
    }
}

function wrong(line, text) {
    printf "%s:%d: %s\n", FILENAME, line, text
    failures++
}

# Counts the words of the sentences of a comment that began in a line.
function check_sentences(text, line, count, sentences, i, j, parts, words) {
    gsub(/-----*/, " ", text)
    count = split(text, sentences, /[.?!][")]?([ \t]+|$)/)
    for (i = 1; i <= count; i++) {
        words = 0
        for (j = split(sentences[i], parts, /[ \t]+/); j > 0; j--) {
            words += parts[j] ~ /[A-Za-z0-9]/
        }
        if (words > WORDS_MOST) {
            sub(/^[ \t]+/, "", sentences[i])
            wrong(line, "a sentence of " words " words; at most " WORDS_MOST " are allowed: " substr(sentences[i], 1, 60))
        }
    }
}

# Tells if a line begins a function or its declaration.
function is_function(text) {
    return text ~ /^[A-Za-z_][A-Za-z0-9_ \t*]*[ *][A-Za-z_0-9]+\(/ && text !~ /^(typedef|return|else|if|while|for)[ (]/
}

function check_function(text, line, first) {
    sub(/^[ \t]+/, "", text)
    first = text
    sub(/[^A-Za-z].*/, "", first)
    if (first !~ /^[A-Z][a-z]+s$/ || first in is_noun) {
        wrong(line, "before a function: \"" substr(text, 1, 50) "\" begins with no verb such as Returns")
    }
}

# Ends a paragraph of a page, or an item of a list.
function end_block() {
    if (block != "") {
        check_sentences(block, block_line)
    }
    block = ""
}

FNR == 1 {
    end_block()
    in_comment = is_fenced = 0
    before = ""
}
FILENAME ~ /\.md$/ {
    if ($0 ~ /^[ \t]*([-*]|[0-9]+\.)[ \t]/) {
        end_block()
    }
    is_fenced = $0 ~ /^```/ ? !is_fenced : is_fenced
    if (is_fenced || $0 ~ /^([ \t]*$|[ \t]*\||#|<!--|```)/ || (block == "" && $0 ~ /^    /)) {
        end_block()
    } else {
        block_line = block == "" ? FNR : block_line
        block = block " " $0
    }
    next
}
{
    line = $0
    # Texts may hold what looks like a comment.
    gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
    if (!in_comment) {
        if (before != "" && is_function(line)) {
            check_function(before, before_line)
        }
        before = ""
    }
    while (1) {
        if (!in_comment) {
            start = index(line, "/*")
            if (start == 0) {
                break
            }
            alone = substr(line, 1, start - 1) ~ /^$/
            in_comment = 1
            comment = ""
            comment_line = FNR
            line = substr(line, start + 2)
        }
        end = index(line, "*/")
        if (end == 0) {
            piece = line
            sub(/^[ \t]*\*[ \t]?/, " ", piece)
            comment = comment " " piece
            break
        }
        piece = substr(line, 1, end - 1)
        sub(/^[ \t]*\*[ \t]?/, " ", piece)
        comment = comment " " piece
        in_comment = 0
        line = substr(line, end + 2)
        check_sentences(comment, comment_line)
        if (alone && line ~ /^[ \t]*$/) {
            before = comment
            before_line = comment_line
        }
    }
}
END {
    end_block()
    printf "english: %d wrong\n", failures
    exit failures > 0
}' "$@"
