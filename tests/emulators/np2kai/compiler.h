/* SPDX-License-Identifier: MIT */
/* What the glue uses of NP2kai, written for the tests: types. The other headers of this folder have
 * the rest under NP2kai's names. */
#ifndef SUPERFRAME_TESTS_NP2KAI_COMPILER_H
#define SUPERFRAME_TESTS_NP2KAI_COMPILER_H

#include <stdint.h>

typedef unsigned UINT;
typedef unsigned REG8, REG16;
typedef uint8_t UINT8;
typedef uint16_t UINT16;
typedef uint32_t UINT32;
typedef int BOOL, BRESULT;
typedef char OEMCHAR;

enum { FALSE, TRUE };

#endif
