/* SPDX-License-Identifier: MIT */
/* Expected writes against those that were made, without any test library. */
#ifndef SUPERFRAME_TESTKIT_MATCH_H
#define SUPERFRAME_TESTKIT_MATCH_H

#include "testing.h"

enum { MATCH_REPORT_SIZE = 2048, KIT_REPORT_SIZE = 160 };

/* True if every access has reached the board and is remembered; else nothing holds of it, and
 * report says why. */
bool kit_is_whole(const struct superframe_kit *kit, char *report);

/* True if the writes since the mark are as expected says, by order or in any order: testing.h has
 * the rules. False: report says where they part, what was expected and what was found; or which
 * line of `expected` can't be read. */
bool match_writes(const struct superframe_kit *kit, const char *expected, char *report);
bool match_writes_any_order(const struct superframe_kit *kit, const char *expected, char *report);

#endif
