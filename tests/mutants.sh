#!/bin/sh
# SPDX-License-Identifier: MIT
# Breaks the board's register code in small ways, one at a time, and sees whether the suites notice.
#
# usage: tests/mutants.sh [BUILD]      (from the project's folder; BUILD is build by default)
#
# Each mutant below is a file, a sed expression that must change it, and what it breaks. Exit status
# 0: all were caught but those marked as survivors; 1: another one survived, a survivor was caught,
# or an expression changed nothing.
set -u

BUILD=${1:-build}
CC=${CC:-gcc}
FLAGS='-std=c99 -D_POSIX_C_SOURCE=200809L -O1 -Ihal -Iemulator -Itests'
SUITES='board board_control board_report board_table driver_run picture'
work=$BUILD/mutants

# file | sed expression | what it breaks. A last field "survives: why" marks an equivalent mutant.
mutants() {
    cat << 'END'
board.c|s/POSITION_X_MASK = 0x03FF/POSITION_X_MASK = 0x07FF/|X takes an eleventh bit
board.c|s/POSITION_Y_MASK = 0x01FF/POSITION_Y_MASK = 0x00FF/|Y loses its upper bit
board.c|s/x < BOARD_WIDTH \&\& y < BOARD_HEIGHT/x <= BOARD_WIDTH \&\& y < BOARD_HEIGHT/|X 640 is inside
board.c|s/x < BOARD_WIDTH \&\& y < BOARD_HEIGHT/x < BOARD_WIDTH \&\& y <= BOARD_HEIGHT/|Y 400 is inside
board.c|s/profile == BOARD_LATER \&\& x < BOARD_HIDDEN_WIDTH/profile == BOARD_LATER \&\& x <= BOARD_HIDDEN_WIDTH/|X 384 is a hidden block
board.c|s/y < BOARD_HIDDEN_HEIGHT/y <= BOARD_HIDDEN_HEIGHT/|Y 408 is a hidden block
board.c|s/board->desc.profile == BOARD_LATER \&\& x < BOARD_HIDDEN_WIDTH/x < BOARD_HIDDEN_WIDTH/|1987 has hidden blocks
board.c|s/x -= BOARD_WIDTH;/x -= BOARD_WIDTH - 1;/|X wraps one too far
board.c|s/(y \* BOARD_WIDTH + x) \* 3/(y * (BOARD_WIDTH - 1) + x) * 3/|lines overlap
board.c|s/(board->x \& 3) != 0 || access.value != 0/(board->x \& 3) != 0/|a fill with another value is not reported
board.c|s/(board->x \& 3) != 0 || access.value != 0/(board->x \& 1) != 0 || access.value != 0/|a fill at X 2 is not reported
board.c|s/i < 4 \* 3; i++/i < 3 * 3; i++/|the fill takes three pixels
board.c|s/\/ 3 \& ~(uint32_t)3/\/ 3/|the fill begins at X
board.c|s/report(board, BOARD_RED_WORD_WRITE, access);/board_note_use(board, BOARD_RED_WORD_WRITE);/|the fill in 1987 is not logged
board.c|s/board->controller_written\[board->index\] = 1;//|no index counts as written
board.c|s/if (value != 0xFF) {/if (value == 0xFF) {/|the usual start address is reported
board.c|s/mode == 0x00 || mode == 0x01 || mode == 0x03/mode <= 0x03/|mode 02 is not reported
board.c|s/mode \& BOARD_MODE_STEP) != 0/mode \& BOARD_MODE_STEP) == 0/|X steps when it is not asked to
board.c|s/set_x(board, board->x + 1U)/set_x(board, board->x + 2U)/|X steps by two
board.c|s/(board->x \& 0xFF00U) | access.value/access.value/|a byte to X clears the upper bits
board.c|s/(board->y \& 0x00FFU) | (unsigned)access.value << 8/(unsigned)access.value << 8/|an odd byte to Y clears the low byte
board.c|s/write_half(board, next, (unsigned)value >> 8)/write_half(board, next, value)/|a split word writes its low byte twice
board.c|s/return (uint16_t)(0xFF00U | read_data(board, access))/return read_data(board, access)/|control 2 reads 00 above
board.c|s/access.value = (uint16_t)(0xFF00U | read_primary/access.value = (uint16_t)(0x0000U | read_primary/|a primary reads 00 above
board.c|s/board->accesses % FRAME_ACCESSES >= FRAME_SHOWN_ACCESSES/board->accesses % FRAME_ACCESSES < FRAME_SHOWN_ACCESSES/|blank and shown are swapped
board.c|s/return is_blank ? STATUS_BLANK : 0/return is_blank ? 1 : 0/|the status has the wrong bit
board_internal.h|s/if (entry->count++ == 0)/if (entry->count++ <= 1)/|the first access of a behaviour is the second
board.c|s/board->log_count < BOARD_LOG_SIZE \&\&/board->log_count < BOARD_LOG_SIZE - 1 \&\&/|the log is one short
board_pixel.c|s/ || board->is_stepping/ || false/|the short way forgets to step X
board_pixel.c|s/x >= BOARD_WIDTH/x > BOARD_WIDTH/|the short way takes X 640 for inside
board_pixel.c|s/board->y >= BOARD_HEIGHT/board->y > BOARD_HEIGHT/|the short way takes Y 400 for inside
board_pixel.c|s/board->is_wrapped = false;//|the short way leaves X wrapped
board_pixel.c|s/board->x = x;//|the short way does not keep X
board_pixel.c|s/board_note_use(board, BOARD_POSITION_WRITE);//|the short way does not count an X
board_pixel.c|s/board_note_use(board, BOARD_PRIMARY_WRITE);//|the short way does not count a primary
board_pixel.c|s/\[BUS_WORD - 1\]++/[BUS_BYTE - 1]++/|the short way counts X as a byte
board_pixel.c|s/offset == 0x4 \&\& width == BUS_WORD/offset == 0x4/|the short way takes a byte to X for a word
board.c|s/ | (unsigned)read_half(board, next) << 8/ | (unsigned)read_half(board, port) << 8/|a split read gives its low byte twice
board_internal.h|s/0x000003FFU/0x000001FFU/|index 09 is not of the initialisation
board_report.c|s/>= grade)/> grade)/|the grade asked for is not counted
board_setup.c|s/(base \& 0xF1FF) == BOARD_FACTORY_BASE/(base \& 0xF0FF) == BOARD_FACTORY_BASE/|01D0 is offered
board_setup.c|s/\&\& base <= 0x0CD0/\&\& base <= 0x0ED0/|0ED0 is offered
board_pixel.c|s/if (!is_done) {/if (true) {/|a short write is done twice
board_pixel.c|s/bool is_primary = offset == 0x8 || offset == 0xA || offset == 0xC;/bool is_primary = false;/|the short way is never taken|survives: write_byte() does the same, only slower
END
}

rm -rf "$work"
mkdir -p "$work" || exit 1

# Compiles the suites with the emulator in $work/emulator and runs them. 0: all passed; 1: one
# failed; 2: it doesn't compile, and so proves nothing.
run_suites() {
    # shellcheck disable=SC2086 # the flags are words
    for suite in $SUITES; do
        $CC -I"$work/emulator" $FLAGS -o "$work/$suite" "tests/${suite}_test.c" \
            "$work"/emulator/board*.c "$work/emulator/picture.c" "$work/emulator/native_screen.c" \
            hal/bus.c -lcmocka -ldeflate > "$work/log" 2>&1 || return 2
        timeout 60 "$work/$suite" > "$work/log" 2>&1 || return 1
    done
}

mkdir -p "$work/emulator"
cp emulator/board*.[ch] emulator/picture.[ch] emulator/native_screen.[ch] "$work/emulator"
run_suites || {
    echo 'the suites fail without any mutant' >&2
    exit 1
}

mutants > "$work/list"
caught=0
survived=0
wrong=0
while IFS= read -r line; do
    # A sed expression may hold "||", written || in C: split at single bars only.
    line=$(printf '%s\n' "$line" | sed 's/||/\x01/g')
    file=$(printf '%s\n' "$line" | cut -d'|' -f1)
    expression=$(printf '%s\n' "$line" | sed 's/^[^|]*|//; s/\/|.*$/\//; s/\x01/||/g')
    words=$(printf '%s\n' "$line" | sed 's/^[^|]*|.*\/|//; s/\x01/||/g')
    cp "emulator/$file" "$work/emulator/$file"
    sed -i "$expression" "$work/emulator/$file"
    if cmp -s "emulator/$file" "$work/emulator/$file"; then
        outcome='NOTHING CHANGED'
    else
        run_suites
        case $? in
        0) outcome=survived ;;
        1) outcome=caught ;;
        *) outcome='DOES NOT COMPILE' ;;
        esac
    fi
    case $outcome in
    survived) survived=$((survived + 1)) ;;
    caught) caught=$((caught + 1)) ;;
    esac
    expected=caught
    case $words in
    *survives:*) expected=survived ;;
    esac
    if [ "$outcome" = $expected ]; then
        echo "$outcome: $words"
    else
        echo "$outcome, NOT AS EXPECTED: $words"
        wrong=$((wrong + 1))
    fi
    cp "emulator/$file" "$work/emulator/$file"
done < "$work/list"
echo "$caught caught, $survived survived, $wrong not as expected"
[ $wrong -eq 0 ]
