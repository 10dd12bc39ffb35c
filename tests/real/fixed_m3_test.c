/* SPDX-License-Identifier: MIT */
/* fx for a Cortex-M3 gives the bits that fx gives. */

/* It names its arithmetic itself, whatever the include path says. */
#include "real/fx_m3/real.h"

#include "fixed_variant.h"

int main(void) {
    return run_fixed_variant();
}
