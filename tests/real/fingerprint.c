/* SPDX-License-Identifier: MIT */
/* Prints the fingerprint of the fixed-point operations, for any compiler with any options. */

/* Built with -Ifirmware/real/fx. Exit status 1 where the fingerprint is not the one that is kept.
 */

#include "real.h"

#include "fingerprint.h"

#include <stdio.h>

int main(void) {
    uint64_t found = fingerprint_of_operations(200000);
    printf("%08lX%08lX\n", (unsigned long)(found >> 32), (unsigned long)(found & 0xFFFFFFFF));
    return found == FINGERPRINT_OF_FX ? 0 : 1;
}
