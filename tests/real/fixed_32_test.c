/* SPDX-License-Identifier: MIT */
/* fx for CPUs of 32 bits gives the bits that fx gives. */

/* It names its arithmetic itself, whatever the include path says. */
#include "real/fx_32/real.h"

#include "fixed_variant.h"

int main(void) {
    return run_fixed_variant();
}
