/* SPDX-License-Identifier: MIT */
/* What each behaviour of the board is called, how well it is known, and where it is a violation. */
#include "board.h"

#include <stddef.h>
#include <string.h>

/* By enum board_behaviour: the text, and the grades in the order of enum board_profile. Without
 * designators, which C++ has not, a comment names the row. */
static const struct {
    const char *text;
    enum board_grade grade[BOARD_PROFILES];
} behaviours[BOARD_BEHAVIOURS] = {
    /* BOARD_INDEX_WRITE */ {"control 1 written: the index", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_DATA_WRITE */
    {"control 2 written: the indexed register", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_DATA_READ */
    {"control 2 read: what was written to the index", {GRADE_INFERRED, GRADE_INFERRED}},
    /* BOARD_STATUS_READ */ {"control 2 read: the status", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_POSITION_WRITE */ {"X or Y written as a word", {GRADE_PAPER, GRADE_PAPER}},
    /* BOARD_POSITION_LOW_WRITE */
    {"X or Y written as a byte: the upper bits stay", {GRADE_INFERRED, GRADE_INFERRED}},
    /* BOARD_PRIMARY_WRITE */ {"red, green or blue written", {GRADE_PAPER, GRADE_PAPER}},
    /* BOARD_PRIMARY_READ */ {"red, green or blue read", {GRADE_PAPER, GRADE_PAPER}},
    /* BOARD_MODE_WRITE */ {"mode set to 00, 01 or 03", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_CONTROL1_READ */
    {"control 1 read, which is for writing", {GRADE_ASSUMED, GRADE_DRIVER}},
    /* BOARD_CONTROL1_BYTE_READ */ {"control 1 read as a byte", {GRADE_ASSUMED, GRADE_INFERRED}},
    /* BOARD_RED_WORD_WRITE */
    {"red written as a word: the fill of four pixels on later boards",
     {GRADE_ASSUMED, GRADE_INFERRED}},
    /* BOARD_HIDDEN_ACCESS */ {"a pixel of the hidden blocks", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_START_ADDRESS */
    {"a display start address other than 0", {GRADE_ASSUMED, GRADE_INFERRED}},
    /* BOARD_WORD_SPLIT */
    {"a word at an odd port, taken as two bytes", {GRADE_INFERRED, GRADE_INFERRED}},
    /* BOARD_FOREIGN_WRITE */ {"a write outside the board's ports", {GRADE_DRIVER, GRADE_DRIVER}},
    /* BOARD_FILL_UNSEEN */
    {"a fill with X not a multiple of 4, or a value other than 0", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_POSITION_HIGH_WRITE */
    {"X or Y written as a byte at the odd port", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_ODD_WRITE */ {"a byte written at an odd port", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_ODD_READ */ {"a byte read at an odd port", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_PRIMARY_WORD_WRITE */
    {"green or blue written as a word", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_PRIMARY_WORD_READ */
    {"red, green or blue read as a word", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_WRITE_ONLY_READ */ {"a write-only register read", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_FOREIGN_READ */ {"a read outside the board's ports", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_OUTSIDE_WRITE */
    {"a pixel written outside the frame memory", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_OUTSIDE_READ */
    {"a pixel read outside the frame memory", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_UNKNOWN_INDEX */
    {"data for an index of unknown meaning", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_UNWRITTEN_READ */
    {"data read from an index that was never written", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_MODE_UNKNOWN */ {"a mode with bits of unknown effect", {GRADE_ASSUMED, GRADE_ASSUMED}},
    /* BOARD_AUTO_INCREMENT */ {"X stepped by itself, after blue", {GRADE_ASSUMED, GRADE_ASSUMED}},
};

enum board_grade board_behaviour_grade(enum board_behaviour behaviour, enum board_profile profile) {
    return behaviours[behaviour].grade[profile];
}

bool board_behaviour_is_violation(enum board_behaviour behaviour, enum board_profile profile) {
    return board_behaviour_grade(behaviour, profile) == GRADE_ASSUMED;
}

const char *board_behaviour_text(enum board_behaviour behaviour) {
    return behaviours[behaviour].text;
}

uint64_t board_violations(const struct board *board) {
    uint64_t sum = 0;
    for (unsigned i = 0; i < BOARD_BEHAVIOURS; i++) {
        if (board_behaviour_is_violation((enum board_behaviour)i, board->desc.profile)) {
            sum += board->notes[i].count;
        }
    }
    return sum;
}

uint64_t board_reliances(const struct board *board, enum board_grade grade) {
    uint64_t sum = 0;
    for (unsigned i = 0; i < BOARD_BEHAVIOURS; i++) {
        if (behaviours[i].grade[board->desc.profile] >= grade) {
            sum += board->notes[i].count;
        }
    }
    return sum;
}

/* ---- Names ---------------------------------------------------------------------------------- */

/* By enum board_grade. */
static const struct {
    const char *letter;
    const char *word;
} grade_names[] = {
    {"P", "paper"}, {"D", "driver"}, {"S", "sheet"}, {"I", "inferred"}, {"A", "assumed"},
};

static const char *const profile_names[BOARD_PROFILES] = {"1987", "later"};

const char *board_grade_letter(enum board_grade grade) {
    return grade_names[grade].letter;
}

/* Returns a letter of ASCII in lower case, and any other character as it is. tolower() follows the
 * locale. */
static char in_lower_case(char letter) {
    return letter >= 'A' && letter <= 'Z' ? (char)(letter - 'A' + 'a') : letter;
}

/* Tells whether two words are the same, whatever the case. strcasecmp() is POSIX, not C99. */
static bool is_same_word(const char *a, const char *b) {
    while (*a != '\0' && in_lower_case(*a) == in_lower_case(*b)) {
        a++;
        b++;
    }
    return *a == '\0' && *b == '\0';
}

bool board_grade_from_text(const char *text, enum board_grade *grade) {
    for (unsigned i = 0; i < sizeof grade_names / sizeof grade_names[0]; i++) {
        if (is_same_word(text, grade_names[i].letter) || is_same_word(text, grade_names[i].word)) {
            *grade = (enum board_grade)i;
            return true;
        }
    }
    return false;
}

const char *board_profile_text(enum board_profile profile) {
    return profile_names[profile];
}

bool board_profile_from_text(const char *text, enum board_profile *profile) {
    for (unsigned i = 0; i < BOARD_PROFILES; i++) {
        if (strcmp(text, profile_names[i]) == 0) {
            *profile = (enum board_profile)i;
            return true;
        }
    }
    return false;
}
