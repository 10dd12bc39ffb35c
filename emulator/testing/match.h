/* SPDX-License-Identifier: MIT */
/* Expected writes against those that were made, without any test library. */
#ifndef SUPERFRAME_TESTKIT_MATCH_H
#define SUPERFRAME_TESTKIT_MATCH_H

#include "testing.h"

enum { MATCH_REPORT_SIZE = 2048, KIT_REPORT_SIZE = 160 };

/* Tells whether every access has reached the board and is remembered. If not, no assertion holds,
 * and report says why. */
bool kit_is_whole(const struct superframe_kit *kit, char *report);

/* Tells whether the writes since the mark are as expected says, in order or in any order. testing.h
 * has the rules. On false, report says where the writes differ, what was expected and what was
 * found. Or report says which line of `expected` can't be read. */
bool match_writes(const struct superframe_kit *kit, const char *expected, char *report);
bool match_writes_any_order(const struct superframe_kit *kit, const char *expected, char *report);

#endif
