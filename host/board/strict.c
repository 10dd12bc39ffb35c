/* SPDX-License-Identifier: MIT */
/* The strict check. */
#include "board/strict.h"

#include <inttypes.h>

#include "base/complain.h"

bool strict_minds(const struct board *board, enum board_behaviour behaviour, bool has_grade,
                  enum board_grade grade) {
    enum board_profile profile = board->desc.profile;
    return board_behaviour_is_violation(behaviour, profile) ||
           (has_grade && board_behaviour_grade(behaviour, profile) >= grade);
}

bool strict_holds(const struct board *board, bool has_grade, enum board_grade grade) {
    enum board_profile profile = board->desc.profile;
    bool holds = true;
    for (int i = 0; i < BOARD_BEHAVIOURS; i++) {
        enum board_behaviour behaviour = (enum board_behaviour)i;
        const struct board_note *note = &board->notes[i];
        if (note->count == 0 || !strict_minds(board, behaviour, has_grade, grade)) {
            continue;
        }
        complain("%s: %s (grade %s): %" PRIu64 " times, first at access %" PRIu64,
                 board_behaviour_is_violation(behaviour, profile) ? "violation" : "relied on",
                 board_behaviour_text(behaviour),
                 board_grade_letter(board_behaviour_grade(behaviour, profile)), note->count,
                 note->first);
        holds = false;
    }
    return holds;
}
