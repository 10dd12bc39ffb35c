/* SPDX-License-Identifier: MIT */
/* The board probe: experiments with a real board, their answers on the text screen. */
#include "bars.h"
#include "board_driver.h"
#include "experiments.h"
#include "machine.h"
#include "outp.h"
#include "registers.h"

enum { TITLE_ROW = 0, STATE_ROW = 1, ANSWERS_ROW = 2, ROWS = 18, CELL_COLUMNS = 26 };
enum { SUMMARY_ROW = 20, LEGEND_ROW = 21, VIEW_ROW = 23, END_ROW = 24 };

/* The check is a sum of numbers times answers, modulo the largest prime below 2^16. */
enum { CHECK_MODULUS = 65521 };

/* The PC-9801 waits 0.6 us at each write to this port. */
enum { WAIT_PORT = 0x5F, WAITS = 166667, POLLS = 40 };

void pc98_main(void);

/* What was found out so far. */
struct findings {
    char marks[EXPERIMENTS + 1];
    uint32_t check;
};

static uint8_t put_hexadecimal(uint8_t row, uint8_t column, uint32_t value, uint8_t digits) {
    char text[9];
    for (uint8_t i = 0; i < digits; i++) {
        text[i] = "0123456789ABCDEF"[value >> 4 * (digits - 1 - i) & 0xF];
    }
    text[digits] = '\0';
    return text_put(row, column, text);
}

/* Puts a text into a row of its own, over what was there. */
static void say(uint8_t row, const char *text) {
    uint8_t column = text_put(row, 0, text);
    while (column < TEXT_COLUMNS) {
        column = text_put(row, column, " ");
    }
}

static char mark_of(const struct experiment *experiment, uint32_t answer) {
    if (answer == experiment->in_1987) {
        return answer == experiment->in_later ? 'B' : '1';
    }
    return answer == experiment->in_later ? 'L' : 'x';
}

static void run_experiment(uint8_t index, struct findings *findings) {
    const struct experiment *experiment = &experiments[index];
    uint8_t row = (uint8_t)(ANSWERS_ROW + index % ROWS);
    uint8_t column = (uint8_t)(index / ROWS * CELL_COLUMNS);
    uint8_t number = (uint8_t)(index + 1);
    (void)text_put_number(row, (uint8_t)(column + (number < 10)), number);
    (void)text_put(row, (uint8_t)(column + 3), experiment->name);
    uint32_t answer = experiment->answer();
    findings->marks[index] = mark_of(experiment, answer);
    findings->check = (findings->check + number * (answer % CHECK_MODULUS)) % CHECK_MODULUS;
    (void)put_hexadecimal(row, (uint8_t)(column + 16), answer, experiment->digits);
}

/* Runs the experiments first..last-1, from 0. Returns false if Esc was pressed. */
static bool run_experiments(uint8_t first, uint8_t last, struct findings *findings) {
    for (uint8_t i = first; i < last; i++) {
        if (escape_pressed()) {
            return false;
        }
        run_experiment(i, findings);
    }
    return true;
}

static void sum_up(const struct findings *findings) {
    uint8_t column = text_put(SUMMARY_ROW, 0, "Summary: ");
    column = text_put(SUMMARY_ROW, column, findings->marks);
    (void)put_hexadecimal(SUMMARY_ROW, (uint8_t)(column + 1), findings->check, 4);
    say(LEGEND_ROW,
        "Write it down, with the digits of each x. 1 1987, L later, B both, x neither.");
}

/* Shows the bars in all views, again and again, until Esc. */
static void show_views(void) {
    for (uint8_t i = 0;; i = (uint8_t)((i + 1) % VIEWS)) {
        view_show(&views[i]);
        say(VIEW_ROW, views[i].expected);
        for (uint8_t polls = 0; polls < POLLS; polls++) {
            if (escape_pressed()) {
                view_show(&views[0]);
                return;
            }
            for (uint32_t waits = 0; waits < WAITS; waits++) {
                outp(WAIT_PORT, 0);
            }
        }
    }
}

/* Runs what follows the board's initialisation: experiments, summary and bars. */
static void probe_board(struct findings *findings) {
    say(STATE_ROW, "A board answers at 00D0h. The experiments take a minute.");
    if (!run_experiments(EXPERIMENTS_BEFORE, EXPERIMENTS, findings)) {
        return;
    }
    sum_up(findings);
    say(STATE_ROW, "Drawing the bars.");
    bars_draw();
    say(STATE_ROW, "What do you see? The last line but one says what to expect, 4 s each.");
    show_views();
}

void pc98_main(void) {
    struct findings findings = {.check = 0};
    text_clear();
    say(TITLE_ROW, "superframe: the board probe; Esc ends it");
    if (run_experiments(0, EXPERIMENTS_BEFORE, &findings)) {
        board_start(CONTROL_1);
        if (!board_is_present(CONTROL_1)) {
            say(STATE_ROW, "No SuperFrame board answers at 00D0h; nothing else was tried.");
            return;
        }
        probe_board(&findings);
    }
    say(END_ROW, "Ended by Esc.");
}
